#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/bezier/stretch.hpp"
#include "num/chebyshev.hpp"

namespace batten::bezier {

/// A part of a stretch, w = centre + half x, with p in the Chebyshev basis of x.
struct Panel {
    double centre = 0.5, half = 0.5;
    int dim = 0;
    int zeros_lo = 0, zeros_hi = 0;
    bernstein::Coefficients p;
    int nodes = 0;     ///< of Gauss-Legendre
    double error = 0;  ///< bound on the error of the length with that rule, in normal units

    std::size_t count() const { return p.size() / static_cast<std::size_t>(dim); }
    bernstein::View coordinate(int k) const {
        return {p.data() + static_cast<std::size_t>(k) * count(), count()};
    }
    double w_of(double x) const { return centre + half * x; }
    /// p.p at x, and the square of the mean of p.
    double hodograph_sq(double x) const;
    double mean_sq() const;
    /// |dr/dw| at x.
    double speed(double x) const { return std::sqrt(hodograph_sq(x)) * rest_factor(x); }
    /// w^zeros_lo (1 - w)^zeros_hi at x.
    double rest_factor(double x) const;
    /// A bound on |p| and on the rest factor in the ellipse rho >= 1; rho = 1 is [-1, 1] itself.
    double size_within(double rho) const;
    double rest_factor_within(double rho) const;
    /// The largest rho found such that | p.p - |p0|^2 | <= share |p0|^2 in the ellipse, p0 being
    /// the mean of p: so there p.p has no zero and |p| is analytic. At most 2^10; 0 if there is
    /// no rho > 1.
    double analytic_radius(double share) const;
};

/// Cuts stretches into panels.
class Panels {
public:
    explicit Panels(const Pieces& pieces);

    /// Panels on which the speed is integrated with errors of at most `allowed` each (or by a
    /// rule of 2^-60 relative error, if that is less exact). Cost: 1 panel where the speed does
    /// not vary much, some 40 towards a near cusp.
    std::vector<Panel> for_length(const Stretch& stretch, double allowed) const;

    /// Panels on which p.p stays away from 0 in an ellipse rho >= 2, so that 32 nodes integrate
    /// any power of the speed times a polynomial. Empty if 60 halvings are not enough.
    std::vector<Panel> for_powers(const Stretch& stretch) const;

private:
    Panel whole(const Stretch& stretch) const;
    Panel half(const Panel& panel, bool second) const;

    std::vector<chebyshev::Basis> bases_;  // of degree 0, 1, ...
};

/// A curve made ready to be integrated along.
struct Motion {
    explicit Motion(const Curve& curve)
        : pieces(curve), stretches(bezier::stretches(pieces)), panels(pieces) {}

    Pieces pieces;
    std::vector<Stretch> stretches;
    Panels panels;
};

}  // namespace batten::bezier
