#include "make/interpolate/function.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace batten::interpolation {
namespace {

std::vector<double> steps_of(PointsView points) {
    std::vector<double> steps(points.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = points(i + 1, 0) - points(i, 0);
    return steps;
}

std::vector<double> slopes_of(PointsView points, const std::vector<double>& steps) {
    std::vector<double> slopes(steps.size());
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        slopes[i] = (points(i + 1, 1) - points(i, 1)) / steps[i];
    }
    return slopes;
}

PiecewiseCubic curve_with(PointsView points, const std::vector<double>& derivatives) {
    const std::size_t spans = points.size() - 1;
    Points start(spans, 2), end(spans, 2);
    std::vector<double> breaks(points.size());
    for (std::size_t i = 0; i <= spans; ++i) breaks[i] = points(i, 0);
    for (std::size_t i = 0; i < spans; ++i) {
        start(i, 0) = end(i, 0) = 1;
        start(i, 1) = derivatives[i];
        end(i, 1) = derivatives[i + 1];
    }
    return PiecewiseCubic::hermite(points, start, end, std::move(breaks), false);
}

/// A chord between two points of the data: its step in x and its slope.
struct Rise {
    double step = 0;
    double slope = 0;
};

bool same_sign(double a, double b) { return (a > 0 && b > 0) || (a < 0 && b < 0); }

double pchip_inner(Rise before, Rise after) {
    if (!same_sign(before.slope, after.slope)) return 0;
    const double steps = before.step + after.step;
    const auto [least, most] = std::minmax(
        before.slope, after.slope, [](double a, double b) { return std::fabs(a) < std::fabs(b); });
    const double share_before = (steps + before.step) / (3 * steps);
    const double share_after = (steps + after.step) / (3 * steps);
    return least / (share_before * (before.slope / most) + share_after * (after.slope / most));
}

/// `outer` is the chord at the end, `inner` the next one.
double pchip_end(Rise outer, Rise inner) {
    const double share = outer.step / (outer.step + inner.step);
    const double slope = outer.slope + share * (outer.slope - inner.slope);
    if (!same_sign(slope, outer.slope)) return 0;
    const bool turns = !same_sign(outer.slope, inner.slope);
    if (turns && std::fabs(slope) > 3 * std::fabs(outer.slope)) return 3 * outer.slope;
    return slope;
}

/// The slope between four chords, of which the point lies between the second and the third.
double makima_slope(const double* m) {
    const double before = std::fabs(m[3] - m[2]) + std::fabs(m[3] + m[2]) / 2;
    const double after = std::fabs(m[1] - m[0]) + std::fabs(m[1] + m[0]) / 2;
    const double sum = before + after;
    return sum == 0 ? 0 : before / sum * m[1] + after / sum * m[2];
}

}  // namespace

PiecewiseCubic pchip_curve(PointsView points) {
    const std::vector<double> steps = steps_of(points);
    const std::vector<double> slopes = slopes_of(points, steps);
    const auto rise = [&](std::size_t i) { return Rise{steps[i], slopes[i]}; };
    const std::size_t last = slopes.size();
    std::vector<double> derivatives(points.size(), slopes[0]);
    if (last > 1) {
        derivatives[0] = pchip_end(rise(0), rise(1));
        derivatives[last] = pchip_end(rise(last - 1), rise(last - 2));
    }
    for (std::size_t i = 1; i < last; ++i) derivatives[i] = pchip_inner(rise(i - 1), rise(i));
    return curve_with(points, derivatives);
}

PiecewiseCubic makima_curve(PointsView points) {
    const std::vector<double> inner = slopes_of(points, steps_of(points));
    const std::size_t last = inner.size();
    std::vector<double> slopes(last + 4, inner[0]);  // two more at both ends, on a parabola
    for (std::size_t i = 0; i < last; ++i) slopes[i + 2] = inner[i];
    if (last > 1) {
        slopes[1] = 2 * slopes[2] - slopes[3];
        slopes[0] = 2 * slopes[1] - slopes[2];
        slopes[last + 2] = 2 * slopes[last + 1] - slopes[last];
        slopes[last + 3] = 2 * slopes[last + 2] - slopes[last + 1];
    }
    std::vector<double> derivatives(points.size());
    for (std::size_t i = 0; i <= last; ++i) derivatives[i] = makima_slope(slopes.data() + i);
    return curve_with(points, derivatives);
}

}  // namespace batten::interpolation
