#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/make/densify.hpp"
#include "make/densify/windows.hpp"

/// The curve of moving Lagrange windows, cell by cell.
namespace batten::lagrange {

/// Makes the cells of one set of points: P + s (Q - P) - s (1 - s) g(s), s = 0 ... 1.
class CellMaker {
public:
    /// Borrows `points`. Throws what `densify` throws about counts, parameters and degrees.
    CellMaker(PointsView points, const DensifyOptions& options);

    std::size_t cells() const { return static_cast<std::size_t>(windows_.cells()); }
    /// Power coefficients of g a cell has room for; unused ones are 0.
    std::size_t terms() const { return terms_; }
    std::size_t dim() const { return static_cast<std::size_t>(points_.dim()); }
    double parameter(std::ptrdiff_t point) const;
    const double* start(std::size_t cell) const { return at(static_cast<std::ptrdiff_t>(cell)); }
    const double* end(std::size_t cell) const { return at(static_cast<std::ptrdiff_t>(cell) + 1); }

    /// Writes terms() x dim() coefficients of g. False where the cell strayed and was tamed.
    /// Throws `points.not-finite`, `points.repeated` where an end of the cell is the offender, and
    /// `number.overflow`.
    bool make(std::size_t cell, std::span<double> g) const;

    /// The cells [first, last) whose points are laid out alike, in a row, and use all terms.
    struct Uniform {
        std::size_t first = 0, last = 0;
        Recipe recipe;
    };
    const Uniform& uniform() const { return uniform_; }

private:
    const double* at(std::ptrdiff_t point) const;
    void require_sound(const DensifyOptions& options) const;
    void set_uniform();
    Recipe recipe(std::size_t cell, Window window) const;
    Recipe recipe_by_length(std::size_t cell, Window window, LagrangeParameter parameter) const;
    void apply(const Recipe& recipe, std::size_t cell, std::span<double> g) const;
    /// With the parameters asked for, or with others for this cell alone.
    void make_with(std::size_t cell, const LagrangeParameter* others, std::span<double> g) const;
    bool is_tame(std::size_t cell, std::span<const double> g) const;
    void tame(std::size_t cell, std::span<double> g) const;
    void require_sound_ends(std::size_t cell) const;
    void require_finite_curve(std::size_t cell, std::span<const double> g) const;

    PointsView points_;
    Windows windows_;
    std::vector<double> parameters_;  ///< none for the index
    bool blend_, tames_;
    std::size_t terms_;
    Uniform uniform_;
};

}  // namespace batten::lagrange
