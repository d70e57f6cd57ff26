#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"
#include "io/draw/shapes/frame.hpp"

namespace batten::drawing {

/// A point in the plane (third coordinate 0) or in space.
using Spot = std::array<double, 3>;

inline double distance(const Spot& a, const Spot& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A curve as it is drawn, in data units.
struct Trace {
    Points beziers;            ///< 4 rows a piece, where the degree is 3 or less
    std::vector<Points> runs;  ///< else chains of chords, one for each stretch without a gap
};

/// How many chords a piece is at least given.
int least_chords(const Curve& curve);

bool is_cubic(const Curve& curve);

/// Whether all axes of a picture have one unit, or each its own.
enum class AxisUnits { common, own };

/// Chords stay near the curve as seen along the axes' units. Throws `number.overflow` where a
/// control point is beyond a double, `drawing.not-finite` where the curve is.
Trace trace_of(const Curve& curve, AxisUnits units = AxisUnits::common);

/// The point of a curve at t. Throws `drawing.not-finite`.
Spot spot_on(const Curve& curve, double t);

/// The box around a trace; exact for cubics.
Box box_of(const Trace& trace);

/// One place on a curve: `at` may be its tip of a comb or the point itself.
struct Sample {
    double t = 0;
    Spot at{};
    bool exists = true;
};

/// Samples over `part`, first and last included, so dense that the middle of each chord is within
/// `tolerance` of what `spot` gives there. Never fewer than `least` chords, never more than 1024
/// times as many.
std::vector<Sample> refined(const std::function<Sample(double)>& spot, Interval part, int least,
                            double tolerance);

}  // namespace batten::drawing
