#include "api/fit_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "api/fit_picture.hpp"
#include "api/row.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "batten/make/fit_curve.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten::api {
namespace {

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

std::vector<std::string> names_of_columns(const Table& table, const std::vector<int>& columns) {
    std::vector<std::string> names = coordinate_names(static_cast<int>(columns.size()));
    for (std::size_t k = 0; k < names.size() && !table.names.empty(); ++k) {
        names[k] = table.names[static_cast<std::size_t>(columns[k])];
    }
    return names;
}

Outcome run_parametric(const PointsInput& input, FitTableOptions options) {
    const SharedNumbers sigma = sigma_of(input, options);
    const std::vector<int> columns = columns_of(input, options);
    const SharedPoints points = points_in(input, columns);
    const CurveFitData data{points, sigma, names_of_columns(input.table, columns)};
    auto made = std::make_shared<CurveFit>(
        naming_lines(input, [&] { return fit_curve(points, sigma, options.fit); }));
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    note_lines_of_rejected(made->report, input.table);
    return {Curve(made->curve), made->report.status, {}, report_value(made->report),
            [data, made, o = options.fit] { return fit_curve_picture(data, *made, o); },
            {}, [points, made] { return distance_rows(points, *made); }};
}

/// Words that would decide nothing.
void require_used(const FitOptions& o) {
    if (o.knots == KnotPlacement::given && o.knots_values.empty()) {
        throw Error("fit.options", "knots", "given", "takes the knots in place of the word");
    }
    const bool has_rule = o.stop != StopRule::bic && o.stop != StopRule::none;
    const bool is_told = o.intervals || o.delta2 || o.tolerance || !o.knots_values.empty();
    if (has_rule && is_told) {
        throw Error("fit.options", "stop", std::string(name_of(o.stop)),
                    "decides on the number of intervals, on which another option decides");
    }
}

/// Options of the other kind of fit, or two that say the same.
void require_kind(const PointsInput& input, const FitTableOptions& options) {
    const auto refuse = [](const char* option, std::string value, const char* rule) {
        throw Error("fit.options", option, std::move(value), rule);
    };
    if (options.sigma.is_given() && !options.fit.sigma_model.empty()) {
        refuse("sigma_model", "given", "sigma says already what the errors are");
    }
    require_used(options.fit);
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
    const bool is_stored =
        inputs.size() == 1 && std::holds_alternative<StoredFile>(inputs.front().content);
    if (options.stream || is_stored) return run_fit_streamed(inputs, options);
    const PointsInput& input = points_input(inputs);
    require_kind(input, options);
    if (options.parametric) return run_parametric(input, options);
    const auto data = std::make_shared<FitData>(data_of(input, options));
    auto made = std::make_shared<Fit>(
        naming_lines(input, [&] { return fit(data->view(), options.fit); }));
    fill_sigma(*data, *made, options.fit);
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    if (const std::optional<std::string> note = note_of_unused(input, options)) {
        made->report.notes.push_back(*note);
    }
    note_lines_of_rejected(made->report, input.table);
    const Curve curve = curve_of(*made);
    return {curve, made->report.status, {}, report_of(*made),
            [data, made, o = options.fit] { return fit_picture(*data, *made, o); },
            {}, [data, made] { return residual_rows(*data, made->spline); }, {},
            spline_of(*made)};
}

}  // namespace

Operation fit_row() {
    return row<FitTableOptions>(
        {"fit", "the least-squares spline y(x) of data with known errors", InputKind::table,
         OutputKind::curve, {"npy"}},
        run);
}

}  // namespace batten::api
