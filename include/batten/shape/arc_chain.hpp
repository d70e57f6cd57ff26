#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/base/points.hpp"

namespace batten {

/// A circular arc, or a straight line, from one point of the plane to another.
///
/// `bulge` is the tangent of a quarter of the sweep: positive where the arc turns left, 0 for a
/// line, 1 for half a circle to the left, beyond 1 for more than half a circle. A whole circle
/// needs two arcs.
struct Arc {
    std::array<double, 2> start{};
    std::array<double, 2> end{};
    double bulge = 0;

    bool is_line() const { return bulge == 0; }
    /// Signed angle in radians, positive to the left, |sweep| < 2 pi.
    double sweep() const;
    /// Signed: 1 / radius, positive to the left, 0 for a line.
    double curvature() const;
    double length() const;
    /// Nothing for a line.
    std::optional<double> radius() const;
    std::optional<std::array<double, 2>> center() const;
    /// Unit vectors.
    std::array<double, 2> start_tangent() const;
    std::array<double, 2> end_tangent() const;

    bool operator==(const Arc&) const = default;
};

/// Arcs and lines in the plane, one after the other: a curve whose parameter is its arc length.
///
/// Stored as joints and bulges, so neighbours share their joint bit for bit. Nothing says that
/// the tangents of neighbours agree: that is for whoever makes the chain.
///
/// Laws: points x 2^k give breaks x 2^k and the same bulges, exactly.
/// Accuracy of a point: 4 ulps of its arc's longest coordinate and chord (more for arcs that come
/// close to a whole circle: their chord is short).
/// Immutable; an invalid one cannot exist.
class ArcChain {
public:
    /// `joints`: n + 1 rows of 2; `bulges`: n numbers. A closed chain ends, bit for bit, where it
    /// starts.
    ///
    /// Throws `points.dimension`, `points.too-few`, `points.not-finite`, `points.repeated`;
    /// `curve.arcs` where the number of bulges is not n, one is not finite, an arc is too short
    /// beside the whole chain to have a length of its own or its radius is beyond a double, or a
    /// closed chain is open.
    ArcChain(Points joints, std::vector<double> bulges, bool closed = false);

    const Points& joints() const { return joints_; }
    std::span<const double> bulges() const { return bulges_; }
    std::size_t arcs() const { return bulges_.size(); }
    Arc arc(std::size_t i) const;

    int dim() const { return 2; }
    /// The arc length at each joint, from 0.
    std::span<const double> breaks() const { return breaks_; }
    bool is_closed() const { return closed_; }
    /// 1 where all arcs are lines.
    std::optional<int> degree() const;
    /// Value and derivatives by arc length on one arc; see `CurveShape`.
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    bool operator==(const ArcChain&) const = default;

private:
    Points joints_;
    std::vector<double> bulges_;
    std::vector<double> breaks_;
    bool closed_;
};

/// The part of a chain over these arc lengths, as a chain of its own from 0, not closed. Joints
/// and bulges of whole arcs stay as they are. Throws `curve.outside`, `curve.part-empty`, and
/// `curve.arcs` where the part is too short to have a length.
ArcChain trimmed(const ArcChain& chain, Interval part);

/// The same points in the opposite direction: the same joints, the bulges negated.
ArcChain reversed(const ArcChain& chain);

/// All joints times `factor`: the bulges stay. Throws `curve.scale` unless it is finite and not 0,
/// and what the constructor throws.
ArcChain scaled(const ArcChain& chain, double factor);

}  // namespace batten
