#pragma once

#include <vector>

#include "batten/make/motion.hpp"

namespace batten::sampling {

/// The limit that speed and curvature set to q = v^2 along a curve.
class SpeedLimit {
public:
    SpeedLimit(const Curve& curve, const ArcLengthMap& map, const MotionLimits& limits);

    double length() const { return map_.length(); }
    double tangential() const { return limits_.tangential; }

    /// A place where the limit changes its kind: where two pieces or cells meet, where it has an
    /// extremum, where it is as steep as 2 tangential, where the curvature takes over from the
    /// speed. Between two of them it is monotone, and everywhere or nowhere steeper than that.
    struct Place {
        double t = 0, s = 0;
        double q = 0;  ///< the lower of its two sides
    };
    std::vector<Place> places() const;

    /// Inner joints where the direction jumps by more than `sharp`: the limit is 0 there.
    std::size_t corners() const;
    /// Radians: smaller turns are the rounding of files.
    static constexpr double sharp = 1e-3;

    /// The limit at s, as a place of the piece that also holds `inside` (a parameter).
    double at(double s, double inside) const { return at_parameter(map_.t_of(s), inside); }
    /// int ds / sqrt(q) along the limit.
    double time(double from, double to, double inside) const;

private:
    struct Bend {
        double kappa = 0, slope = 0;  ///< |kappa| and its derivative by s
    };
    Bend bend_at(double t, double inside) const;
    double at_parameter(double t, double inside) const;
    bool is_corner(double t, double before, double after) const;
    void add_changes(Interval cell, std::vector<double>& t) const;

    Curve curve_;
    ArcLengthMap map_;
    MotionLimits limits_;
};

}  // namespace batten::sampling
