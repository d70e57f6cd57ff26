#pragma once

#include <vector>

#include "batten/make/motion_law.hpp"
#include "batten/measure/arc_length_map.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// A curve walked by a law in `duration` units of time.
class Motion {
public:
    /// Throws `option.range` unless the duration is above 0 and finite, and what ArcLengthMap
    /// throws.
    Motion(const Curve& curve, MotionLaw law, double duration = 1);

    const Curve& curve() const { return curve_; }
    const ArcLengthMap& map() const { return map_; }
    const MotionLaw& law() const { return law_; }
    double duration() const { return duration_; }

    /// At a time in [0, duration]; before and after the motion stands at its ends.
    /// Accuracy: what the law says, and 1e-12 of the length. Cost: the law's, and 0.2 us.
    double arc_length(double time) const;
    double speed(double time) const;  ///< d arc_length / d time
    double parameter(double time) const;
    std::vector<double> position(double time) const;
    /// The speed in the direction of the curve.
    std::vector<double> velocity(double time) const;

private:
    Curve curve_;
    ArcLengthMap map_;
    MotionLaw law_;
    double duration_;
};

/// The direction in which the curve leaves t (at the end of the domain: reaches it), of length 1;
/// at a cusp too. Zero only where the curve is a single point around t.
std::vector<double> unit_tangent(const Curve& curve, double t);

/// Time is spent in proportion to what is said here; all of it multiplies. Corners and cusps take
/// no time of their own.
struct PlaceWeights {
    Points rows{2};        ///< (arc length, weight) from 0 to the length, linear between; or none
    double curvature = 0;  ///< C of the density 1 + C |kappa| by the arc length
    /// The speed falls with the third root of the curvature, as that of a hand: density
    /// max(|kappa|, 1 / length)^(1/3) [LacquanitiTerzuoloViviani1983].
    bool power = false;
};

/// Accuracy: 1e-12 of the time, 1e-7 beside cusps.
/// Throws `motion.weights` where the rows do not suit the curve or a weight is negative; for
/// `curvature` `option.range`; `motion.no-weight` where all of it is 0.
MotionLaw weighted_law(const Curve& curve, const ArcLengthMap& map, const PlaceWeights& weights);

/// The parameter grows evenly with the time.
MotionLaw parameter_law(const Curve& curve, const ArcLengthMap& map);

/// Time in proportion to int |d2r/dt2| dt, which stands for the curvature in
/// [HaradaNakamae, eq. 5]: it depends on the parameter, and stands still nowhere else than where
/// the parameter does not accelerate. Throws `motion.no-weight` for a straight line at even speed.
MotionLaw curvature_proxy_law(const Curve& curve, const ArcLengthMap& map);

/// What may not be exceeded on the way.
struct MotionLimits {
    double speed = 0;       ///< ds/dt
    double lateral = 0;     ///< v^2 |kappa|
    double tangential = 0;  ///< |dv/dt|
};

struct TimedLaw {
    MotionLaw law;
    double duration = 0;
    std::size_t corners = 0;  ///< where the walk stops on its way
};

/// The fastest walk from rest to rest within the limits, each by itself.
///
/// v^2 is the largest function that is below speed^2 and lateral / |kappa| and whose slope by s is
/// within 2 tangential: it follows one of the four, and where it changes over is found exactly. So
/// the limits hold everywhere and not only on a grid. At a corner, a turn of more than 0.001 rad
/// at once, the curvature has no bound: the walk stops there and starts again.
/// Accuracy: 1e-10 of the duration; limits to 1e-9. Cost: about 60 us a cubic.
/// Throws `option.range` unless all limits are above 0 and finite.
/// Source: [Bobrow1985], the limits of the phase plane.
TimedLaw time_optimal_law(const Curve& curve, const ArcLengthMap& map, const MotionLimits& limits);

}  // namespace batten
