#include <cmath>
#include <limits>
#include <vector>

#include "batten/make/alpha.hpp"
#include "batten/make/fit.hpp"
#include "batten/measure/curvature_graph.hpp"
#include "batten/shape/bspline.hpp"
#include "make/fair/alpha.hpp"

namespace batten {
namespace {

constexpr std::size_t fewest_points = 8;

fairing::Track track_of(PointsView points) {
    require_dimension(points, 2, 2);
    require_count(points, fewest_points);
    require_finite(points);
    require_distinct(points, false);
    // Working units: alpha does not depend on where the points are, or how large.
    const double unit = std::scalbn(1.0, std::ilogb(extent(points)));
    fairing::Track track;
    for (std::size_t i = 0; i < points.size(); ++i) {
        track.x.push_back((points(i, 0) - points(0, 0)) / unit);
        track.y.push_back((points(i, 1) - points(0, 1)) / unit);
    }
    return track;
}

FoundAlpha found(double alpha, double error) {
    return {alpha, error, error <= fairing::identifiable_error};
}

}  // namespace

FoundAlpha alpha_of(PointsView points) {
    const fairing::AlphaEstimate estimate = fairing::most_likely_alpha(track_of(points));
    return found(estimate.alpha, estimate.error);
}

FoundAlpha alpha_by_graph(PointsView points, int inner_knots) {
    const fairing::Track track = track_of(points);
    std::vector<double> s(track.size(), 0.0);
    for (std::size_t i = 1; i < s.size(); ++i) s[i] = s[i - 1] + track.edge(i - 1);
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = inner_knots + 1;
    options.stop = StopRule::none;
    options.sigma = 1;
    const Fit x = fit({s, track.x}, options), y = fit({s, track.y}, options);
    const auto cx = x.spline.coefficients(), cy = y.spline.coefficients();
    Points control(cx.size(), 2);
    for (std::size_t i = 0; i < cx.size(); ++i) {
        control(i, 0) = cx[i];
        control(i, 1) = cy[i];
    }
    const auto knots = x.spline.knots();
    const Curve curve = BSplineCurve(BSplineBasis({knots.begin(), knots.end()}, 3), control);
    const auto line = curvature_graph(curve).line;
    return line ? found(line->slope, line->slope_error)
                : FoundAlpha{0, std::numeric_limits<double>::infinity(), false};
}

}  // namespace batten
