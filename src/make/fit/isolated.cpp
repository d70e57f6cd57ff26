#include "make/fit/isolated.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::fitting {
namespace {

constexpr double least_sigmas = 10;    // no sample of a normal error is there
constexpr double least_contrast = 5;   // against how far neighbours are off each other's lines
constexpr double sigma_of_median = 1.4826;  // of a normal error [Huber1981]

/// How far sample b is off the line through a and c, as one error of that combination.
double off_line(const Samples& samples, std::size_t a, std::size_t b, std::size_t c) {
    const std::span<const double> x = samples.x, y = samples.sides[0];
    const double width = x[c] - x[a];
    const double u = width > 0 ? (x[c] - x[b]) / width : 0.5, v = 1 - u;
    return std::fabs(u * y[a] + v * y[c] - y[b]) / std::sqrt(u * u + v * v + 1);
}

double median_off_line(const Samples& samples) {
    std::vector<double> all;
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        all.push_back(off_line(samples, i - 1, i, i + 1));
    }
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return sigma_of_median * *middle;
}

/// The largest of the same among neighbours of i, i itself left out.
double neighbours_off_line(const Samples& samples, std::size_t i) {
    const std::size_t near[6] = {i - 3, i - 2, i - 1, i + 1, i + 2, i + 3};
    double largest = 0;
    for (std::size_t k = 1; k < 5; ++k) {
        largest = std::max(largest, off_line(samples, near[k - 1], near[k], near[k + 1]));
    }
    return largest;
}

}  // namespace

std::vector<double> isolated_factors(const Samples& samples) {
    std::vector<double> factors;
    if (samples.size() < 7) return factors;
    const double common = samples.sigma_known ? 0 : median_off_line(samples);
    for (std::size_t i = 3; i + 3 < samples.size(); ++i) {
        const double off = off_line(samples, i - 1, i, i + 1);
        const double sigma = samples.sigma_known ? samples.sigma_at(i) : common;
        if (!(off > least_sigmas * sigma)) continue;
        if (!(off > least_contrast * neighbours_off_line(samples, i))) continue;
        if (factors.empty()) factors.assign(samples.size(), 1);
        factors[i] = std::numeric_limits<double>::infinity();
    }
    return factors;
}

}  // namespace batten::fitting
