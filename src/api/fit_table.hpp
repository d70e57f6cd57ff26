#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "api/fit_picture.hpp"
#include "api/row.hpp"
#include "batten/make/fit.hpp"
#include "batten/make/fit_options.hpp"

/// What `fit` is asked for, and the columns that hold its data.
namespace batten::api {

struct FitTableOptions {
    std::string x, y;
    Errors sigma;
    bool parametric = false;
    bool stream = false;
    FitOptions fit;
    Progress progress;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, FitTableOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("x", o.x, anything, "column of the abscissae [x, else the first that is free]");
    visit("y", o.y, anything, "column of the ordinates [y or f, else the next that is free]");
    visit("sigma", o.sigma, anything,
          "the errors (standard deviations): a column, one of all, or a file of one a row [the column "
          "sigma, or the third of three without names]");
    visit("parametric", o.parametric, anything,
          "a curve near points in the order they are passed, instead of y(x)");
    visit("stream", o.stream, anything,
          "read the file in blocks of rows, as files above 1 GiB always are: .npy or text columns, "
          "knots given, or equal with intervals, errors known");
    visit_fields(o.fit, [&](const char* name, auto& member, Limits limits, const char* help) {
        if (std::string_view(name) != "sigma") visit(name, member, limits, help);
    });
}

bool has_column(const Table& table, std::string_view name);

/// The errors asked for, one a row; or a number, which goes into options.fit.sigma.
SharedNumbers sigma_of(const PointsInput& input, FitTableOptions& options);

/// The columns of y(x): those asked for, else those of the usual names, else the first that hold
/// nothing else.
std::array<int, 2> function_columns(const Table& table, const FitTableOptions& options);

/// The columns of y(x); an error of all goes into options.fit.sigma.
FitData data_of(const PointsInput& input, FitTableOptions& options);

/// That the third of three named columns is used for nothing, and how it would be.
std::optional<std::string> note_of_unused(const PointsInput& input,
                                          const FitTableOptions& options);

/// The fit of a table that is read in blocks.
Outcome run_fit_streamed(std::span<const Input> inputs, const FitTableOptions& options);

/// The report, and what follows from the fit where the data determine the spline.
Value report_of(const Fit& made);

/// The graph, which knows its covariance where that is known; the report notes where it has jumps.
Curve curve_of(Fit& made);

MadeSpline spline_of(const Fit& made);

}  // namespace batten::api
