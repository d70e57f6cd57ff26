#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "batten/base/progress.hpp"
#include "batten/make/fit_statistics.hpp"
#include "batten/make/fit_surface.hpp"

namespace batten {

/// What all rows of a grid have in common: the lines y[s], strictly rising, and their errors (empty:
/// 1). The error of node (r, s) is the product of its row's and its column's.
struct SurfaceColumns {
    std::vector<double> y;
    std::vector<double> y_sigma = {};
};

/// Some whole rows of a grid: z[r * columns + s] at (x[r], y[s]), x strictly rising.
struct SurfaceRows {
    std::span<const double> x;
    std::span<const double> z;
    std::span<const double> x_sigma = {};  ///< one standard deviation a row; empty: 1
};

/// Rows of a grid reduced to what a tensor-product spline over given knots needs to know of them.
/// Blocks of a grid too large for the memory, or on many machines, are reduced one by one and
/// merged.
///
/// Every row is fitted in y by itself; the coefficients are then fitted in x by a QR a strip, so
/// that delta2 is a sum of squares and nothing cancels.
///
/// Laws:   (1) merging in any order and grouping gives the same fit to rounding
///         (2) blocks of any size give the fit of `fit_surface` with these knots, to rounding
/// Memory: per strip in x that has rows, (degree + 1) rows of coefficients in y, whatever the data.
/// Cost:   three passes over a block in the cache, degree operations a node each.
class SurfaceChunk {
public:
    /// Throws `fit-surface.axis` for lines that do not rise within the domain of `y_basis`,
    /// `points.not-finite`, `fit-surface.sizes`, `fit.sigma`, `fit.outside`.
    SurfaceChunk(BSplineBasis x_basis, BSplineBasis y_basis, SurfaceColumns columns);

    /// Takes in rows of measurements; their errors are also times `sigma`. Nothing is taken in
    /// where it throws: as the constructor of x, `fit.outside` for an x out of the domain, and
    /// `points.not-finite` for heights: rows are whole.
    void add(const SurfaceRows& rows, double sigma = 1);
    /// Takes in what another chunk with the same knots and columns has seen; throws
    /// `fit.chunks-differ` where they are not the same.
    void merge(const SurfaceChunk& other);

    std::size_t samples() const { return samples_; }

    /// The fit. The report's psi and max_residual stay empty: they need the rows once more, see
    /// `SurfaceResiduals`; separability and oscillation are those on 65 even rows. Throws
    /// `fit.too-few` for fewer nodes than coefficients, `number.overflow`.
    SurfaceFit solve() const;

private:
    struct Frame;
    struct Strip {
        std::vector<double> triangle;  ///< order rows of order + y functions; empty: no rows yet
        std::vector<double> places;    ///< up to order + 2 distinct x
    };
    void absorb(std::size_t strip, std::vector<double>& rows);
    double largest() const;
    std::vector<int> open_x() const;

    std::shared_ptr<const Frame> frame_;  ///< knots and columns, shared by copies
    std::vector<Strip> strips_;           ///< in x
    double left_sq_ = 0;  ///< what no coefficients can reach
    std::size_t samples_ = 0;
};

/// What a surface leaves of rows that come in blocks.
///
/// Law: blocks of any size, merged in any order, give the same psi exactly, delta2 to rounding.
class SurfaceResiduals {
public:
    /// Throws what SurfaceChunk throws about the columns.
    SurfaceResiduals(const SplineSurface& surface, SurfaceColumns columns);

    /// Heights may be missing (NaN). Throws what `SurfaceChunk::add` throws.
    void add(const SurfaceRows& rows, double sigma = 1);
    /// Takes in what another one of the same surface has seen.
    void merge(const SurfaceResiduals& other);

    /// delta2, psi, the largest residual and all that follows from them, by the report's own
    /// `sigma_source`.
    void fill(FitSurfaceReport& report) const;

private:
    struct Frame;

    std::shared_ptr<const Frame> frame_;
    double delta2_ = 0, largest_ = 0;
    std::array<double, psi_count> within_{};  ///< how many lie within 1, 2, ... sigma
    std::size_t samples_ = 0, missing_ = 0;
};

/// A grid whose heights are read row by row, as often as they are needed.
struct SurfaceStream {
    std::span<const double> x;
    std::span<const double> y;
    /// Fills z with whole rows, from row `first` on; NaN where a height is missing.
    std::function<void(std::size_t first, std::span<double> z)> read;
    std::span<const double> x_sigma = {};
    std::span<const double> y_sigma = {};
    std::size_t rows_at_once = 0;  ///< how many are asked for; 0: about 8 MB of them
};

/// `fit_surface` of a grid that memory does not hold: the rows are read twice, and twice more where
/// nodes are missing. Knot lines are given, equal with `intervals`, or automatic, by the projected rule, until a
/// criterion, chi2 or delta2 decides. Their search works on the products with the splines over 128
/// x 128 strips; where it comes to finer ones the rows are read once more. Of fewer than 50,000
/// nodes all are held, and all is possible.
///
/// Law:    the lines are those of the grid in memory, the coefficients the same to rounding.
/// Memory: two blocks of rows; for a search, of every line what 131 doubles hold, or of finer
///         strips as many as there are splines. Where nodes are missing, also order^2 numbers a
///         coefficient, and for a search degree + 2 times as many of every line.
/// Throws what `fit_surface` throws; `fit-surface.streamed` for what needs all heights at once.
SurfaceFit fit_surface(const SurfaceStream& stream, const FitSurfaceOptions& options,
                       const Progress& progress = {});

}  // namespace batten
