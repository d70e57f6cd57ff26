#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "batten/make/arcs.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "shared.hpp"

namespace batten {
namespace arcs_sweep_test {

constexpr double pi = std::numbers::pi;

/// A curve in closed form: value and derivatives of x and y.
using Function = double (*)(double t, int order, int coordinate);

Curve curve_of(Function f, std::vector<double> joints, bool closed = false) {
    CallableCurve curve;
    curve.joints = std::move(joints);
    curve.closed = closed;
    curve.function = [f](double t, int order, std::span<double> out) {
        for (int k = 0; k <= order; ++k) {
            for (int c = 0; c < 2; ++c) out[static_cast<std::size_t>(2 * k + c)] = f(t, k, c);
        }
    };
    return curve;
}

double ellipse(double t, int k, int c) {
    return c == 0 ? 2 * std::cos(t + k * pi / 2) : std::sin(t + k * pi / 2);
}
double sine(double t, int k, int c) {
    return c == 0 ? (k == 0 ? 4 / pi * t : k == 1 ? 4 / pi : 0) : std::sin(t + k * pi / 2);
}
/// r = e^(t/5), complex: z = exp((1/5 + i) t).
double spiral(double t, int k, int c) {
    const double size = std::exp(t / 5) * std::pow(1.04, 0.5 * k);
    const double angle = t + k * std::atan2(1, 0.2);
    return size * (c == 0 ? std::cos(angle) : std::sin(angle));
}

double norm(double x, double y) { return std::hypot(x, y); }

double curvature(Function f, double t) {
    const double x1 = f(t, 1, 0), y1 = f(t, 1, 1), x2 = f(t, 2, 0), y2 = f(t, 2, 1);
    return (x1 * y2 - y1 * x2) / std::pow(norm(x1, y1), 3);
}

/// The integral of |d kappa / ds|^(1/3) ds, and the number of extrema of kappa inside.
struct Demand {
    double integral = 0;
    int extrema = 0;
};
Demand demand(Function f, double lo, double hi) {
    constexpr int steps = 20000;
    const double h = (hi - lo) / steps;
    Demand result;
    double before = 0;
    for (int i = 0; i < steps; ++i) {
        const double t = lo + (i + 0.5) * h;
        const double slope = (curvature(f, t + h / 2) - curvature(f, t - h / 2)) / h;
        const double speed = norm(f(t, 1, 0), f(t, 1, 1));
        result.integral += std::cbrt(std::fabs(slope) / speed) * speed * h;
        if (slope * before < 0) ++result.extrema;
        before = slope;
    }
    return result;
}

/// The distance of a point from an arc, from first principles.
double distance(const Arc& arc, double x, double y) {
    const auto [ax, ay] = arc.start;
    const auto [bx, by] = arc.end;
    const double to_ends = std::min(norm(x - ax, y - ay), norm(x - bx, y - by));
    if (arc.is_line()) {
        const double s = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) /
                         (std::pow(bx - ax, 2) + std::pow(by - ay, 2));
        if (s < 0 || s > 1) return to_ends;
        return std::fabs((x - ax) * (by - ay) - (y - ay) * (bx - ax)) / norm(bx - ax, by - ay);
    }
    const auto [cx, cy] = *arc.center();
    double turn = std::atan2((ax - cx) * (y - cy) - (ay - cy) * (x - cx),
                             (ax - cx) * (x - cx) + (ay - cy) * (y - cy));
    const double sign = arc.bulge > 0 ? 1 : -1;
    if (turn * sign < 0) turn += sign * 2 * pi;
    if (std::fabs(turn) > std::fabs(arc.sweep())) return to_ends;
    return std::fabs(norm(x - cx, y - cy) - *arc.radius());
}

double distance(const ArcChain& chain, double x, double y) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        nearest = std::min(nearest, distance(chain.arc(i), x, y));
    }
    return nearest;
}

struct Case {
    const char* name;
    Function function;
    double lo, hi;
    bool closed;
};
const std::vector<Case> cases{{"ellipse", ellipse, 0, 2 * pi, true},
                              {"half ellipse", ellipse, 0, pi, false},
                              {"sine", sine, 0, pi, false},
                              {"long sine", sine, 0, 10, false},
                              {"spiral", spiral, -5, 10, false}};

TEST(ArcsSweep, NoPointOfTheCurveIsFurtherFromTheArcsThanAsked) {
    for (const Case& one : cases) {
        const Curve curve = curve_of(one.function, {one.lo, one.hi}, one.closed);
        for (int power = -1; power >= -6; --power) {
            ArcsOptions options;
            options.tolerance = absolute(std::pow(10, power));
            const ArcFit fit = arcs(curve, options);
            EXPECT_EQ(fit.report.status, Status::met);
            double largest = 0;
            const int samples = 1500;
            for (int i = 0; i <= samples; ++i) {
                const double t = one.lo + i * (one.hi - one.lo) / samples;
                largest = std::max(largest, distance(fit.chain, one.function(t, 0, 0),
                                                     one.function(t, 0, 1)));
            }
            EXPECT_LE(largest, options.tolerance->value) << one.name << ' ' << power;
            EXPECT_GE(fit.report.max_error, largest * (1 - 1e-6)) << one.name << ' ' << power;
        }
    }
}

TEST(ArcsSweep, TheNumberOfBiarcsFollowsTheAsymptoticLaw) {
    for (const Case& one : cases) {
        const Demand demanded = demand(one.function, one.lo, one.hi);
        for (int power = -2; power >= -6; --power) {
            ArcsOptions options;
            options.tolerance = absolute(std::pow(10, power));
            const ArcFit fit = arcs(curve_of(one.function, {one.lo, one.hi}, one.closed), options);
            const double law = demanded.integral / std::cbrt(324 * options.tolerance->value);
            EXPECT_LE(static_cast<double>(fit.chain.arcs()) / 2,
                      1.15 * law + demanded.extrema + 2)
                << one.name << ' ' << power;
        }
    }
}

TEST(ArcsSweep, AChainAlongACurveTakesAsManyPointsAsTheToleranceNeeds) {
    for (int power = -1; power >= -4; --power) {
        ArcsOptions options;
        options.method = ArcMethod::chain;
        options.tolerance = absolute(std::pow(10, power));
        const ArcFit fit = arcs(curve_of(spiral, {-5, 0, 10}), options);
        EXPECT_EQ(fit.report.status, Status::met);
        EXPECT_LE(fit.report.max_error, options.tolerance->value);
        EXPECT_LT(fit.report.max_tangent_jump, 1e-10);
    }
}

TEST(ArcsSweep, CornersAndCuspsOfTheCurveStayCorners) {
    // A Bezier arch, a corner, an arch, then a cubic with a cusp at its middle.
    const Points joints({0, 0, 2, 0, 4, 0, 5, 0}, 2);
    const Points start({3, 6, 3, 6, 3, 3}, 2), end({3, -6, 3, -6, 3, -3}, 2);
    const Curve arches =
        PiecewiseCubic::hermite(joints, start, end, {0, 1, 2, 3}, false);
    ArcsOptions options;
    options.tolerance = absolute(1e-4);
    const ArcFit fit = arcs(arches, options);
    EXPECT_LE(fit.report.max_error, 1e-4);
    EXPECT_NEAR(fit.report.max_tangent_jump, 2 * std::atan2(6, 3), 1e-12);
    const Curve at_cusp =
        PiecewiseCubic::power({0, 4, 0, 8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}, 2, {-1, 1}, false);
    const ArcFit sharp = arcs(at_cusp, options);  // (u^2, u^3) from u = 0 on: ends in a cusp
    EXPECT_LE(sharp.report.max_error, 1e-4);
    EXPECT_LT(sharp.report.max_tangent_jump, 1e-9);
}

/// Biarcs over given points: the fewest moves by dynamic programming, from first principles.
class Optimum {
public:
    Optimum(const Points& points, double tolerance) : points_(points), tolerance_(tolerance) {
        for (std::size_t i = 0; i < points.size(); ++i) tangents_.push_back(tangent(i));
    }

    std::size_t moves() const {
        const std::size_t n = points_.size();
        std::vector<std::size_t> fewest(n, 1000000);
        fewest[0] = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                if (fewest[i] + 2 < fewest[j] && passes(i, j)) fewest[j] = fewest[i] + 2;
            }
        }
        return fewest[n - 1];
    }

private:
    std::array<double, 2> at(std::size_t i) const { return {points_(i, 0), points_(i, 1)}; }
    /// Of the circle through point i and its neighbours.
    std::array<double, 2> tangent(std::size_t i) const {
        const std::size_t n = points_.size();
        const std::size_t b = std::clamp<std::size_t>(i, 1, n - 2);
        const Arc whole{at(b - 1), at(b + 1), bulge(at(b - 1), at(b), at(b + 1))};
        if (i == 0) return whole.start_tangent();
        if (i == n - 1) return whole.end_tangent();
        const auto before = at(b - 1), here = at(b), after = at(b + 1);
        const double l = norm(here[0] - before[0], here[1] - before[1]);
        const double m = norm(after[0] - here[0], after[1] - here[1]);
        const double x = (here[0] - before[0]) * m / l + (after[0] - here[0]) * l / m;
        const double y = (here[1] - before[1]) * m / l + (after[1] - here[1]) * l / m;
        return {x / norm(x, y), y / norm(x, y)};
    }
    /// tan(sweep / 4) of the arc a - b - c: the angle at b is pi - sweep / 2.
    static double bulge(std::array<double, 2> a, std::array<double, 2> b,
                        std::array<double, 2> c) {
        const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
        return std::tan(std::atan2(ux * vy - uy * vx, ux * vx + uy * vy) / 2);
    }
    static double bulge_from(std::array<double, 2> tangent, std::array<double, 2> from,
                             std::array<double, 2> to) {
        const double x = to[0] - from[0], y = to[1] - from[1];
        return std::tan(std::atan2(tangent[0] * y - tangent[1] * x,
                                   tangent[0] * x + tangent[1] * y) / 2);
    }
    bool passes(std::size_t i, std::size_t j) const {
        const auto p = at(i), q = at(j), s = tangents_[i], t = tangents_[j];
        const double vx = q[0] - p[0], vy = q[1] - p[1];
        const double ahead = vx * (s[0] + t[0]) + vy * (s[1] + t[1]);
        const double together = 1 - s[0] * t[0] - s[1] * t[1];
        const double v_sq = vx * vx + vy * vy;
        const double d = v_sq / (ahead + std::sqrt(ahead * ahead + 2 * v_sq * together));
        const std::array<double, 2> joint{(p[0] + q[0] + d * (s[0] - t[0])) / 2,
                                          (p[1] + q[1] + d * (s[1] - t[1])) / 2};
        const Arc first{p, joint, bulge_from(s, p, joint)};
        const Arc second{joint, q, -bulge_from({-t[0], -t[1]}, q, joint)};
        for (std::size_t k = i + 1; k < j; ++k) {
            const double off = std::min(distance(first, points_(k, 0), points_(k, 1)),
                                        distance(second, points_(k, 0), points_(k, 1)));
            if (!(off <= tolerance_)) return false;
        }
        return true;
    }

    const Points& points_;
    double tolerance_;
    std::vector<std::array<double, 2>> tangents_;
};

/// n points of a curve, each moved at random by about `jitter`.
Points sampled(const Case& one, std::size_t n, double jitter) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0, 1);
    Points points(0, 2);
    for (std::size_t i = 0; i < n; ++i) {
        const double t =
            one.lo + (one.hi - one.lo) * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
        points.push_back(std::vector{one.function(t, 0, 0) + jitter * noise(random),
                                     one.function(t, 0, 1) + jitter * noise(random)});
    }
    return points;
}

void expect_near_minimum(const Case& one, const Points& points, double tolerance) {
    ArcsOptions options;
    options.tolerance = absolute(tolerance);
    const ArcFit fit = arcs(points, options);
    const std::size_t n = points.size(), least = Optimum(points, tolerance).moves();
    EXPECT_LE(fit.chain.arcs(), std::min(least + 1, n - 1)) << one.name << ' ' << n;
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_LE(distance(fit.chain, points(i, 0), points(i, 1)), tolerance * (1 + 1e-9));
    }
}

TEST(ArcsSweep, PointsGetAtMostOneArcMoreThanTheMinimum) {
    for (const Case& one : cases) {
        for (const double jitter : {0.0, 3e-4}) {
            expect_near_minimum(one, sampled(one, 30, jitter), 1e-2);
            expect_near_minimum(one, sampled(one, 100, jitter), 1e-2);
            expect_near_minimum(one, sampled(one, 100, jitter), 2e-3);
        }
    }
    expect_near_minimum(cases[3], sampled(cases[3], 300, 3e-4), 2e-3);
    expect_near_minimum(cases[4], sampled(cases[4], 300, 0), 1e-2);
}

}  // namespace arcs_sweep_test
}  // namespace batten
