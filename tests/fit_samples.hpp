#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <vector>

#include "batten/make/fit.hpp"
#include "random.hpp"
#include "shared.hpp"

/// Data for the tests of fitting.
namespace batten::testing {

/// Owned samples.
struct FitTable {
    std::vector<double> x, y, sigma;

    FitSamples view() const { return {x, y, sigma}; }
    FitSamples without_sigma() const { return {x, y, {}}; }
};

/// `../shared/reference/fitting/NAME.csv`.
inline FitTable fit_table(std::string_view name) {
    const CsvTable csv = shared_csv(std::string("reference/fitting/").append(name).append(".csv"));
    return {csv.column("x"), csv.column("f"), csv.column("sigma")};
}

/// Normal deviates, the same on every platform [BoxMuller1958].
class Noise {
public:
    explicit Noise(std::uint64_t seed) : random_(seed) {}
    double uniform() { return random_.within(0x1p-60, 1); }
    double normal() {
        const double radius = std::sqrt(-2 * std::log(uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    Random random_;
};

/// The synthetic truth of the paper's Figures 2.1-2.6 as rebuilt in curve_params.json: a
/// polynomial of degree 4 and five Gauss curves on [0, 100].
inline double curve_truth(double x) {
    constexpr double poly[] = {17.74, 6.67, 18.96, 19.91, 70.87};
    constexpr double height[] = {-27.65, 32.49, 25.37, -88.41, 73.18};
    constexpr double center[] = {31.19, 34.43, 50.14, 65.22, 74.42};
    constexpr double sd[] = {3.73, 8.59, 2.31, 4.51, 4.75};
    const double u = (x - 50) / 50;
    double sum = 0;
    for (const double p : poly) sum = sum * u + p;
    for (int i = 0; i < 5; ++i) {
        const double e = (x - center[i]) / sd[i];
        sum += height[i] * std::exp(-0.5 * e * e);
    }
    return sum;
}

/// The truth at n equally spaced abscissae of [0, 100] with normal errors.
inline FitTable noisy_curve(std::size_t n, double sigma, std::uint64_t seed) {
    FitTable table;
    Noise noise(seed);
    for (std::size_t i = 0; i < n; ++i) {
        const double x = 100.0 * static_cast<double>(i) / static_cast<double>(n - 1);
        table.x.push_back(x);
        table.y.push_back(curve_truth(x) + sigma * noise.normal());
        table.sigma.push_back(sigma);
    }
    return table;
}

/// Root mean square distance to the truth over 1,001 points of [0, 100].
inline double distance_to_truth(const SplineFunction& spline) {
    double sum = 0;
    for (int i = 0; i <= 1000; ++i) {
        const double e = spline(0.1 * i) - curve_truth(0.1 * i);
        sum += e * e;
    }
    return std::sqrt(sum / 1001);
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace batten::testing
