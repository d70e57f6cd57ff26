#include "batten/make/fit_surface.hpp"

#include "api/row.hpp"
#include "api/surface_picture.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/make/fit_front.hpp"

namespace batten::api {
namespace {

/// The options of a surface fit, and where the grid's lines stand.
struct SurfaceRequest {
    std::vector<double> x, y;
    FitSurfaceOptions fit;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, SurfaceRequest>
void visit_fields(Options& o, Visit&& visit) {
    visit("x", o.x, anything, "places of the grid's lines in x, where the file holds none");
    visit("y", o.y, anything, "places of the grid's lines in y");
    visit_fields(o.fit, visit);
}

void take_lines(std::vector<double>& lines, const std::vector<double>& given, const char* axis) {
    if (given.empty()) return;
    if (given.size() != lines.size()) {
        throw Error("fit-surface.sizes", axis, std::to_string(given.size()),
                    "the grid has " + std::to_string(lines.size()) + " lines in this direction");
    }
    lines = given;
}

std::vector<OutputForm> surface_forms(const SplineSurface& surface, const GridFile& grid) {
    const auto on_nodes = [surface, grid] { return surface.evaluate(grid.x, grid.y); };
    const MeshPlaces places{grid.x, grid.y};
    return {{"csv", [=] { return csv_grid(grid.x, grid.y, on_nodes()); }},
            {"npy", [=] { return npy_grid(on_nodes()); }},
            {"obj", [=] { return obj_mesh(surface, places); }},
            {"ply", [=] { return ply_mesh(surface, places); }},
            {"stl", [=] { return stl_mesh(surface, places); }}};
}

Outcome run_curved(const GridFile& grid, const FitSurfaceOptions& options) {
    FitFrontOptions front;
    front.sigma = options.sigma;
    const FrontFit made = fit_front({grid.x, grid.y, grid.z, {}, {}, grid.sigma}, front);
    const auto heights = [made, grid] { return heights_on(made.surface, grid.x, grid.y); };
    return {Surface(made.surface),
            made.report.status,
            {},
            report_value(made.report),
            [made] { return front_picture(made); },
            {{"csv", [=] { return csv_grid(grid.x, grid.y, heights()); }},
             {"npy", [=] { return npy_grid(heights()); }}}};
}

Outcome run(std::span<const Input> inputs, const SurfaceRequest& request) {
    GridFile grid = grid_input(inputs);
    take_lines(grid.x, request.x, "x");
    take_lines(grid.y, request.y, "y");
    FitSurfaceOptions options = request.fit;
    // An error typed counts for all nodes, whatever the file says.
    if (options.sigma) grid.sigma.clear();
    if (options.knots == SurfaceKnots::curved) return run_curved(grid, options);
    SurfaceFit made = fit_surface({grid.x, grid.y, grid.z, {}, {}, grid.sigma}, options);
    made.report.notes.insert(made.report.notes.begin(), grid.notes.begin(), grid.notes.end());
    return {Surface(made.surface),
            made.report.status,
            {},
            report_value(made.report),
            [made, grid] { return surface_fit_picture(made, grid); },
            surface_forms(made.surface, grid)};
}

}  // namespace

Operation fit_surface_row() {
    return row<SurfaceRequest>({"fit-surface", "a least-squares spline surface on a grid of heights",
                                InputKind::grid, OutputKind::surface},
                               run);
}

}  // namespace batten::api
