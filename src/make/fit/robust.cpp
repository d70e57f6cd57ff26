#include "make/fit/robust.hpp"

#include <cmath>
#include <limits>

namespace batten::fitting {
namespace {

constexpr double reject_at = 4;      // 1 sample of 16,000 with normal errors
constexpr double huber_at = 1.345;   // 95 % efficiency for normal errors [Huber1981]
constexpr double tukey_at = 4.685;   // the same [BeatonTukey1974]
constexpr double inf = std::numeric_limits<double>::infinity();

/// The factor of sigma for a residual of e sigmas: 1 / sqrt(weight).
double factor_of(Robust robust, double e) {
    const double size = std::fabs(e);
    switch (robust) {
        case Robust::reject: return size > reject_at ? inf : 1;
        case Robust::huber: return size > huber_at ? std::sqrt(size / huber_at) : 1;
        case Robust::tukey: {
            const double rest = 1 - (size / tukey_at) * (size / tukey_at);
            return rest > 0 ? 1 / rest : inf;
        }
        case Robust::none: break;
    }
    return 1;
}

double loss_of(Robust robust, double e) {
    const double size = std::fabs(e);
    switch (robust) {
        case Robust::reject: return size > reject_at ? reject_at * reject_at : e * e;
        case Robust::huber: return size > huber_at ? huber_at * (2 * size - huber_at) : e * e;
        case Robust::tukey: {
            const double rest = size < tukey_at ? 1 - (e / tukey_at) * (e / tukey_at) : 0;
            return tukey_at * tukey_at / 3 * (1 - rest * rest * rest);
        }
        case Robust::none: break;
    }
    return e * e;
}

}  // namespace

std::vector<double> robust_factors(Robust robust, const Samples& samples,
                                   std::span<const double> residuals) {
    std::vector<double> factors(residuals.size());
    std::size_t dropped = 0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        factors[i] = factor_of(robust, residuals[i] / samples.sigma_at(i));
        dropped += std::isinf(factors[i]);
    }
    if (robust == Robust::huber) return factors;
    const double share = static_cast<double>(dropped) / static_cast<double>(factors.size());
    if (robust == Robust::reject && share > most_rejected) factors.assign(factors.size(), 1);
    // Too far off to tell which: nearer by weights that drop none.
    if (robust == Robust::tukey && share > most_redescended) {
        return robust_factors(Robust::huber, samples, residuals);
    }
    return factors;
}

bool are_alike(std::span<const double> factors, std::span<const double> before) {
    constexpr double enough = 1e-6;
    if (factors.size() != before.size()) return false;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        // Either may be inf: then only the same is alike.
        if (factors[i] == before[i]) continue;
        if (!(std::fabs(factors[i] - before[i]) <= enough * before[i])) return false;
        if (std::isinf(before[i])) return false;
    }
    return true;
}

double robust_loss(Robust robust, const Samples& samples, std::span<const double> residuals) {
    double sum = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        sum += loss_of(robust, residuals[i] / samples.sigma_at(i));
    }
    return sum;
}

}  // namespace batten::fitting
