#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "batten/shape/arc_chain.hpp"
#include "shape/plane.hpp"

/// Two arcs from one point and tangent to another, and how far points are from them.
namespace batten::arc_spline {

/// A point and the unit tangent there.
struct Station {
    plane::Vector point, tangent;
};

/// One or two arcs or lines in a row.
struct Moves {
    std::array<Arc, 2> arcs;
    int count = 0;

    const Arc* begin() const { return arcs.data(); }
    const Arc* end() const { return arcs.data() + count; }
};

/// The arcs' form that everybody gets: an arc that is straight within 2^-40 of its chord, or
/// whose radius is larger than `max_radius`, becomes a line.
Arc straightened(Arc arc, double max_radius);

/// The biarc with equal tangent lengths d1 = d2 from `from` to `to`; one arc or line where one of
/// up to half a circle meets both tangents within 1e-9 rad. Nothing where no such biarc exists:
/// both tangents the same and the chord not ahead of them, or no chord.
///
/// Source: d = |v|^2 / (v.t + sqrt((v.t)^2 + 2 |v|^2 (1 - T0.T1))), v the chord, t = T0 + T1, and
/// the joint (P + Q + d (T0 - T1)) / 2 [Bolton1975].
std::optional<Moves> biarc(const Station& from, const Station& to);

/// The place on an arc that is nearest to a point.
struct Foot {
    double distance = 0;  ///< not negative
    double along = 0;     ///< arc length from the arc's start
};

/// An arc prepared for many questions about its distance.
class ArcRuler {
public:
    explicit ArcRuler(const Arc& arc);

    double length() const { return length_; }
    /// Accuracy: a few ulps of the chord for any radius; no centre is used.
    Foot foot(plane::Vector p) const;

private:
    plane::Vector start_, end_, tangent_, normal_;
    double curvature_, length_;
};

/// The nearest place on arcs in a row.
struct RowFoot {
    Foot foot;             ///< `along` counts from the row's start
    std::size_t arc = 0;
};

class RowRuler {
public:
    explicit RowRuler(const Moves& moves);
    double length() const { return length_; }
    RowFoot foot(plane::Vector p) const;

private:
    std::array<std::optional<ArcRuler>, 2> rulers_;
    double length_ = 0;
};

}  // namespace batten::arc_spline
