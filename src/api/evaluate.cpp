#include <algorithm>
#include <concepts>
#include <optional>
#include <string>

#include "api/row.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/measure/line.hpp"
#include "batten/measure/nearest.hpp"

namespace batten::api {
namespace {

constexpr int most_derivatives = 9;

struct EvaluateOptions {
    std::vector<double> at;
    std::optional<int> count;
    int derivatives = 0;
    std::optional<Interval> integral;
    bool roots = false;
    bool extrema = false;
    std::vector<double> nearest;
    std::vector<double> line;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, EvaluateOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("at", o.at, anything, "parameters to evaluate at; abscissae where the curve is y(x)");
    visit("count", o.count, between(2, 1e8), "so many parameters, evenly over the domain");
    visit("derivatives", o.derivatives, between(0, most_derivatives),
          "derivatives by the parameter, up to this one");
    visit("integral", o.integral, anything,
          "the integral of the last coordinate over the parameter from A to B");
    visit("roots", o.roots, anything, "where the last coordinate is 0");
    visit("extrema", o.extrema, anything, "local minima and maxima of the last coordinate");
    visit("nearest", o.nearest, anything, "the point of the curve that is nearest to X,Y[,Z]");
    visit("line", o.line, anything, "where the curve meets the line through X0,Y0 and X1,Y1");
}

struct EvaluateReport {
    std::size_t points = 0;
    std::optional<double> integral;
    std::optional<std::vector<double>> roots;
    std::optional<std::vector<Extremum>> extrema;
    std::optional<Nearest> nearest;
    std::optional<std::vector<LineIntersection>> intersections;
};

template <class Visit>
void visit_fields(const EvaluateReport& r, Visit&& visit) {
    visit("points", r.points, "number of parameters");
    if (r.integral) visit("integral", r.integral, "of the last coordinate over the parameter");
    if (r.roots) visit("roots", r.roots, "parameters where the last coordinate is 0");
    if (r.extrema) visit("extrema", r.extrema, "local extrema of the last coordinate");
    if (r.nearest) visit("nearest", r.nearest, "the nearest point of the curve");
    if (r.intersections) visit("intersections", r.intersections, "where the curve meets the line");
}

std::vector<double> parameters(const Curve& curve, const EvaluateOptions& options) {
    const Interval domain = curve.domain();
    for (const double t : options.at) {
        if (!domain.contains(t)) {
            throw Error("curve.outside", "at", format_number(t),
                        "must lie in the curve's domain [" + format_number(domain.lo) + ", " +
                            format_number(domain.hi) + "]");
        }
    }
    std::vector<double> t = options.at;
    for (int i = 0; options.count && i < *options.count; ++i) {
        t.push_back(i + 1 == *options.count ? domain.hi
                                            : domain.lo + domain.length() * i / (*options.count - 1));
    }
    const bool asks_nothing = !options.integral && !options.roots && !options.extrema &&
                              options.nearest.empty() && options.line.empty();
    if (t.empty() && asks_nothing) t.assign(curve.breaks().begin(), curve.breaks().end());
    return t;
}

std::vector<std::string> column_names(const Curve& curve, int derivatives) {
    std::vector<std::string> names{"t"};
    for (int order = 0; order <= derivatives; ++order) {
        for (const std::string& axis : coordinate_names(curve.dim())) {
            names.push_back(order == 0 ? axis : "d" + std::to_string(order) + axis);
        }
    }
    return names;
}

Rows values(const Curve& curve, std::span<const double> t, int derivatives) {
    const std::size_t width = static_cast<std::size_t>((derivatives + 1) * curve.dim());
    std::vector<double> jets(t.size() * width);
    curve.jets(t, derivatives, jets);
    Rows rows{column_names(curve, derivatives), Points(t.size(), static_cast<int>(width) + 1)};
    for (std::size_t i = 0; i < t.size(); ++i) {
        rows.cells[i][0] = t[i];
        std::copy_n(jets.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                    rows.cells[i].begin() + 1);
    }
    return rows;
}

EvaluateReport answers(const Curve& curve, const EvaluateOptions& options) {
    const int last = curve.dim() - 1;
    EvaluateReport report;
    if (options.integral) report.integral = integral(curve, last, *options.integral);
    if (options.roots) report.roots = roots(curve, last, 0);
    if (options.extrema) report.extrema = extrema(curve, last);
    if (!options.nearest.empty()) report.nearest = nearest(curve, options.nearest);
    if (!options.line.empty()) {
        if (options.line.size() != 4) {
            throw Error("option.value", "line", std::to_string(options.line.size()) + " numbers",
                        "must be two points X0,Y0,X1,Y1");
        }
        const double x = options.line[0], y = options.line[1];
        report.intersections = line_intersections(
            curve, {{x, y}, {options.line[2] - x, options.line[3] - y}});
    }
    return report;
}

Drawing picture(const Curve& curve, const std::vector<double>& t) {
    Drawing drawing;
    drawing.add(CurveLayer{curve, {}, {}});
    if (!t.empty()) drawing.add(TicksLayer{curve, t, {}});
    return drawing;
}

Outcome run(std::span<const Input> inputs, const EvaluateOptions& options) {
    const Curve& curve = curve_input(inputs);
    const std::vector<double> t = parameters(curve, options);
    EvaluateReport report = answers(curve, options);
    report.points = t.size();
    return {values(curve, t, options.derivatives), Status::met, {}, report_value(report),
            [curve, t] { return picture(curve, t); }};
}

}  // namespace

Operation evaluate_row() {
    return row<EvaluateOptions>({"evaluate", "points, derivatives, integrals, roots and extrema",
                                 InputKind::curve, OutputKind::rows},
                                run);
}

}  // namespace batten::api
