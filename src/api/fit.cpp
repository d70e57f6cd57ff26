#include "batten/make/fit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "api/fit_picture.hpp"
#include "api/row.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "batten/make/fit_curve.hpp"

namespace batten::api {
namespace {

/// The options of a fit, and the columns that hold its data.
struct FitTableOptions {
    std::string x, y, sigma;
    bool parametric = false;
    FitOptions fit;
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
    std::vector<Uncertain> roots, extrema;
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
std::vector<double> sigma_of(const Table& table, FitTableOptions& options) {
    if (const auto number = parse_number(options.sigma)) {
        options.fit.sigma = *number;
    } else if (!options.sigma.empty()) {
        return error_values(table, column_index(table, options.sigma));
    } else if (options.fit.sigma_model.empty() && has_column(table, "sigma")) {
        return error_values(table, column_index(table, "sigma"));
    }
    return {};
}

FitData data_of(const Table& table, FitTableOptions& options) {
    const int x = column_of(table, options.x, {"x"}, 1);
    const int y = column_of(table, options.y, {"y", "f"}, x == 1 && options.y.empty() ? 1 : 2);
    return {column_values(table, x), column_values(table, y), sigma_of(table, options),
            name_of_column(table, x, "x"), name_of_column(table, y, "y")};
}

/// One error a sample, whatever they came from: what pictures and rows show.
void fill_sigma(FitData& data, const Fit& made, const FitOptions& options) {
    if (!data.sigma.empty()) return;
    data.sigma.assign(data.x.size(), made.report.sigma.value_or(1));
    if (options.sigma_model.size() != 2) return;
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        data.sigma[i] = std::sqrt(options.sigma_model[0] * data.y[i] + options.sigma_model[1]);
    }
}

Rows residual_rows(const FitData& data, const SplineFunction& spline) {
    Rows rows{{"x", "y", "sigma", "fit", "residual"}, Points(data.x.size(), 5)};
    for (std::size_t i = 0; i < data.x.size(); ++i) {
        const double s = spline(data.x[i]);
        const double row[] = {data.x[i], data.y[i], data.sigma[i], s, data.y[i] - s};
        std::copy(std::begin(row), std::end(row), rows.cells[i].begin());
    }
    return rows;
}

/// The points, their parameters, and how far the curve passes.
Rows distance_rows(const Points& points, const CurveFit& made) {
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

bool is_continuous(const SplineFunction& spline) {
    const std::size_t degree = static_cast<std::size_t>(spline.degree());
    if (degree == 0) return spline.pieces() == 1;
    const std::span<const double> t = spline.knots();
    for (std::size_t j = 0; j + degree < t.size(); ++j) {
        const bool is_inside = t[j] > spline.domain().lo && t[j] < spline.domain().hi;
        if (is_inside && t[j] == t[j + degree]) return false;
    }
    return true;
}

/// The spline as a curve, or its values where it has jumps, which no curve has.
Output output_of(const FitData& data, Fit& made) {
    if (is_continuous(made.spline)) {
        const bool is_constant = made.spline.degree() == 0;
        return graph(is_constant ? elevate_degree(made.spline) : made.spline);
    }
    made.report.notes.push_back("the spline has jumps and is no curve: written as rows");
    return residual_rows(data, made.spline);
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

Outcome run_parametric(const PointsInput& input, FitTableOptions options) {
    const std::vector<double> sigma = sigma_of(input.table, options);
    const auto points =
        std::make_shared<Points>(points_of(input.table, columns_of(input, options)));
    auto made = std::make_shared<CurveFit>(
        naming_lines(input, [&] { return fit_curve(*points, sigma, options.fit); }));
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    return {Curve(made->curve), made->report.status, {}, report_value(made->report),
            [points, made, o = options.fit] { return fit_curve_picture(*points, *made, o); },
            {}, [points, made] { return distance_rows(*points, *made); }};
}

Outcome run(std::span<const Input> inputs, const FitTableOptions& asked) {
    FitTableOptions options = asked;
    const PointsInput& input = points_input(inputs);
    if (options.parametric) return run_parametric(input, options);
    const auto data = std::make_shared<FitData>(data_of(input.table, options));
    auto made = std::make_shared<Fit>(
        naming_lines(input, [&] { return fit(data->view(), options.fit); }));
    fill_sigma(*data, *made, options.fit);
    made->report.notes.insert(made->report.notes.begin(), input.table.notes.begin(),
                              input.table.notes.end());
    Output output = output_of(*data, *made);
    return {std::move(output), made->report.status, {}, report_of(*made),
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
