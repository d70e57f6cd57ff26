#include "make/fit/residuals.hpp"

#include <cmath>

namespace batten::fitting {

std::vector<SplineFunction> splines_of(const FixedFit& fixed, std::size_t sides) {
    std::vector<SplineFunction> result;
    for (std::size_t s = 0; s < sides; ++s) result.push_back(spline_of(fixed, static_cast<int>(s)));
    return result;
}

std::vector<double> residuals_of(const Samples& samples, std::span<const SplineFunction> splines) {
    std::vector<double> e(samples.size());
    splines[0].evaluate(samples.x, 0, e);
    for (std::size_t i = 0; i < e.size(); ++i) e[i] = samples.sides[0][i] - e[i];
    std::vector<double> next(splines.size() > 1 ? e.size() : 0);
    for (std::size_t s = 1; s < splines.size(); ++s) {
        splines[s].evaluate(samples.x, 0, next);
        for (std::size_t i = 0; i < e.size(); ++i) {
            e[i] = std::hypot(e[i], samples.sides[s][i] - next[i]);
        }
    }
    return e;
}

double delta2_of(const Samples& samples, std::span<const double> residuals) {
    double sum = 0;
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        const double e = residuals[i] / samples.sigma_at(i);
        sum += e * e;
    }
    return sum;
}

}  // namespace batten::fitting
