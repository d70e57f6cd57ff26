#include "batten/make/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "api/fit_picture.hpp"
#include "api/row.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "batten/make/fit_curve.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten::api {
namespace {

/// The options of a fit, and the columns that hold its data.
struct FitTableOptions {
    std::string x, y, sigma;
    bool parametric = false;
    FitOptions fit;
    Progress progress;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, FitTableOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("x", o.x, anything, "column of the abscissae [x, else the first]");
    visit("y", o.y, anything, "column of the ordinates [y or f, else the second]");
    visit("sigma", o.sigma, anything,
          "column of the errors (standard deviations), or the error of all [sigma, if there]");
    visit("parametric", o.parametric, anything,
          "a curve near points in the order they are passed, instead of y(x)");
    visit_fields(o.fit, [&](const char* name, auto& member, Limits limits, const char* help) {
        if (std::string_view(name) != "sigma") visit(name, member, limits, help);
    });
}

/// What follows from a fit, with deviations.
struct FitFeatures {
    Uncertain integral;
    std::vector<UncertainPlace> roots, extrema;
};

template <class Visit>
void visit_fields(const FitFeatures& r, Visit&& visit) {
    visit("integral", r.integral, "over the data's range");
    visit("roots", r.roots, "where the spline is 0");
    visit("extrema", r.extrema, "places of the extrema");
}

/// The report, and the features where the data determine the spline.
Value report_of(const Fit& made) {
    Value report = report_value(made.report);
    if (!made.report.undetermined.empty()) return report;
    const FitCovariance& c = made.covariance;
    const FitFeatures features{c.integral(made.spline.domain()), c.roots(), c.extrema()};
    const Value more = report_value(features);
    for (const auto& entry : *more.map()) report.map()->push_back(entry);
    return report;
}

/// Where in the file the samples without weight stand; a few of them, where there are many.
void note_lines_of_rejected(FitReport& report, const Table& table) {
    constexpr std::size_t most_listed = 20;
    if (report.rejected.empty() || table.line_of_row.empty()) return;
    std::string note = report.rejected.size() > 1 ? "rejected: lines" : "rejected: line";
    for (std::size_t i = 0; i < std::min(most_listed, report.rejected.size()); ++i) {
        note += (i > 0 ? ", " : " ") + std::to_string(table.line_of_row[report.rejected[i]]);
    }
    report.notes.push_back(note + (report.rejected.size() > most_listed ? ", ... of " : " of ") +
                           table.source);
}

bool has_column(const Table& table, std::string_view name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
}

/// The column asked for, else the first of `usual` that is there, else the `place`-th.
int column_of(const Table& table, const std::string& asked, std::initializer_list<const char*> usual,
              int place) {
    if (!asked.empty()) return column_index(table, asked);
    for (const char* const name : usual) {
        if (has_column(table, name)) return column_index(table, name);
    }
    return column_index(table, "#" + std::to_string(place));
}

std::string name_of_column(const Table& table, int column, const char* otherwise) {
    return table.names.empty() ? otherwise : table.names[static_cast<std::size_t>(column)];
}

/// The errors asked for: a column, or a number that goes into options.fit.sigma.
SharedNumbers sigma_of(const PointsInput& input, FitTableOptions& options) {
    const Table& table = input.table;
    if (const auto number = parse_number(options.sigma)) {
        options.fit.sigma = *number;
    } else if (!options.sigma.empty()) {
        return errors_in(input, column_index(table, options.sigma));
    } else if (options.fit.sigma_model.empty() && has_column(table, "sigma")) {
        return errors_in(input, column_index(table, "sigma"));
    }
    return {};
}

FitData data_of(const PointsInput& input, FitTableOptions& options) {
    const Table& table = input.table;
    const int x = column_of(table, options.x, {"x"}, 1);
    const int y = column_of(table, options.y, {"y", "f"}, x == 1 && options.y.empty() ? 1 : 2);
    return {column_in(input, x), column_in(input, y), sigma_of(input, options),
            name_of_column(table, x, "x"), name_of_column(table, y, "y")};
}

/// One error a sample, whatever they came from: what pictures and rows show.
void fill_sigma(FitData& data, const Fit& made, const FitOptions& options) {
    if (!data.sigma.empty()) return;
    std::vector<double> sigma(data.x.size(), made.report.sigma.value_or(1));
    if (options.sigma_model.size() == 2) {
        for (std::size_t i = 0; i < sigma.size(); ++i) {
            sigma[i] = std::sqrt(options.sigma_model[0] * data.y[i] + options.sigma_model[1]);
        }
    }
    data.sigma = SharedNumbers(std::move(sigma));
}

/// Samples without weight are left out: a file of numbers has no word for their sigma.
Rows residual_rows(const FitData& data, const SplineFunction& spline) {
    Rows rows{{"x", "y", "sigma", "fit", "residual"}, Points(0, 5)};
    rows.cells.reserve(data.x.size());
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        if (std::isinf(data.sigma[i])) continue;
        const double s = spline(data.x[i]);
        rows.cells.push_back(std::array{data.x[i], data.y[i], data.sigma[i], s, data.y[i] - s});
    }
    return rows;
}

/// The points, their parameters, and how far the curve passes.
Rows distance_rows(PointsView points, const CurveFit& made) {
    std::vector<std::string> names{"t"};
    for (const std::string& axis : coordinate_names(points.dim())) names.push_back(axis);
    for (const std::string& axis : coordinate_names(points.dim())) names.push_back("fit_" + axis);
    names.push_back("distance");
    Rows rows{names, Points(points.size(), 2 * points.dim() + 2)};
    std::vector<double> on(points.coordinates().size());
    Curve(made.curve).jets(made.parameters, 0, on);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::span<double> row = rows.cells[i];
        double sum = 0;
        row[0] = made.parameters[i];
        for (int k = 0; k < points.dim(); ++k) {
            const std::size_t at = static_cast<std::size_t>(k);
            const double c = on[i * static_cast<std::size_t>(points.dim()) + at];
            row[1 + at] = points(i, k);
            row[1 + static_cast<std::size_t>(points.dim()) + at] = c;
            sum += (points(i, k) - c) * (points(i, k) - c);
        }
        row.back() = std::sqrt(sum);
    }
    return rows;
}

/// The spline as a curve, which may have jumps.
Curve curve_of_fit(Fit& made) {
    const Curve curve = graph_in_parts(made.spline);
    if (has_jumps(curve)) {
        made.report.notes.push_back("the spline has jumps: evaluate and draw take it, no operation "
                                    "that follows a curve does");
    }
    return made.report.undetermined.empty() ? with_covariance(curve, made.covariance) : curve;
}

/// The columns that hold the points: picked, else those with the usual names, else as ever.
std::vector<int> columns_of(const PointsInput& input, const FitTableOptions& options) {
    const Table& table = input.table;
    std::string picks = options.x.empty() || options.y.empty() ? "" : options.x + "," + options.y;
    if (picks.empty() && has_column(table, "x") && has_column(table, "y")) {
        picks = has_column(table, "z") ? "x,y,z" : "x,y";
    }
    return input.columns.empty() ? coordinate_columns(table, picks) : input.columns;
}

/// Columns as points: the memory given where it holds just these.
SharedPoints points_in(const PointsInput& input, const std::vector<int>& columns) {
    std::vector<int> all(static_cast<std::size_t>(input.table.columns()));
    std::iota(all.begin(), all.end(), 0);
    if (input.borrowed && columns == all) return points_of(input);
    if (!input.borrowed && input.shared_columns.empty()) {
        return SharedPoints(batten::points_of(input.table, columns));
    }
    std::vector<SharedNumbers> coordinates;
    for (const int column : columns) coordinates.push_back(column_in(input, column));
    Points points(coordinates.front().size(), static_cast<int>(columns.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < columns.size(); ++k) points[i][k] = coordinates[k][i];
    }
    return SharedPoints(std::move(points));
}

Outcome run_parametric(const PointsInput& input, FitTableOptions options) {
    const SharedNumbers sigma = sigma_of(input, options);
    const SharedPoints points = points_in(input, columns_of(input, options));
    auto made = std::make_shared<CurveFit>(
        naming_lines(input, [&] { return fit_curve(points, sigma, options.fit); }));
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    note_lines_of_rejected(made->report, input.table);
    return {Curve(made->curve), made->report.status, {}, report_value(made->report),
            [points, made, o = options.fit] { return fit_curve_picture(points, *made, o); },
            {}, [points, made] { return distance_rows(points, *made); }};
}

/// Options of the other kind of fit, or two that say the same.
void require_kind(const PointsInput& input, const FitTableOptions& options) {
    const auto refuse = [](const char* option, std::string value, const char* rule) {
        throw Error("fit.options", option, std::move(value), rule);
    };
    if (!options.sigma.empty() && !options.fit.sigma_model.empty()) {
        refuse("sigma_model", "given", "sigma says already what the errors are");
    }
    if (options.parametric) return;
    const bool is_file = !input.borrowed && input.shared_columns.empty();
    if (is_file && !input.columns.empty()) {
        refuse("columns", "given", "x and y name the columns of a fit of y(x)");
    }
    if (options.fit.corrections != FitOptions{}.corrections) {
        refuse("corrections", std::to_string(options.fit.corrections),
               "go with parametric curves only");
    }
}

Outcome run(std::span<const Input> inputs, const FitTableOptions& asked) {
    FitTableOptions options = asked;
    options.fit.progress = asked.progress;
    const PointsInput& input = points_input(inputs);
    require_kind(input, options);
    if (options.parametric) return run_parametric(input, options);
    const auto data = std::make_shared<FitData>(data_of(input, options));
    auto made = std::make_shared<Fit>(
        naming_lines(input, [&] { return fit(data->view(), options.fit); }));
    fill_sigma(*data, *made, options.fit);
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    note_lines_of_rejected(made->report, input.table);
    const Curve curve = curve_of_fit(*made);
    return {curve, made->report.status, {}, report_of(*made),
            [data, made, o = options.fit] { return fit_picture(*data, *made, o); },
            {}, [data, made] { return residual_rows(*data, made->spline); }};
}

}  // namespace

Operation fit_row() {
    return row<FitTableOptions>(
        {"fit", "the least-squares spline y(x) of data with known errors", InputKind::table,
         OutputKind::curve},
        run);
}

}  // namespace batten::api
