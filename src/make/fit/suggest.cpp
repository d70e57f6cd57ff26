#include <algorithm>
#include <cmath>

#include "make/fit/covariance.hpp"
#include "num/gauss.hpp"

namespace batten {
namespace {

constexpr int candidates_per_piece = 8;

/// One measurement already suggested: it changes (R^T R)^-1 by - v v^T / weight.
struct Chosen {
    std::vector<double> v;
    double weight = 0;
};

/// (R^T R)^-1 a after the measurements chosen so far.
std::vector<double> applied(const fitting::CoefficientLaw& law, const std::vector<double>& a,
                            const std::vector<Chosen>& chosen) {
    std::vector<double> x = law.apply(a);
    for (const Chosen& c : chosen) {
        double product = 0;
        for (std::size_t l = 0; l < a.size(); ++l) product += c.v[l] * a[l];
        for (std::size_t l = 0; l < a.size(); ++l) x[l] -= c.v[l] * (product / c.weight);
    }
    return x;
}

/// The integral of the square of the spline whose unknowns are `v`.
double squared_norm(const fitting::CoefficientLaw& law, const std::vector<double>& v) {
    const SplineFunction& s = law.spline();
    const num::GaussRule rule = num::gauss_legendre(s.degree() + 1);
    double sum = 0;
    for (std::size_t i = 0; i < s.pieces(); ++i) {
        const Interval piece{s.breaks()[i], s.breaks()[i + 1]};
        sum += num::integrate(
            [&](double x) {
                const auto f = law.functions_at(x, 0);
                double value = 0;
                for (std::size_t j = 0; j < f.values.size(); ++j) {
                    value += f.values[j] * v[law.unknown(f.first + static_cast<int>(j))];
                }
                return value * value;
            },
            piece, rule);
    }
    return sum;
}

}  // namespace

std::vector<double> FitCovariance::suggest(int count, double sigma) const {
    const fitting::CoefficientLaw& law = model_->own;
    const SplineFunction& s = law.spline();
    std::vector<Chosen> chosen;
    std::vector<double> result;
    const double variance = sigma / scale() * (sigma / scale());
    while (static_cast<int>(result.size()) < count) {
        double best_gain = -1, best_x = s.domain().lo;
        Chosen best;
        for (std::size_t i = 0; i < s.pieces(); ++i) {
            const bool is_last = i + 1 == s.pieces();
            for (int q = 0; q < candidates_per_piece + is_last; ++q) {
                const double x = s.breaks()[i] + (s.breaks()[i + 1] - s.breaks()[i]) *
                                                     (q / double{candidates_per_piece});
                const std::vector<double> a = law.spread(law.functions_at(x, 0));
                Chosen c{applied(law, a, chosen), variance};
                for (std::size_t l = 0; l < a.size(); ++l) c.weight += a[l] * c.v[l];
                const double gain = squared_norm(law, c.v) / c.weight;
                if (gain > best_gain) {
                    best_gain = gain;
                    best_x = x;
                    best = std::move(c);
                }
            }
        }
        chosen.push_back(std::move(best));
        result.push_back(best_x);
    }
    return result;
}

}  // namespace batten
