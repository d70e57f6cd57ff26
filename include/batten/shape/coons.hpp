#pragma once

#include <array>

#include "batten/shape/curve.hpp"

namespace batten {

/// A point of a surface and its derivatives by the parameters u and v.
struct SurfaceJet {
    std::array<double, 3> point{}, u{}, v{}, uu{}, uv{}, vv{};
};

/// The bilinear Coons patch of four boundary curves over the unit square:
///     S = (1 - v) c0(u) + v c1(u) + (1 - u) d0(v) + u d1(v) - the bilinear patch of the corners.
///
/// Plane curves lie in z = 0; each runs over its own domain, mapped to [0, 1]. All derivatives are
/// analytic. Translated edges c1 = c0 + w with straight d0, d1 make a cylinder, of Gaussian
/// curvature 0; other edges in general do not.
/// Cost: four curve evaluations a point. Source: [Coons1967], [MiuraYoshidaSaito, section 5.4].
class CoonsPatch {
public:
    /// c0, c1 along u at v = 0 and 1; d0, d1 along v at u = 0 and 1. Throws `curve.dimension`
    /// unless all lie in the plane or in space, `coons.corners` where two ends that make a corner
    /// are further apart than 1e-6 of the extent.
    CoonsPatch(Curve c0, Curve c1, Curve d0, Curve d1);

    SurfaceJet jet(double u, double v) const;

private:
    std::array<Curve, 4> edges_;
    std::array<std::array<double, 3>, 4> corners_;  ///< 00, 10, 01, 11
};

}  // namespace batten
