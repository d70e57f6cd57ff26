#include "batten/shape/spline_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "batten/shape/bspline.hpp"

namespace batten {
namespace {

/// The rounding of a mean of `degree` knots.
bool is_mean(double x, std::span<const double> knots) {
    double sum = 0, largest = 0;
    for (const double knot : knots) {
        sum += knot;
        largest = std::max(largest, std::fabs(knot));
    }
    const double count = static_cast<double>(knots.size());
    return std::fabs(x - sum / count) <=
           4 * count * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace

std::optional<SplineFunction> spline_of_graph(const Curve& curve) {
    const auto* spline = curve.shape<BSplineCurve>();
    if (!spline || curve.dim() != 2 || curve.is_closed() || spline->is_rational()) return {};
    const std::span<const double> knots = spline->basis().knots();
    const std::size_t degree = static_cast<std::size_t>(spline->basis().degree());
    const PointsView points = spline->control_points();
    std::vector<double> c(points.size());
    for (std::size_t j = 0; j < c.size(); ++j) {
        if (!is_mean(points(j, 0), knots.subspan(j + 1, degree))) return {};
        c[j] = points(j, 1);
    }
    return SplineFunction({knots.begin(), knots.end()}, std::move(c), static_cast<int>(degree));
}

}  // namespace batten
