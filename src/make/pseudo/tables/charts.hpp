#pragma once

#include <array>
#include <cstddef>

#include "num/patches.hpp"

/// Coordinates in which the least segments are smooth functions of their angles, patch by patch.
///
/// The quarter domain 0 <= theta0 <= pi, |theta1| <= theta0 is seen in seven charts. With
/// rise = 1 + theta1 / theta0 and bend = rise / theta0:
///
/// * near, far: the origin blown up twice, for r0, r1 have a pole along theta0 + theta1 = 0: there
///   r - 1 goes as theta0^3 / (theta0 + theta1). `near` has theta0 and bend, `far` 1 / bend and rise.
/// * wide: theta0 and rise, for theta0 above 1.
/// * strip: around the line bend = crease(theta0), on which two minima of J and the saddle between
///   them all but meet: r turns there within 0.004 theta0 of bend. The coordinate across is
///   stretched by sinh.
/// * node, low and high corner: J grows as 1 / distance^2 to (pi, 0), (pi, -pi) and (pi, pi). The
///   coordinates are a distance and a ratio.
namespace batten::pseudo {

enum class Chart { near, far, wide, strip, node, low_corner, high_corner };
constexpr std::size_t chart_count = 7;

constexpr double least_angle0 = 1.0 / 48;  // of `near` and `strip`; least rise of `far`
constexpr double wide_angle0 = 1;          // `near` and `far` end and `wide` begins here
constexpr double node_angle0 = 2.1;        // `strip` ends and `node` begins here
constexpr double most_bend = 2;            // of `near`
constexpr double strip_half_width = 0.1;   // in bend
constexpr double corner_size = 0.8;
constexpr double least_distance = 1.0 / 64;  // to a node

/// A pair of angles in a chart.
struct ChartPoint {
    Chart chart;
    double x, y;
};
struct AnglePair {
    double theta0, theta1;
};

patches::Box box_of(Chart chart);

/// The chart and the coordinates of a pair in the quarter domain, theta0 > 0. The coordinates lie
/// outside the box where theta0 is too small for `near`, `strip` and `far`, or a node is too near.
ChartPoint chart_point(const AnglePair& angles);
AnglePair angles_at(const ChartPoint& point);

/// J as what is tabulated: a smooth function of the coordinates of order 1. And back.
double packed_energy(const ChartPoint& point, const AnglePair& angles, double pseudo_energy);
double unpacked_energy(const ChartPoint& point, const AnglePair& angles, double packed);

}  // namespace batten::pseudo
