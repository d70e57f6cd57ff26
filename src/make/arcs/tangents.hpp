#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "shape/plane.hpp"

/// Tangents at points of the plane of which nothing else is known.
namespace batten::arc_spline {

/// The unit tangent at the middle one of three points of the circle through them. Where the third
/// is the first again: a quarter turn to the left of the first chord.
plane::Vector circle_tangent(plane::Vector before, plane::Vector here, plane::Vector after);

/// One or more directions proposed for each point.
class Tangents {
public:
    /// From the circle through each point and its neighbours `reach` places away, for each reach;
    /// at an open end from the circle through the first (last) three points so spaced. A given
    /// direction leaves its point no other. Consecutive points must differ.
    Tangents(PointsView points, std::span<const std::size_t> reaches, bool closed,
             const std::vector<FixedTangent>& given);

    std::span<const plane::Vector> operator[](std::size_t point) const {
        return {all_.data() + first_[point], first_[point + 1] - first_[point]};
    }

private:
    std::vector<plane::Vector> all_;
    std::vector<std::size_t> first_;
};

}  // namespace batten::arc_spline
