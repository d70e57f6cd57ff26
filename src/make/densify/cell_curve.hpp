#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"
#include "make/densify/cells.hpp"

namespace batten::lagrange {

/// Of one coordinate of a cell, in powers: room for any degree, and a blend's one more.
inline constexpr std::size_t most_coefficients = highest_degree + 2;

/// The cells of one interpolation, kept: a curve of polynomial pieces of any degree.
class CellCurve {
public:
    explicit CellCurve(const CellMaker& maker, bool closed);

    std::size_t cells() const { return breaks_.size() - 1; }
    const std::vector<std::size_t>& tamed() const { return tamed_; }
    std::size_t terms() const { return terms_; }
    const double* start(std::size_t cell) const { return row(joints_, cell); }
    const double* end(std::size_t cell) const { return row(joints_, cell + 1); }
    const double* bubble(std::size_t cell) const { return g_.data() + cell * terms_ * width(); }

    /// The point at s = 0 ... 1 of a cell.
    void point(std::size_t cell, double s, std::span<double> out) const;
    /// Power coefficients in s of one coordinate: terms() + 2 of them, at least 2.
    void power(std::size_t cell, int coordinate, std::span<double> out) const;
    /// An upper bound of |d^2 f / ds^2| over a cell: the largest value itself up to degree 3.
    double second_derivative_bound(std::size_t cell) const;
    /// df/ds at the cell's ends.
    void start_slope(std::size_t cell, std::span<double> out) const;
    void end_slope(std::size_t cell, std::span<double> out) const;

    int dim() const { return joints_.dim(); }
    std::span<const double> breaks() const { return breaks_; }
    bool is_closed() const { return closed_; }
    std::optional<int> degree() const { return static_cast<int>(terms_) + 1; }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

private:
    std::size_t width() const { return static_cast<std::size_t>(joints_.dim()); }
    static const double* row(const Points& points, std::size_t i) {
        return points.view()[i].data();
    }

    Points joints_;
    std::vector<double> breaks_;
    std::vector<double> g_;
    std::vector<std::size_t> tamed_;
    std::size_t terms_;
    bool closed_;
};

/// As a curve for everybody: a PiecewiseCubic up to degree 3. Throws `number.overflow` where a
/// coefficient is beyond a double.
Curve as_curve(const CellCurve& cells);

}  // namespace batten::lagrange
