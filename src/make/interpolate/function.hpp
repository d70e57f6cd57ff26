#pragma once

#include "batten/base/points.hpp"
#include "batten/shape/piecewise_cubic.hpp"

/// Curves (x, y(x)) that follow the shape of the data. At least two points, x strictly increasing;
/// x(t) = t, exactly.
namespace batten::interpolation {

/// Slopes are weighted harmonic means, 0 at turning points: y is monotone where the data are.
/// Laws: y x 2^k gives the result x 2^k, exactly; so does the mirror image.
/// Source: [FritschButland1984, eq. 5]; ends by three points, held monotone [Moler2004, pchiptx].
PiecewiseCubic pchip_curve(PointsView points);

/// Akima's slopes with weights that also see the size of the slopes: flat runs stay flat and
/// overshoot stays small. Laws: as above.
/// Source: [Akima1970], weights modified by [Moler2019].
PiecewiseCubic makima_curve(PointsView points);

}  // namespace batten::interpolation
