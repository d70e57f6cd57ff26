#pragma once

#include <array>
#include <functional>
#include <optional>

#include "batten/base/interval.hpp"
#include "batten/shape/coons.hpp"

namespace batten {

/// How a surface bends at a point. The mean curvature is positive where the surface bends to the
/// side of its normal, which is that of S_u x S_v.
struct SurfaceBend {
    std::array<double, 3> normal{};
    double gaussian = 0;
    double mean = 0;
};

/// Nothing where S_u and S_v are parallel, or a result is beyond a double.
/// Accuracy: a few ulps of the second derivatives over the first ones squared.
std::optional<SurfaceBend> surface_bend(const SurfaceJet& jet);

/// Where somebody stands, and the lamps he sees mirrored: tubes around an axis.
struct ZebraView {
    std::array<double, 3> eye{0, 0, 10};
    std::array<double, 3> axis{0, 0, 1};
    int stripes = 12;  ///< dark ones around the axis
};

/// The direction, around the axis, of the ray from the eye mirrored by the surface: in (-pi, pi].
/// One order of smoothness is lost: tangent joints show as kinks, curvature joints as smooth
/// stripes. Nothing where no normal exists.
std::optional<double> zebra_angle(const SurfaceJet& jet, const ZebraView& view);

/// Whether a mirrored ray in this direction meets a dark stripe: floor(angle stripes / pi) is odd.
bool is_dark(double angle, int stripes);

/// The least and the largest Gaussian curvature on a grid of `count` x `count` points.
Interval gaussian_range(const CoonsPatch& patch, int count = 65);

}  // namespace batten
