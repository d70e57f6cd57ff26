#include "batten/measure/line.hpp"

#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "measure/areas.hpp"
#include "measure/bezier/zeros.hpp"

namespace batten {
namespace {

/// The direction with length 1.
std::array<double, 2> unit_direction(const Line& line) {
    const auto [x, y] = line.direction;
    const double largest = std::fmax(std::fabs(x), std::fabs(y));
    if (!(largest > 0) || !std::isfinite(x) || !std::isfinite(y)) {
        throw Error("line.direction", "line", format_number(x) + "," + format_number(y),
                    "a direction must be finite and not zero");
    }
    const double length = std::hypot(x / largest, y / largest);
    return {x / largest / length, y / largest / length};
}

}  // namespace

std::vector<LineIntersection> line_intersections(const Curve& curve, const Line& line) {
    bezier::require_dimension(curve, 2);
    require_finite(PointsView{line.point.data(), 1, 2});
    const std::array<double, 2> d = unit_direction(line);
    const bezier::Pieces pieces(curve);
    std::vector<double> p = pieces.to_normal_near(line.point);
    const double along = p[0] * d[0] + p[1] * d[1];
    for (std::size_t k = 0; k < 2; ++k) p[k] -= along * d[k];  // the line's point next to the curve
    bezier::Zeros zeros(pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto x = pieces.position(i, 0), y = pieces.position(i, 1);
        bernstein::Coefficients beside(x.size());
        double size = 0;
        for (std::size_t j = 0; j < x.size(); ++j) {
            beside[j] = d[0] * (y[j] - p[1]) - d[1] * (x[j] - p[0]);
            size = std::fmax(size, std::fabs(x[j] - p[0]) + std::fabs(y[j] - p[1]));
        }
        zeros.add(i, beside, 0x1p-51 * size + pieces.rounding());
    }
    std::vector<LineIntersection> result;
    for (const double t : zeros.parameters()) {
        const std::vector<double> point = curve(t);
        const std::vector<double> normal = pieces.to_normal(point);
        result.push_back({t,
                          {point[0], point[1]},
                          pieces.in_data(normal[0] * d[0] + normal[1] * d[1] - along, 1)});
    }
    return result;
}

}  // namespace batten
