#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "batten/shape/curve.hpp"
#include "make/arcs/biarc.hpp"

/// Places, directions and distances on a curve of the plane.
namespace batten::arc_spline {

enum class Side { before, after };

/// The point at t and the unit direction in which the curve passes it, on this side of t: the
/// first derivative that does not vanish beside the others over the length of the piece.
Station station(const Curve& curve, double t, Side side);

/// Parameters spread over `part`, 24 or more and at least 4 in each piece, piece by piece.
struct Place {
    std::size_t piece = 0;
    double t = 0;
};
std::vector<Place> places(const Curve& curve, Interval part);

/// How far a part of a curve is from arcs in a row that stand for it.
///
/// Measured from the curve to the arcs at the `places` of the part, then by a search where it is
/// largest among them.
class CurveDistance {
public:
    CurveDistance(const Curve& curve, const Moves& moves) : curve_(curve), ruler_(moves) {}

    /// The largest distance of `part`, arc by arc. Nothing where the places nearest to the part
    /// fall back on the arcs by more than 4 tolerances, or run ahead by more than pi/2 times the
    /// part's own steps and 4 tolerances: so no loop of the one is lost in the other.
    std::optional<std::array<double, 2>> largest(Interval part, double tolerance) const;

private:
    struct Sample {
        Place place;
        plane::Vector point;
        RowFoot nearest;

        double distance() const { return nearest.foot.distance; }
    };
    Sample sample(Place place) const;
    bool is_in_order(const std::vector<Sample>& all, double tolerance) const;
    double refined(const Sample& before, const Sample& here, const Sample& after) const;

    const Curve& curve_;
    RowRuler ruler_;
};

}  // namespace batten::arc_spline
