#include "make/pseudo/free_end.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "make/pseudo/segment/angles.hpp"
#include "make/pseudo/segment/descent.hpp"
#include "make/pseudo/segment/kernel.hpp"

namespace batten::pseudo {
namespace {

constexpr std::array<std::size_t, 3> free_variables{ln_r0, ln_r1, angle1};

/// Below this J is 3 theta^2 and theta1 = -theta / 2 to double precision.
constexpr double least_angle = 1e-70;

/// ln r0, ln r1 and theta1 over its own order of magnitude, so that J curves alike in all three.
struct FreeVariables {
    explicit FreeVariables(double theta0) : theta(theta0), units{1, 1, std::fmin(theta0, 1)} {}

    Vector<3> of(const PseudoSegment& s) const {
        return {std::log(s.r0), std::log(s.r1), s.theta1 / units[2]};
    }
    PseudoSegment segment(const Vector<3>& x) const {
        return {theta, x[2] * units[2], std::exp(x[0]), std::exp(x[1])};
    }
    Quadratic<3> restrict(const Expansion<4>& j) const;

    double theta;
    Vector<3> units;
};

Quadratic<3> FreeVariables::restrict(const Expansion<4>& j) const {
    Quadratic<3> q;
    q.value = j.value;
    for (std::size_t a = 0; a < 3; ++a) {
        q.gradient[a] = units[a] * j.gradient[free_variables[a]];
        for (std::size_t b = 0; b < 3; ++b) {
            q.hessian[a][b] = units[a] * units[b] * j.hessian[free_variables[a]][free_variables[b]];
        }
    }
    return q;
}

/// d2J / d theta0^2 while the free variables stay at their minimum: the Schur complement.
double curvature_along(const FreeVariables& variables, const Expansion<4>& j) {
    Quadratic<3> mixed = variables.restrict(j);
    for (std::size_t a = 0; a < 3; ++a) {
        mixed.gradient[a] = variables.units[a] * j.hessian[free_variables[a]][angle0];
    }
    const auto response = shifted_newton_step<3>(mixed, 0);
    double curvature = j.hessian[angle0][angle0];
    if (!response) return curvature;
    for (std::size_t a = 0; a < 3; ++a) curvature += mixed.gradient[a] * (*response)[a];
    return curvature;
}

/// The minimum for 0 <= theta <= pi.
FreeEnd descend_free(double theta, const PseudoSegment& start) {
    if (theta < least_angle) {
        return {{theta, -theta / 2, 1, 1}, 0, 6 * theta, 6, true};
    }
    const FreeVariables variables(theta);
    const auto d = descend<3>(
        [&variables](const Vector<3>& x) {
            return variables.restrict(expand_all(variables.segment(x)));
        },
        variables.of(start));
    const PseudoSegment segment = variables.segment(d.at);
    const Expansion<4> j = expand_all(segment);
    return {segment, j.value, j.gradient[angle0], curvature_along(variables, j),
            d.status == DescentStatus::converged};
}

FreeEnd mirrored(FreeEnd end) {
    end.segment.theta0 = -end.segment.theta0;
    end.segment.theta1 = -end.segment.theta1;
    end.slope = -end.slope;
    return end;
}

/// Starts in the valleys of the three minima that are the least one somewhere: s-curves up to 50.8
/// degrees, single arcs from there, with a rival in the pocket at 55.7 to 61.0 degrees.
std::array<PseudoSegment, 3> starts_for(double theta) {
    const double guess = -std::fmin(0.5 * theta, 0.6);
    return {{{theta, guess, 1.1, 0.9}, {theta, guess, 0.55, 2.2}, {theta, guess, 0.2, 2.6}}};
}

/// The s-curves are alone below this.
constexpr double first_rival = 0.7;

}  // namespace

std::vector<FreeEnd> free_end_minima(double angle) {
    const double wrapped = wrap(angle);
    const double theta = std::fabs(wrapped);
    std::vector<FreeEnd> ends;
    for (const PseudoSegment& start : starts_for(theta)) {
        const FreeEnd end = descend_free(theta, start);
        const bool is_known = std::any_of(ends.begin(), ends.end(), [&](const FreeEnd& e) {
            return std::fabs(std::log(e.segment.r0 / end.segment.r0)) < 1e-4;
        });
        if (!is_known) ends.push_back(end);
        if (theta < first_rival) break;
    }
    std::stable_sort(ends.begin(), ends.end(), [](const FreeEnd& a, const FreeEnd& b) {
        return a.pseudo_energy < b.pseudo_energy;
    });
    if (wrapped < 0) std::transform(ends.begin(), ends.end(), ends.begin(), mirrored);
    return ends;
}

FreeEnd free_end(double theta) { return free_end_minima(theta).front(); }

FreeEnd free_end_near(double angle, const PseudoSegment& start) {
    const double theta = wrap(angle);
    if (theta >= 0) return descend_free(theta, start);
    return mirrored(descend_free(-theta, {-start.theta0, -start.theta1, start.r0, start.r1}));
}

}  // namespace batten::pseudo
