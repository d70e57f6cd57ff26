#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "batten/make/fit_surface_chunks.hpp"

namespace batten::surface_fitting {

/// Throws `fit-surface.axis` unless the lines of a grid rise, `points.not-finite`.
void require_rising(std::span<const double> lines, const char* name);

/// Throws `fit-surface.sizes`, `fit.sigma` unless there are none or `count` errors above 0.
void require_errors(std::span<const double> sigma, std::size_t count, const char* name);

/// Throws what SurfaceChunk promises about columns.
void require_columns(const SurfaceColumns& columns, const BSplineBasis& y);

/// Throws what `SurfaceChunk::add` promises about rows.
void require_rows(const SurfaceRows& rows, const SurfaceColumns& columns, const BSplineBasis& x,
                  double sigma);

/// 1 / sigma, or 1.
std::vector<double> weights_of(std::span<const double> sigma, std::size_t count);

/// Noise level from mixed second differences of rows that come one after the other: blind to
/// u(x) + v(y) and to bilinear parts.
/// Source: [Immerkaer1996], for uneven grids.
class NoiseOfRows {
public:
    explicit NoiseOfRows(std::span<const double> y) : y_(y) {}

    /// The next row; x rises from row to row.
    void add(double x, std::span<const double> z);
    /// 0 where there are fewer than three rows or columns.
    double sigma() const;

private:
    std::span<const double> y_;
    std::vector<double> x_;                ///< of the last two rows
    std::vector<std::vector<double>> z_;
    double sum_ = 0;
    std::size_t count_ = 0;
};

}  // namespace batten::surface_fitting
