#include "api/curvature_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "batten/io/draw/surface_plots.hpp"
#include "io/draw/axes/ticks.hpp"

namespace batten::api {
namespace {

Interval range_of(const Grid& values) {
    const double inf = std::numeric_limits<double>::infinity();
    Interval range{inf, -inf};
    for (std::size_t i = 0; i < values.nu(); ++i) {
        for (std::size_t j = 0; j < values.nv(); ++j) {
            if (!values.has(i, j)) continue;
            range = {std::fmin(range.lo, values(i, j)), std::fmax(range.hi, values(i, j))};
        }
    }
    return range;
}

void make_even(Grid& values, double value) {
    for (std::size_t i = 0; i < values.nu(); ++i) {
        for (std::size_t j = 0; j < values.nv(); ++j) {
            if (values.has(i, j)) values(i, j) = value;
        }
    }
}

}  // namespace

void CurvatureField::allow(double gaussian, double mean, double off) {
    // K is the product of two normal curvatures.
    const double bent = std::fmax(std::fabs(mean), std::sqrt(std::fabs(gaussian)));
    rounding = std::fmax(
        rounding, curvature == SurfaceTarget::mean ? off : off * (2 * bent + off));
}

std::string name_of(SurfaceTarget curvature) {
    return curvature == SurfaceTarget::gaussian ? "Gaussian curvature" : "mean curvature";
}

Panel curvature_map(CurvatureField field, const std::string& of) {
    Panel panel = map_panel({{field.u.front(), field.u.back()}, {field.v.front(), field.v.back()}},
                            name_of(field.curvature) + of);
    panel.x_label = "u";
    panel.y_label = "v";
    MapLayer map;
    map.bar = field.curvature == SurfaceTarget::gaussian ? "K" : "H";
    map.ramp = Ramp::diverging;
    const Interval range = range_of(field.values);
    if (range.length() <= 2 * field.rounding) {
        const double middle = range.lo + range.length() / 2;
        const double even = std::fabs(middle) <= field.rounding ? 0 : middle;
        const double limit = even == 0 ? 1 : std::fabs(even);
        panel.caption += ": " + drawing::short_number(even) + " everywhere";
        make_even(field.values, even);
        map.range = Interval{-limit, limit};
    }
    map.x = std::move(field.u);
    map.y = std::move(field.v);
    map.values = std::move(field.values);
    panel.add(std::move(map));
    return panel;
}

}  // namespace batten::api
