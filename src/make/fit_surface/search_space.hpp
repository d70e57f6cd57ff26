#pragma once

#include <span>
#include <vector>

#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// The directions of a grid.
enum class Way { x, y };

constexpr Way across(Way way) { return way == Way::x ? Way::y : Way::x; }

/// What a search for knot lines works on: a full grid's weighted heights, once as they are and once
/// by orthonormal coordinates of the functions of x and of those of y that it may use.
class SearchSpace {
public:
    virtual ~SearchSpace() = default;

    /// The heights by both coordinates, those of x slowest.
    virtual const std::vector<double>& heights() const = 0;
    /// How many coordinates functions of this direction have.
    virtual std::size_t size(Way way) const = 0;
    virtual std::span<const double> lines(Way way) const = 0;

    /// The coordinates of spline `function`.
    virtual std::vector<double> coordinates(Way way, const BSplineBasis& basis,
                                            std::size_t function) const = 0;
    /// A function, given by its coordinates, at the lines, times their weights.
    virtual std::vector<double> at_lines(Way way, std::span<const double> function) const = 0;
    /// What the heights are to a function: at the lines across, and by the coordinates across.
    struct Image {
        std::vector<double> lines, coordinates;
    };
    virtual Image image(Way way, std::span<const double> function) const = 0;

    /// Whether it holds all splines with this break.
    virtual bool has_break(Way way, double t) const = 0;
    /// delta2 of the best that it holds.
    virtual double least_delta2() const = 0;
    /// Whether the coordinates are the nodes, so that residuals can be counted.
    virtual bool is_of_nodes() const = 0;
    /// The coefficients over breaks that it has; of nodes it reads them.
    virtual Solution solution(const Axis& x, const Axis& y) const = 0;
};

}  // namespace batten::surface_fitting
