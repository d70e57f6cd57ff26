#include "make/pseudo/segment/minima.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "make/pseudo/segment/angles.hpp"
#include "make/pseudo/segment/descent.hpp"
#include "make/pseudo/segment/kernel.hpp"

namespace batten::pseudo {
namespace {

/// Magnitudes a descent starts from.
struct Start {
    double r0, r1;
};

/// Where least minima are reached from: the middle of the valley, its two ends, the single arcs
/// with an angle above 90 degrees, and the pocket at theta0 = 50..72 degrees. Against 144 starts on
/// each of 18000 random pairs of angles, 15000 of them in the difficult zones, they missed a lower
/// J once, by 5e-13 of it at 0.87 degrees.
constexpr std::array<Start, 5> central_starts{{{1, 1}, {0.3, 2}, {2, 0.1}, {1.4, 3}, {0.07, 2.8}}};

/// ... and for small angles, where all lie at r = 1 +- (1 to 2) theta0.
constexpr double small_angle = 0.35;

std::array<Start, 5> starts_for(double theta0) {
    const double t = theta0;
    if (t >= small_angle) return central_starts;
    return {
        {{1, 1}, {1 - t, 1 + t}, {1 + t, 1 - t}, {1 - 2 * t, 1 + 2 * t}, {1 + 2 * t, 1 - 2 * t}}};
}

constexpr double tie = 1e-14;

/// Below this J is 0 to double precision whatever r0, r1 are.
constexpr double least_angle = 1e-70;

/// Below this, in the valley of the arcs, minima are flatter than the rounding error of J.
constexpr double flat_angle = 0.02;

/// J as a function of ln r0, ln r1, in which no step leaves r > 0; for small angles, of r0, r1, in
/// which the valley r0 + r1 = 2 of the rivals is straight and can be walked in long steps.
class Coordinates {
public:
    explicit Coordinates(const PseudoSegment& angles)
        : angles_(angles), is_plain_(angles.theta0 < small_angle) {}

    double of(double r) const { return is_plain_ ? r : std::log(r); }
    double magnitude(double x) const { return is_plain_ ? x : std::exp(x); }
    PseudoSegment segment(const Vector<2>& x) const {
        return {angles_.theta0, angles_.theta1, magnitude(x[0]), magnitude(x[1])};
    }
    Quadratic<2> expand(const Vector<2>& x) const;
    /// Along r0 = r1.
    Quadratic<1> expand_equal(const Vector<1>& x) const;

private:
    PseudoSegment angles_;
    bool is_plain_;
};

Quadratic<2> Coordinates::expand(const Vector<2>& x) const {
    if (is_plain_ && !(x[0] > 0 && x[1] > 0)) {
        return {std::numeric_limits<double>::infinity(), {}, {}};
    }
    const Expansion<2> j = expand_magnitudes(segment(x));
    if (!is_plain_) return {j.value, j.gradient, j.hessian};
    Quadratic<2> q{j.value, {}, {}};
    for (std::size_t a = 0; a < 2; ++a) {
        q.gradient[a] = j.gradient[a] / x[a];
        for (std::size_t b = 0; b < 2; ++b) {
            q.hessian[a][b] = (j.hessian[a][b] - (a == b ? j.gradient[a] : 0)) / (x[a] * x[b]);
        }
    }
    return q;
}

Quadratic<1> Coordinates::expand_equal(const Vector<1>& x) const {
    const Quadratic<2> j = expand({x[0], x[0]});
    return {j.value,
            {j.gradient[0] + j.gradient[1]},
            {{{j.hessian[0][0] + 2 * j.hessian[0][1] + j.hessian[1][1]}}}};
}

Minimum at_end_of(const PseudoSegment& segment, DescentStatus status) {
    const Expansion<0> j = expand_value(segment);
    return {segment, j.energy, j.length, j.value, status == DescentStatus::converged};
}

/// The minimum of symmetric curves, if it is one across the symmetry too. The search keeps to
/// r0 = r1, for rounding errors alone would drive it down the flat valley between the rivals.
std::optional<Minimum> descend_symmetric(const PseudoSegment& start) {
    const Coordinates coordinates(start);
    const auto d = descend<1>([&](const Vector<1>& x) { return coordinates.expand_equal(x); },
                              Vector<1>{coordinates.of(start.r0)});
    const Vector<2> at{d.at[0], d.at[0]};
    const Quadratic<2> j = coordinates.expand(at);
    const double across = j.hessian[0][0] - 2 * j.hessian[0][1] + j.hessian[1][1];
    if (start.theta0 >= flat_angle && !(across > 0)) return std::nullopt;
    return at_end_of(coordinates.segment(at), d.status);
}

/// The minimum reached from a start in the quarter domain.
Minimum descend_from(const PseudoSegment& start) {
    PseudoSegment s = start;
    if (s.theta0 < least_angle) return {{s.theta0, s.theta1, 1, 1}, 0, 1, 0, true};
    if (std::fabs(s.theta1) == s.theta0 && s.r0 == s.r1) {
        if (const auto symmetric = descend_symmetric(s)) return *symmetric;
        s.r0 *= 1.01;  // off the saddle
    }
    const Coordinates coordinates(s);
    const auto d = descend<2>([&](const Vector<2>& x) { return coordinates.expand(x); },
                              Vector<2>{coordinates.of(s.r0), coordinates.of(s.r1)});
    return at_end_of(coordinates.segment(d.at), d.status);
}

bool is_same(const Minimum& a, const Minimum& b) {
    const double apart = std::fmax(std::fabs(std::log(a.segment.r0 / b.segment.r0)),
                                   std::fabs(std::log(a.segment.r1 / b.segment.r1)));
    return apart < (a.segment.theta0 < flat_angle ? 2.0 : 1e-4);
}

/// Adds what a start leads to, unless it is known.
void add_from(const Start& start, const Quarter& quarter, std::vector<Minimum>& minima) {
    const Minimum found = descend_from({quarter.theta0(), quarter.theta1(), start.r0, start.r1});
    const bool is_known = std::any_of(minima.begin(), minima.end(),
                                      [&](const Minimum& m) { return is_same(m, found); });
    if (!is_known && (found.is_converged || minima.empty())) minima.push_back(found);
}

/// The least first, the others in the order of their energy.
void put_in_order(std::vector<Minimum>& minima) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < minima.size(); ++i) {
        if (minima[i].pseudo_energy < minima[least].pseudo_energy * (1 - tie)) least = i;
    }
    std::swap(minima.front(), minima[least]);
    std::stable_sort(minima.begin() + 1, minima.end(), [](const Minimum& a, const Minimum& b) {
        return a.pseudo_energy < b.pseudo_energy;
    });
}

std::vector<Minimum> central_in(const Quarter& quarter) {
    std::vector<Minimum> minima;
    for (const Start& start : starts_for(quarter.theta0())) add_from(start, quarter, minima);
    put_in_order(minima);
    return minima;
}

std::vector<Minimum> back(std::vector<Minimum> minima, const Quarter& quarter) {
    for (Minimum& m : minima) m.segment = quarter.back(m.segment);
    return minima;
}

}  // namespace

Minimum least_minimum(double theta0, double theta1) {
    return central_minima(theta0, theta1).front();
}

std::vector<Minimum> central_minima(double theta0, double theta1) {
    const Quarter quarter(theta0, theta1);
    return back(central_in(quarter), quarter);
}

std::vector<Minimum> all_minima(double theta0, double theta1) {
    constexpr int starts = 12;
    constexpr double lowest = 0.005;
    constexpr double highest = 60;
    const Quarter quarter(theta0, theta1);
    std::vector<Minimum> minima = central_in(quarter);
    const auto level = [](int i) {
        return lowest * std::pow(highest / lowest, i / (starts - 1.0));
    };
    for (int i = 0; i < starts; ++i) {
        for (int j = 0; j < starts; ++j) add_from({level(i), level(j)}, quarter, minima);
    }
    put_in_order(minima);
    return back(std::move(minima), quarter);
}

Minimum minimum_near(const PseudoSegment& start) {
    const Quarter quarter(start.theta0, start.theta1);
    Minimum minimum = descend_from(quarter.into(start));
    minimum.segment = quarter.back(minimum.segment);
    return minimum;
}

}  // namespace batten::pseudo
