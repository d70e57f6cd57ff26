#include "batten/shape/spline_graph.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/bspline.hpp"

namespace batten {
namespace {

/// Places in the knots where a jump's first knot stands.
std::vector<std::size_t> jumps_of(const SplineFunction& spline) {
    const std::span<const double> t = spline.knots();
    const std::size_t degree = static_cast<std::size_t>(spline.degree());
    std::vector<std::size_t> found;
    for (std::size_t j = 0; j + degree < t.size(); ++j) {
        const bool is_inside = t[j] > spline.domain().lo && t[j] < spline.domain().hi;
        if (is_inside && t[j] == t[j + degree]) found.push_back(j);
    }
    return found;
}

Curve joined_graph(const SplineFunction& spline) {
    return graph(spline.degree() == 0 ? elevate_degree(spline) : spline);
}

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

bool has_jumps(const SplineFunction& spline) { return !jumps_of(spline).empty(); }

bool has_jumps(const Curve& curve) { return curve.shape<SplineGraph>() != nullptr; }

SplineGraph::SplineGraph(SplineFunction spline) : spline_(std::move(spline)) {
    for (std::size_t i = 0; i < spline_.pieces(); ++i) {
        const double end = spline_.value_on(i, spline_.breaks()[i + 1], 0);
        if (std::isfinite(end)) continue;
        throw Error("number.overflow", "piece " + std::to_string(i), format_number(end),
                    "the spline must lie within the range of a double");
    }
}

void SplineGraph::jets_on(std::size_t piece, std::span<const double> t, int order,
                          std::span<double> out) const {
    std::size_t at = 0;
    for (const double x : t) {
        for (int derivative = 0; derivative <= order; ++derivative) {
            out[at++] = derivative == 0 ? x : derivative == 1 ? 1.0 : 0.0;
            out[at++] = spline_.value_on(piece, x, derivative);
        }
    }
}

Curve graph_in_parts(const SplineFunction& spline) {
    if (has_jumps(spline)) return SplineGraph(clamped(spline));
    return joined_graph(spline);
}

std::vector<Curve> parts_between_jumps(const Curve& curve) {
    const SplineGraph* const whole = curve.shape<SplineGraph>();
    if (!whole) return {curve};
    const SplineFunction& s = whole->spline();
    const std::size_t order = static_cast<std::size_t>(s.degree()) + 1;
    std::vector<std::size_t> ends = jumps_of(s);
    ends.push_back(s.coefficients().size());
    std::vector<Curve> parts;
    std::size_t from = 0;
    for (const std::size_t to : ends) {
        const auto part = [&](std::span<const double> all, std::size_t count) {
            const std::span<const double> some = all.subspan(from, count);
            return std::vector<double>(some.begin(), some.end());
        };
        parts.push_back(joined_graph({part(s.knots(), to - from + order),
                                      part(s.coefficients(), to - from), s.degree()}));
        from = to;
    }
    return parts;
}

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
