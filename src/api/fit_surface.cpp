#include "batten/make/fit_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "api/row.hpp"
#include "api/scattered_columns.hpp"
#include "api/surface_picture.hpp"
#include "api/surface_values.hpp"
#include "api/turned_grid.hpp"
#include "batten/base/text.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/make/fit_front.hpp"
#include "batten/make/fit_scattered.hpp"
#include "batten/make/fit_surface_chunks.hpp"

namespace batten::api {
namespace {

/// The options of a surface fit, and where the grid's lines stand.
struct SurfaceRequest {
    std::vector<double> x, y;
    Errors sigma;
    std::vector<double> x_sigma, y_sigma;
    bool scattered = false;
    std::string columns;
    Points lines{0, 1};
    bool stream = false;
    FitSurfaceOptions fit;
    Progress progress;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, SurfaceRequest>
void visit_fields(Options& o, Visit&& visit) {
    visit("x", o.x, anything, "places of the grid's lines in x, where the file holds none");
    visit("y", o.y, anything, "places of the grid's lines in y");
    visit("scattered", o.scattered, anything,
          "rows x,y,z[,sigma] in any places, not on a grid");
    visit("columns", o.columns, anything,
          "of --scattered rows: the columns of x, y, z and, as a fourth, the errors: names or #k");
    visit("lines", o.lines, anything,
          "rows y,X1,X2,...: curved knot lines x = X(y) that are given");
    visit("stream", o.stream, anything,
          "read the file in blocks of rows, as files above 1 GiB always are: .npy or a table, knots "
          "auto, given, or equal with intervals");
    visit_fields(o.fit, [&](const char* name, auto& member, Limits limits, const char* help) {
        if (std::string_view(name) != "sigma") visit(name, member, limits, help);
    });
    visit("sigma", o.sigma, more_than(0),
          "the errors (standard deviations): one of all, or a grid of them; of --scattered heights a "
          "column or a file of one a row");
    visit("x_sigma", o.x_sigma, anything,
          "errors that are products: a factor for each x, times that of each y");
    visit("y_sigma", o.y_sigma, anything, "the factor for each y");
}

void take_lines(std::vector<double>& lines, const std::vector<double>& given, const char* axis) {
    if (given.empty()) return;
    if (given.size() != lines.size()) {
        throw Error("fit-surface.sizes", axis, std::to_string(given.size()),
                    "the grid has " + std::to_string(lines.size()) + " lines in this direction");
    }
    lines = given;
}

/// What is asked line by line in x, or in y, the other way round.
void turn_errors_in_x(SurfaceRequest& request) {
    std::reverse(request.x_sigma.begin(), request.x_sigma.end());
    reverse_rows(request.sigma.each, request.sigma.width);
}

void turn_errors_in_y(SurfaceRequest& request) {
    std::reverse(request.y_sigma.begin(), request.y_sigma.end());
    reverse_in_rows(request.sigma.each, request.sigma.width);
}

/// What is told line by line follows the file's lines, which were turned if they fell.
void follow_lines(SurfaceRequest& request, bool x_is_turned, bool y_is_turned) {
    if (x_is_turned) {
        std::reverse(request.x.begin(), request.x.end());
        turn_errors_in_x(request);
    }
    if (y_is_turned) {
        std::reverse(request.y.begin(), request.y.end());
        turn_errors_in_y(request);
    }
}

/// The lines asked for, turned round with all that stands on them where they fall.
void take_all_lines(GridFile& grid, SurfaceRequest& request) {
    follow_lines(request, grid.x_is_turned, grid.y_is_turned);
    take_lines(grid.x, request.x, "x");
    take_lines(grid.y, request.y, "y");
    if (falls(grid.x)) {
        turn_x(grid);
        turn_errors_in_x(request);
    }
    if (falls(grid.y)) {
        turn_y(grid);
        turn_errors_in_y(request);
    }
}

bool has_products(const SurfaceRequest& request) {
    return !request.x_sigma.empty() || !request.y_sigma.empty();
}

void require_one_kind(const SurfaceRequest& request) {
    if (request.sigma.is_given() && has_products(request)) {
        throw Error("fit.options", "sigma", "with x_sigma or y_sigma",
                    "errors are given for the nodes or as products");
    }
}

/// Errors typed count for all nodes, whatever the file says.
void take_errors(GridFile& grid, const SurfaceRequest& request) {
    const Errors& asked = request.sigma;
    require_one_kind(request);
    if (!asked.column.empty()) {
        throw Error("option.value", "sigma", asked.column,
                    "must be a number, or a file of a grid with an error for each node");
    }
    if (asked.is_given() || has_products(request)) grid.sigma = asked.each;
    if (asked.each.empty()) return;
    const std::size_t rows = asked.each.size() / asked.width;
    if (rows != grid.x.size() || asked.width != grid.y.size()) {
        throw Error("fit-surface.sizes", "sigma",
                    std::to_string(rows) + " x " + std::to_string(asked.width),
                    "the grid has " + std::to_string(grid.x.size()) + " x " +
                        std::to_string(grid.y.size()) + " nodes");
    }
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < asked.width; ++j) {
            if (!grid.z.has(i, j)) grid.sigma[i * asked.width + j] = 1;
        }
    }
}

SurfaceSamples samples_of(const GridFile& grid, const SurfaceRequest& request) {
    return {grid.x, grid.y, grid.z, request.x_sigma, request.y_sigma, grid.sigma};
}

/// Each node's own error, where they are products: what pictures show.
GridFile with_products(GridFile grid, const SurfaceRequest& request) {
    if (!has_products(request)) return grid;
    grid.sigma.assign(grid.x.size() * grid.y.size(), 1);
    for (std::size_t k = 0; k < grid.sigma.size(); ++k) {
        const std::size_t i = k / grid.y.size(), j = k % grid.y.size();
        if (!request.x_sigma.empty()) grid.sigma[k] *= request.x_sigma[i];
        if (!request.y_sigma.empty()) grid.sigma[k] *= request.y_sigma[j];
    }
    return grid;
}

Outcome curved_outcome(const CurvedKnotSurface& surface, const FrontReport& report,
                       const GridFile& grid, std::optional<double> sigma) {
    // Where no error is known, that of the fit is its own mean.
    const double error = sigma.value_or(std::sqrt(report.sigma2.value_or(1)));
    return {Surface(surface), report.status, {}, report_value(report),
            [surface, report, grid, error] {
                return curved_fit_picture(surface, report, grid, error);
            },
            surface_forms(Surface(surface), grid.x, grid.y)};
}

/// Strips across given lines, where nothing else is asked for.
constexpr int usual_strips = 3;

Outcome run_lines(const GridFile& grid, const SurfaceRequest& request) {
    FitSurfaceOptions others = request.fit;
    if (others.knots == SurfaceKnots::curved) others.knots = SurfaceKnots::automatic;
    require_only(others, {"sigma", "intervals"},
                 "does not go with given curved lines: the surface is cubic over them and over "
                 "equal strips");
    const std::vector<double>& n = request.fit.intervals;
    if (n.size() > 1) {
        throw Error("fit.options", "intervals", "two numbers",
                    "with given lines one number tells the strips in y");
    }
    const LinesFit made =
        fit_with_lines(samples_of(grid, request), lines_through(request.lines),
                       n.empty() ? usual_strips : static_cast<int>(n[0]), request.fit.sigma);
    return curved_outcome(made.surface, made.report, with_products(grid, request),
                          request.fit.sigma);
}

Outcome tensor_outcome(SurfaceFit made, GridFile grid) {
    made.report.notes.insert(made.report.notes.begin(), grid.notes.begin(), grid.notes.end());
    std::vector<OutputForm> forms = surface_forms(Surface(made.surface), grid.x, grid.y);
    return {Surface(made.surface), made.report.status, {}, report_value(made.report),
            [made, grid = std::move(grid)] { return surface_fit_picture(made, grid); },
            std::move(forms)};
}

Outcome run_curved(const GridFile& grid, const SurfaceRequest& request) {
    require_only(request.fit, {"sigma", "knots"},
                 "does not go with curved knots, which bic chooses; the surface is cubic");
    FitFrontOptions front;
    front.sigma = request.fit.sigma;
    FrontFit made = fit_front(samples_of(grid, request), front);
    if (made.report.has_front) {
        return curved_outcome(made.surface, made.report, with_products(grid, request),
                              request.fit.sigma);
    }
    made.tensor.report.notes.push_back(
        "no front is seen: bic is " + format_fixed(*made.report.tensor_bic, 1) +
        " with straight knot lines, " + format_fixed(made.report.bic, 1) + " with curved ones");
    return tensor_outcome(std::move(made.tensor), with_products(grid, request));
}

/// What goes with grids only.
void require_no_grid(const SurfaceRequest& request) {
    SurfaceRequest others = request;
    others.fit = {};
    require_only(others, {"scattered", "columns", "sigma"},
                 "goes with grids only, not with scattered rows");
    if (request.fit.knots == SurfaceKnots::curved) {
        throw Error("fit.options", "knots", "curved",
                    "goes with grids only, not with scattered rows");
    }
}

void require_no_columns(const SurfaceRequest& request) {
    if (request.columns.empty()) return;
    throw Error("fit.options", "columns", request.columns,
                "goes with scattered rows only, not with a grid");
}

Outcome run_scattered(std::span<const Input> inputs, const SurfaceRequest& request) {
    require_no_grid(request);
    const PointsInput input = rows_input(inputs);
    const Table& table = input.table;
    const ScatteredColumns columns = scattered_columns(table, request.columns);
    const std::vector<double> x = column_values(table, columns.x);
    const std::vector<double> y = column_values(table, columns.y);
    const std::vector<double> z = column_values(table, columns.z);
    if (has_products(request) || request.sigma.width != 1) {
        throw Error("fit.options", has_products(request) ? "x_sigma, y_sigma" : "sigma", "given",
                    "errors of a grid's nodes are for grids");
    }
    std::vector<double> sigma = request.sigma.each;
    if (!request.sigma.column.empty()) {
        sigma = column_values(table, column_index(table, request.sigma.column));
    } else if (!request.sigma.is_given() && columns.sigma) {
        sigma = column_values(table, *columns.sigma);
    }
    const SurfaceFit made = naming_lines(
        input, [&] { return fit_scattered({x, y, z, sigma}, request.fit); });
    const Rectangle domain = made.surface.domain();
    constexpr std::size_t lines = 65;
    return {Surface(made.surface), made.report.status, {}, report_value(made.report),
            [made, x, y, z, sigma] { return scattered_fit_picture(made, {x, y, z, sigma}); },
            surface_forms(Surface(made.surface), even_places(domain.x, lines),
                          even_places(domain.y, lines))};
}

bool is_streamed(std::span<const Input> inputs, const SurfaceRequest& request) {
    const bool is_stored =
        inputs.size() == 1 && std::holds_alternative<StoredFile>(inputs.front().content);
    return request.stream || (is_stored && !request.scattered);
}

/// A grid read in blocks over the lines asked for, which may fall.
class StreamedGrid {
public:
    StreamedGrid(GridStream grid, SurfaceRequest& request) : grid_(std::move(grid)) {
        follow_lines(request, grid_.x_is_turned(), grid_.y_is_turned());
        x = grid_.x();
        y = grid_.y();
        take_lines(x, request.x, "x");
        take_lines(y, request.y, "y");
        x_falls_ = falls(x);
        y_falls_ = falls(y);
        if (x_falls_) {
            std::reverse(x.begin(), x.end());
            turn_errors_in_x(request);
        }
        if (y_falls_) {
            std::reverse(y.begin(), y.end());
            turn_errors_in_y(request);
        }
    }

    void read(std::size_t first, std::span<double> z) {
        const std::size_t rows = z.size() / y.size();
        grid_.read(x_falls_ ? x.size() - first - rows : first, z);
        // A row turned, or all of them, is a turn of everything and a turn of every row.
        if (x_falls_) std::reverse(z.begin(), z.end());
        if (x_falls_ == y_falls_) return;
        for (std::size_t r = 0; r < rows; ++r) {
            const std::span<double> row = z.subspan(r * y.size(), y.size());
            std::reverse(row.begin(), row.end());
        }
    }

    std::vector<double> x, y;  ///< rising

private:
    GridStream grid_;
    bool x_falls_ = false, y_falls_ = false;
};

Outcome run_streamed(std::span<const Input> inputs, SurfaceRequest request) {
    if (request.scattered || !request.lines.empty()) {
        throw Error("fit-surface.streamed", request.scattered ? "scattered" : "lines", "given",
                    "only grids with straight knot lines are read in blocks");
    }
    if (request.fit.knots == SurfaceKnots::curved) {
        throw Error("fit-surface.streamed", "knots", "curved",
                    "only grids with straight knot lines are read in blocks");
    }
    if (!request.sigma.each.empty() || !request.sigma.column.empty()) {
        throw Error("fit-surface.streamed", "sigma", "an error a node",
                    "grids read in blocks have one error of all, or products: x_sigma, y_sigma");
    }
    require_no_columns(request);
    require_one_kind(request);
    StreamedGrid grid(grid_stream_input(inputs), request);
    const std::vector<double>&x = grid.x, &y = grid.y;
    SurfaceFit made = fit_surface(
        {x, y, [&](std::size_t first, std::span<double> z) { grid.read(first, z); },
         request.x_sigma, request.y_sigma},
        request.fit, request.progress);
    if (made.report.missing > 0) {
        made.report.notes.insert(made.report.notes.begin(),
                                 std::to_string(made.report.missing) + " nodes are missing");
    }
    return {Surface(made.surface), made.report.status, {}, report_value(made.report),
            [made] { return surface_picture(Surface(made.surface), usual_levels); },
            surface_forms(Surface(made.surface), x, y)};
}

/// Words that would decide nothing.
void require_used(const FitSurfaceOptions& o) {
    const bool is_given = !o.x_knots.empty() || !o.y_knots.empty();
    if (o.knots == SurfaceKnots::given && !is_given) {
        throw Error("fit.options", "knots", "given", "needs x_knots or y_knots");
    }
    const bool has_rule = o.stop != StopRule::bic && o.stop != StopRule::none;
    if (has_rule && (is_given || !o.intervals.empty() || o.delta2)) {
        throw Error("fit.options", "stop", std::string(name_of(o.stop)),
                    "decides on the number of strips, on which another option decides");
    }
}

Outcome run(std::span<const Input> inputs, const SurfaceRequest& asked) {
    require_used(asked.fit);
    SurfaceRequest request = asked;
    request.fit.sigma = asked.sigma.all;
    if (is_streamed(inputs, request)) return run_streamed(inputs, request);
    if (request.scattered) return run_scattered(inputs, request);
    require_no_columns(request);
    GridFile grid = grid_input(inputs);
    take_all_lines(grid, request);
    take_errors(grid, request);
    if (!request.lines.empty()) return run_lines(grid, request);
    if (request.fit.knots == SurfaceKnots::curved) return run_curved(grid, request);
    SurfaceFit made = fit_surface(samples_of(grid, request), request.fit);
    return tensor_outcome(std::move(made), with_products(std::move(grid), request));
}

}  // namespace

Operation fit_surface_row() {
    return row<SurfaceRequest>({"fit-surface", "a least-squares spline surface on a grid of heights",
                                InputKind::grid, OutputKind::surface,
                                {"csv", "npy", "obj", "patches", "ply", "stl"}},
                               run);
}

}  // namespace batten::api
