#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "batten/make/fit_surface.hpp"

/// Noise level from mixed second differences: blind to u(x) + v(y) and to bilinear parts.
/// Source: [Immerkaer1996], for uneven grids.
namespace batten::surface_fitting {

/// Of rows, three at a time, from where all nine nodes of a difference are there (missing ones are
/// NaN). Nothing of fewer than three columns.
class MixedNoise {
public:
    explicit MixedNoise(std::span<const double> y);

    /// Three rows that follow each other, at these x; one behind the other in `rows`.
    void add(std::span<const double> x, std::span<const double> rows);
    /// 0 where there was nothing.
    double sigma() const;

private:
    std::vector<std::array<double, 3>> columns_;
    std::vector<double> across_, values_;
    double sum_sq_ = 0;
    std::size_t count_ = 0;
};

/// Of rows that come one by one.
class MixedNoiseOfRows {
public:
    explicit MixedNoiseOfRows(std::span<const double> y) : noise_(y) {}

    /// The next row; x rises from row to row.
    void add(double x, std::span<const double> z);
    double sigma() const { return noise_.sigma(); }

private:
    MixedNoise noise_;
    std::vector<double> x_, rows_;  ///< the last three
};

/// An estimated noise: at least an ulp of the largest height, 1 where all heights are 0.
double usable_noise(double noise, double largest);

/// How exactly heights are met, as a share of the largest: by a direct solution, by iteration.
constexpr double direct_accuracy = 8 * std::numeric_limits<double>::epsilon();
constexpr double iterated_accuracy = 1e-11;

/// The delta2 of so many samples that is no misfit but what their solution leaves.
double unavoidable_delta2(std::size_t count, double accuracy, double largest, double sigma);

/// Of a grid.
double mixed_noise(const SurfaceSamples& given);

}  // namespace batten::surface_fitting
