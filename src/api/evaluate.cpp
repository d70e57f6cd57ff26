#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>

#include "api/curve_layers.hpp"
#include "api/row.hpp"
#include "api/spline_panel.hpp"
#include "api/surface_picture.hpp"
#include "api/surface_values.hpp"
#include "api/uncertain_extrema.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "batten/make/fit_bands.hpp"
#include "batten/measure/coordinate.hpp"
#include "batten/measure/line.hpp"
#include "batten/measure/nearest.hpp"

namespace batten::api {
namespace {

constexpr int most_derivatives = 9;

struct EvaluateOptions {
    CoordinateRows at;
    std::optional<int> count;
    int derivatives = 0;
    std::vector<double> integral;
    std::optional<double> band;
    bool curvature = false;
    bool roots = false;
    bool extrema = false;
    std::vector<double> nearest;
    std::vector<double> line;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, EvaluateOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("at", o.at, anything,
          "parameters to evaluate at; abscissae where the curve is y(x); on a surface places X,Y");
    visit("count", o.count, between(2, 1e8),
          "so many parameters, evenly over the domain; so many a side of a surface");
    visit("derivatives", o.derivatives, between(0, most_derivatives),
          "derivatives by the parameter, up to this one");
    visit("integral", o.integral, anything,
          "the integral of the last coordinate over the parameter from A to B; of a surface over "
          "X0,X1,Y0,Y1");
    visit("band", o.band, between(1, 99.9999),
          "percent: half the width of the band of the last coordinate and of all else that is asked "
          "for; of curves by fit");
    visit("curvature", o.curvature, anything,
          "of a surface: its normal, Gaussian and mean curvature");
    visit("roots", o.roots, anything, "where the last coordinate is 0");
    visit("extrema", o.extrema, anything, "local minima and maxima of the last coordinate");
    visit("nearest", o.nearest, anything, "the point of the curve that is nearest to X,Y[,Z]");
    visit("line", o.line, anything, "where the curve meets the line through X0,Y0 and X1,Y1");
}

struct EvaluateReport {
    std::size_t points = 0;
    std::optional<double> integral;
    std::optional<double> integral_band;
    std::optional<std::vector<double>> roots;
    std::optional<std::vector<std::optional<double>>> roots_band;
    std::optional<std::vector<UncertainExtremum>> extrema;
    std::optional<std::vector<std::optional<double>>> extrema_band;
    std::optional<Nearest> nearest;
    std::optional<std::vector<LineIntersection>> intersections;
};

template <class Visit>
void visit_fields(const EvaluateReport& r, Visit&& visit) {
    visit("points", r.points, "number of parameters");
    if (r.integral) visit("integral", r.integral, "of the last coordinate over the parameter");
    if (r.integral_band) visit("integral_band", r.integral_band, "half the width of its band");
    if (r.roots) visit("roots", r.roots, "parameters where the last coordinate is 0");
    if (r.roots_band) {
        visit("roots_band", r.roots_band,
              "half the width of each one's band; none at a touching and at a jump");
    }
    if (r.extrema) visit("extrema", r.extrema, "local extrema of the last coordinate");
    if (r.extrema_band) {
        visit("extrema_band", r.extrema_band,
              "the same of the places; none where it is flat and at a corner, which is known as its "
              "knot is");
    }
    if (r.nearest) visit("nearest", r.nearest, "the nearest point of the curve");
    if (r.intersections) visit("intersections", r.intersections, "where the curve meets the line");
}

void require_row_width(const CoordinateRows& at, int most, const char* rule) {
    if (at.width <= most) return;
    throw Error("option.value", "at", std::to_string(at.width) + " columns", rule);
}

std::vector<double> parameters(const Curve& curve, const EvaluateOptions& options) {
    require_row_width(options.at, 1, "must be one parameter a row");
    const Interval domain = curve.domain();
    for (const double t : options.at.numbers) {
        if (!domain.contains(t)) {
            throw Error("curve.outside", "at", format_number(t),
                        "must lie in the curve's domain [" + format_number(domain.lo) + ", " +
                            format_number(domain.hi) + "]");
        }
    }
    std::vector<double> t = options.at.numbers;
    for (int i = 0; options.count && i < *options.count; ++i) {
        t.push_back(i + 1 == *options.count ? domain.hi
                                            : domain.lo + domain.length() * i / (*options.count - 1));
    }
    const bool asks_nothing = options.integral.empty() && !options.roots && !options.extrema &&
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

/// Half the width of a band, in units of the deviation, and the deviations.
struct Band {
    const FitCovariance* covariance = nullptr;  ///< null: not asked for
    double factor = 0;

    double half(double deviation) const {
        if (std::isfinite(factor * deviation)) return factor * deviation;
        throw Error("number.overflow", "band", format_number(factor * deviation),
                    "is beyond the range of a double");
    }
};

Band band_asked(const Curve& curve, const EvaluateOptions& options) {
    if (!options.band) return {};
    const FitCovariance& covariance = require_covariance(covariance_of(curve));
    return {&covariance, covariance.factor(*options.band)};
}

/// `rows` with half the width of the band of the last coordinate and of each derivative.
Rows with_band(Rows rows, const Curve& curve, const Band& band, int derivatives) {
    if (!band.covariance) return rows;
    const std::size_t width = rows.names.size(), more = static_cast<std::size_t>(derivatives) + 1;
    const std::string last = coordinate_names(curve.dim()).back();
    for (int order = 0; order <= derivatives; ++order) {
        rows.names.push_back((order == 0 ? last : "d" + std::to_string(order) + last) + "_band");
    }
    Points cells(rows.cells.size(), static_cast<int>(width + more));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        std::copy(rows.cells[i].begin(), rows.cells[i].end(), cells[i].begin());
        for (std::size_t order = 0; order < more; ++order) {
            cells[i][width + order] = band.half(
                band.covariance->deviation(rows.cells[i][0], static_cast<int>(order)));
        }
    }
    rows.cells = std::move(cells);
    return rows;
}

/// Of the place where the derivative number `order` is 0.
std::optional<double> half_of_place(const Band& band, double t, int order) {
    const std::optional<double> deviation = band.covariance->deviation_of_place(t, order);
    return deviation ? std::optional(band.half(*deviation)) : std::nullopt;
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

void require_numbers(const std::vector<double>& integral, std::size_t count, const char* rule) {
    if (integral.size() == count) return;
    throw Error("option.value", "integral", std::to_string(integral.size()) + " numbers", rule);
}

void add_bands(EvaluateReport& report, const EvaluateOptions& options, const Band& band) {
    if (report.integral) {
        const Interval part{options.integral[0], options.integral[1]};
        report.integral_band = band.half(band.covariance->integral(part).deviation);
    }
    if (report.roots) report.roots_band.emplace();
    for (const double t : report.roots.value_or(std::vector<double>())) {
        report.roots_band->push_back(half_of_place(band, t, 0));
    }
    if (report.extrema) report.extrema_band.emplace();
    for (const UncertainExtremum& e : report.extrema.value_or(std::vector<UncertainExtremum>())) {
        report.extrema_band->push_back(half_of_place(band, e.t, 1));
    }
}

/// Those of a spline with jumps include the jumps across 0.
std::vector<double> roots_of(const Curve& curve) {
    const SplineGraph* const graph = curve.shape<SplineGraph>();
    return graph ? roots(graph->spline()) : roots(curve, curve.dim() - 1, 0);
}

void require_no_jumps(const Curve& curve, const EvaluateOptions& options) {
    if (!has_jumps(curve) || (options.nearest.empty() && options.line.empty())) return;
    throw Error("curve.jumps", "evaluate", "nearest or line",
                "these are asked of curves without jumps");
}

EvaluateReport answers(const Curve& curve, const EvaluateOptions& options, const Band& band) {
    const int last = curve.dim() - 1;
    EvaluateReport report;
    if (!options.integral.empty()) {
        require_numbers(options.integral, 2, "must be two numbers A,B");
        report.integral = integral(curve, last, {options.integral[0], options.integral[1]});
    }
    if (options.roots) report.roots = roots_of(curve);
    if (options.extrema) report.extrema = uncertain_extrema(curve, covariance_of(curve));
    if (band.covariance) add_bands(report, options, band);
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

void add_values(Panel& panel, const SplineFunction& spline, const std::vector<double>& at) {
    if (at.empty()) return;
    Points points(0, 2);
    for (const double t : at) points.push_back(std::array{t, spline(t)});
    panel.add(PointsLayer{std::move(points), "values"});
}

/// Roots and extrema as dots.
void add_places(Panel& panel, const EvaluateReport& report) {
    Points roots(0, 2), extrema(0, 2);
    for (const double t : report.roots.value_or(std::vector<double>())) {
        roots.push_back(std::array{t, 0.0});
    }
    for (const UncertainExtremum& e : report.extrema.value_or(std::vector<UncertainExtremum>())) {
        extrema.push_back(std::array{e.t, e.value});
    }
    const auto add = [&](const Points& points, const char* name, Tone tone) {
        if (points.empty()) return;
        panel.add(PointsLayer{points, name, Marker::closed, {}, PointLabels::none, tone});
    };
    add(roots, "roots", Tone::teal);
    add(extrema, "extrema", Tone::violet);
}

/// A spline y(x) with its band, and the derivatives that are not 0 everywhere.
Drawing function_picture(const Curve& curve, const SplineFunction& spline,
                         const std::vector<double>& t, const EvaluateReport& report,
                         const EvaluateOptions& options) {
    const AxisNames names;
    const Band sure = band_asked(curve, options);
    const NamedBand band{sure.covariance, sure.factor,
                         options.band ? format_number(*options.band) + " % band" : ""};
    const char* const name = "spline";
    Drawing drawing;
    const int panels = std::min(options.derivatives, spline.degree());
    if (panels > 0) {
        drawing.width = 1000;
        drawing.columns = 2;
    }
    Panel& values = drawing.panels.front() = value_panel(spline, names, band, name);
    if (panels == 0) values.caption.clear();
    add_values(values, spline, t);
    add_places(values, report);
    for (int order = 1; order <= panels; ++order) {
        drawing.panels.push_back(derivative_panel(spline, order, names, band, name));
    }
    return drawing;
}

Drawing picture(const Curve& curve, const std::vector<double>& t, const EvaluateReport& report,
                const EvaluateOptions& options) {
    if (const std::optional<SplineFunction> spline = function_of(curve)) {
        return function_picture(curve, *spline, t, report, options);
    }
    Drawing drawing;
    add_parts(drawing, curve);
    if (!t.empty()) drawing.add(TicksLayer{curve, t, {}});
    return drawing;
}

Outcome run_surface(const Surface& surface, const EvaluateOptions& options) {
    if (options.roots || options.extrema || options.band || !options.nearest.empty() ||
        !options.line.empty()) {
        throw Error("surface.option", "evaluate", "roots, extrema, band, nearest or line",
                    "these are asked of curves");
    }
    require_row_width(options.at, 2, "must be places, x and y in a row");
    constexpr int usual_count = 33;
    const bool asks_nothing = options.at.numbers.empty() && options.integral.empty();
    const Rows rows = surface_rows(
        surface, {options.at.numbers, options.count.value_or(asks_nothing ? usual_count : 0),
                  options.derivatives, options.curvature});
    EvaluateReport report;
    report.points = rows.cells.size();
    if (!options.integral.empty()) {
        const std::vector<double>& p = options.integral;
        require_numbers(p, 4, "must be four numbers X0,X1,Y0,Y1");
        const auto [low_x, high_x] = std::minmax(p[0], p[1]);
        const auto [low_y, high_y] = std::minmax(p[2], p[3]);
        const bool is_reversed = (p[0] > p[1]) != (p[2] > p[3]);
        const double found = integral(surface, {{low_x, high_x}, {low_y, high_y}});
        report.integral = is_reversed ? -found : found;
    }
    return {rows, Status::met, {}, report_value(report), [surface] {
                return surface_picture(surface, usual_levels);
            }};
}

Outcome run(std::span<const Input> inputs, const EvaluateOptions& options) {
    if (inputs.size() == 1) {
        if (const auto* surface = std::get_if<Surface>(&inputs.front().content)) {
            return run_surface(*surface, options);
        }
    }
    if (options.curvature) {
        throw Error("surface.option", "curvature", "asked for", "this is asked of surfaces");
    }
    const Curve& curve = curve_input(inputs);
    require_no_jumps(curve, options);
    const std::vector<double> t = parameters(curve, options);
    const Band band = band_asked(curve, options);
    EvaluateReport report = answers(curve, options, band);
    report.points = t.size();
    return {with_band(values(curve, t, options.derivatives), curve, band, options.derivatives),
            Status::met, {}, report_value(report),
            [curve, t, report, options] { return picture(curve, t, report, options); }};
}

}  // namespace

Operation evaluate_row() {
    Operation evaluate =
        row<EvaluateOptions>({"evaluate", "points, derivatives, integrals, roots and extrema",
                              InputKind::curve_or_surface, OutputKind::rows, {}, false, true},
                             run);
    for (Field& field : evaluate.fields) {
        if (field.name == "band") field.bare = "95";
    }
    return evaluate;
}

}  // namespace batten::api
