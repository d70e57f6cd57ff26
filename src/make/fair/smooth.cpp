#include "make/fair/smooth.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "num/band_givens.hpp"

namespace batten::fairing {
namespace {

constexpr double binomials[] = {1, -4, 6, -4, 1};
constexpr std::size_t window = 6;

template <std::size_t Border>
Track smoothed_with(const Track& data, double mu, std::size_t held_ends) {
    const std::size_t n = data.size();
    num::BandGivens<Border, 2> system;
    system.restart(n);
    const auto is_held = [&](std::size_t i) {
        return !data.closed && (i < held_ends || i + held_ends >= n);
    };
    for (std::size_t i = 0; i < n; ++i) system.set_weight(i, 1, {data.x[i], data.y[i]});
    const double root = std::sqrt(mu);
    const auto add = [&](std::size_t i, std::size_t first) {
        typename num::BandGivens<Border, 2>::Row row{};
        for (std::size_t k = 0; k < 5; ++k) {
            const std::size_t j = (i + n + k - 2) % n;
            const double c = root * binomials[k];
            if (is_held(j)) {
                row[5 + Border] -= c * data.x[j];
                row[6 + Border] -= c * data.y[j];
            } else if (j < system.columns()) {
                row[j - first] = c;
            } else {
                row[5 + (j - system.columns())] = c;
            }
        }
        system.add(first, row);
    };
    if (Border > 0) {
        for (const std::size_t i : {n - 2, n - 1, std::size_t{0}, std::size_t{1}}) add(i, 0);
    }
    for (std::size_t i = 2; i + 2 < n; ++i) add(i, i - 2);
    Track result{std::vector<double>(n), std::vector<double>(n), data.closed};
    system.solve(0, result.x.data());
    system.solve(1, result.y.data());
    return result;
}

double squared_distance(const Track& a, const Track& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a.x[i] - b.x[i]) * (a.x[i] - b.x[i]) + (a.y[i] - b.y[i]) * (a.y[i] - b.y[i]);
    }
    return sum;
}

/// The trace of the smoother: how many parameters it leaves free.
double freedom(std::size_t n, double mu, bool closed) {
    double sum = closed ? 1 : 4;
    const double unit = std::numbers::pi / static_cast<double>(n);
    for (std::size_t j = closed ? 1 : 4; j < n; ++j) {
        // Rings: pairs of waves 2 pi k / n.
        const double wave = closed ? 2 * unit * static_cast<double>((j + 1) / 2)
                                   : unit * (static_cast<double>(j) - 1.5);
        const double difference = 2 * std::sin(0.5 * std::fmin(wave, std::numbers::pi));
        sum += 1 / (1 + mu * std::pow(difference, 8));
    }
    return sum;
}

/// The squares left by a cubic over the chord of six points from `first`: two degrees of freedom.
double scatter(const Track& t, std::size_t first) {
    const std::size_t n = t.size(), last = (first + window - 1) % n;
    const double cx = t.x[last] - t.x[first], cy = t.y[last] - t.y[first];
    const double length = std::hypot(cx, cy);
    if (length == 0) return 0;
    std::array<double, window> along, across;
    for (std::size_t k = 0; k < window; ++k) {
        const std::size_t i = (first + k) % n;
        const double dx = t.x[i] - t.x[first], dy = t.y[i] - t.y[first];
        along[k] = 2 * (cx * dx + cy * dy) / (length * length) - 1;
        across[k] = (cx * dy - cy * dx) / length;
    }
    // Powers of the abscissa made orthogonal one after another, each taken out of the ordinates.
    std::array<std::array<double, window>, 4> basis;
    for (std::size_t p = 0; p < 4; ++p) {
        double size = 0;
        for (std::size_t k = 0; k < window; ++k) basis[p][k] = p == 0 ? 1 : basis[p - 1][k] * along[k];
        for (std::size_t q = 0; q < p; ++q) {
            double dot = 0;
            for (std::size_t k = 0; k < window; ++k) dot += basis[p][k] * basis[q][k];
            for (std::size_t k = 0; k < window; ++k) basis[p][k] -= dot * basis[q][k];
        }
        for (const double b : basis[p]) size += b * b;
        if (size == 0) continue;
        double dot = 0;
        for (double& b : basis[p]) b /= std::sqrt(size);
        for (std::size_t k = 0; k < window; ++k) dot += basis[p][k] * across[k];
        for (std::size_t k = 0; k < window; ++k) across[k] -= dot * basis[p][k];
    }
    double sum = 0;
    for (const double r : across) sum += r * r;
    return sum;
}

}  // namespace

double noise_of(const Track& t) {
    std::vector<double> squares;
    const std::size_t n = t.size();
    for (std::size_t i = 0; n >= window && i + (t.closed ? 1 : window) <= n; ++i) {
        squares.push_back(scatter(t, i));
    }
    if (squares.empty()) return 0;
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    return std::sqrt(*middle / (2 * std::numbers::ln2));  // the median of chi-square of 2 is 2 ln 2
}

Track smoothed(const Track& data, double mu, std::size_t held_ends) {
    return data.closed ? smoothed_with<4>(data, mu, held_ends)
                       : smoothed_with<0>(data, mu, held_ends);
}

double cross_validated(const Track& data, std::size_t held_ends) {
    const double n = static_cast<double>(data.size());
    const double largest = std::pow(n / 6, 8);
    double best_mu = 0, best_score = -1;
    for (double mu = 1e-2; mu <= largest; mu *= 10) {
        const double left = 1 - freedom(data.size(), mu, data.closed) / n;
        const double score =
            squared_distance(data, smoothed(data, mu, held_ends)) / (left * left);
        if (best_score >= 0 && !(score < best_score)) {
            if (score > 4 * best_score) break;
            continue;
        }
        best_score = score;
        best_mu = mu;
    }
    return best_mu;
}

}  // namespace batten::fairing
