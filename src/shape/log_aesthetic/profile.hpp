#pragma once

#include <cmath>
#include <complex>
#include <cstddef>

#include "batten/base/interval.hpp"
#include "batten/shape/log_aesthetic.hpp"

/// One log-aesthetic arc of unit length whose start tangent is the x axis.
namespace batten::spiral {

/// expm1(z) / z, 1 at 0.
inline double expm1_share(double z) { return z == 0 ? 1 : std::expm1(z) / z; }

/// expm1(z u) / expm1(z) for 0 <= u <= 1, u at z = 0: how angle and arc length grow with u.
class Rise {
public:
    Rise() = default;
    explicit Rise(double z) : z_(z), share_(z == 0 ? 0 : 1 / std::expm1(z)) {}

    double operator()(double u) const { return z_ == 0 ? u : std::expm1(z_ * u) * share_; }
    double speed(double u) const { return z_ == 0 ? 1 : z_ * std::exp(z_ * u) * share_; }
    double exponent() const { return z_; }

private:
    double z_ = 0, share_ = 0;
};

constexpr double largest_exponent = 600;  ///< e^600 and its inverse are no overflow

/// Angle and arc length as functions of u in [0, 1]: the log-radius form, or for clothoids u = s.
class Profile {
public:
    /// By its turn and r = ln(rho1 / rho0).
    static Profile by_ratio(double alpha, double log_ratio, double turn);
    explicit Profile(const LogAestheticSegment& segment);

    double turn() const { return turn_; }
    /// u where the share x of the length is left behind.
    double u_of(double x) const;
    double angle(double u) const;
    /// The curvature of the arc of length 1 and its derivative by arc length, over the curvature.
    double curvature(double u) const;
    double log_slope(double u) const;
    /// Derivatives of the curvature by arc length, `count` of them from the 0th.
    void curvature_jet(double u, int count, double* out) const;
    bool is_clothoid() const { return is_clothoid_; }

    /// Panels of u on each of which a few nodes give the position to rounding.
    int panels() const;
    /// int e^(i angle) ds over a part of [0, 1] in u, no longer than a panel.
    std::complex<double> step(Interval part) const;
    /// The same to 1e-9 of the part: for fits, whose data are not that good.
    std::complex<double> rough_step(Interval part) const;
    /// The end point.
    std::complex<double> end() const;

private:
    Profile() = default;
    double change() const;
    std::complex<double> integral(Interval part, int nodes) const;

    bool is_clothoid_ = true;
    double alpha_ = -1, r_ = 0;
    Rise angle_, arc_;  ///< exponents a and b
    double turn_ = 0;
    double k0_ = 0, k1_ = 0;  ///< end curvatures
};

}  // namespace batten::spiral
