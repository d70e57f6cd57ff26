#pragma once

#include <optional>
#include <span>
#include <vector>

#include "batten/shape/curve.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten {

/// Whether a knot stands degree + 1 times inside the domain.
bool has_jumps(const SplineFunction& spline);

/// The graph x(t) = t, y(t) = S(t) of a spline with jumps: a curve in parts. The value at a jump is
/// that behind it; the one before is the end of the piece before.
///
/// For evaluation, integrals, crossings and pictures. What follows a curve from piece to piece (its
/// length, its nearest point, arcs near it) sees the parts and no lines between them.
class SplineGraph {
public:
    /// Throws `number.overflow` where the spline leaves the range of a double.
    explicit SplineGraph(SplineFunction spline);

    const SplineFunction& spline() const { return spline_; }
    int dim() const { return 2; }
    std::span<const double> breaks() const { return spline_.breaks(); }
    bool is_closed() const { return false; }
    std::optional<int> degree() const { return spline_.degree() > 0 ? spline_.degree() : 1; }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    bool operator==(const SplineGraph&) const = default;

private:
    SplineFunction spline_;
};

/// The graph, whether the spline has jumps or none: `graph` of it where it is a curve, lines for
/// degree 0, else a SplineGraph.
Curve graph_in_parts(const SplineFunction& spline);

/// Whether this is the graph of a spline with jumps.
bool has_jumps(const Curve& curve);

/// The curve, or the curves between its jumps.
std::vector<Curve> parts_between_jumps(const Curve& curve);

/// The spline S whose graph `curve` is: a B-spline of the plane whose first coordinate is its
/// parameter, to rounding. Nothing where it is none.
///
/// Law: spline_of_graph(graph(s)) is s, its ends clamped, bit for bit.
std::optional<SplineFunction> spline_of_graph(const Curve& curve);

}  // namespace batten
