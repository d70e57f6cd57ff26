#include "batten/make/fair_surface.hpp"

#include <algorithm>
#include <cmath>

#include "api/row.hpp"
#include "batten/base/error.hpp"
#include "batten/io/point_grid.hpp"
#include "batten/io/surface_file.hpp"

namespace batten::api {
namespace {

constexpr std::size_t most_lines_drawn = 40;

PointGrid nodes_input(std::span<const Input> inputs) {
    if (inputs.size() == 1) {
        if (const Source* source = std::get_if<Source>(&inputs.front().content)) {
            return parse_point_grid(*source);
        }
    }
    return point_grid_of(grid_input(inputs));
}

Rows rows_of(const PointGrid& lines, const Grid& nodes) {
    Rows rows{{"u", "v", "x", "y", "z", "gaussian", "mean"}, Points(0, 7)};
    for (std::size_t i = 0; i < nodes.nu(); ++i) {
        for (std::size_t j = 0; j < nodes.nv(); ++j) {
            // The border's curvatures are those of the nearest node that has neighbours all round.
            const std::size_t p = std::clamp<std::size_t>(i, 1, nodes.nu() - 2);
            const std::size_t q = std::clamp<std::size_t>(j, 1, nodes.nv() - 2);
            rows.cells.push_back(std::array{lines.u[i], lines.v[j], nodes(i, j, 0), nodes(i, j, 1),
                                            nodes(i, j, 2), gaussian_curvature(nodes, p, q),
                                            mean_curvature(nodes, p, q)});
        }
    }
    return rows;
}

/// Every line of the grid, or every few of many.
std::vector<Points> lines_of(const Grid& nodes) {
    std::vector<Points> runs;
    const std::size_t every_u = nodes.nu() / most_lines_drawn + 1;
    const std::size_t every_v = nodes.nv() / most_lines_drawn + 1;
    const auto append = [&](Points& run, std::size_t i, std::size_t j) {
        run.push_back(std::array{nodes(i, j, 0), nodes(i, j, 1), nodes(i, j, 2)});
    };
    for (std::size_t i = 0; i < nodes.nu(); i += every_u) {
        runs.emplace_back(0, 3);
        for (std::size_t j = 0; j < nodes.nv(); ++j) append(runs.back(), i, j);
    }
    for (std::size_t j = 0; j < nodes.nv(); j += every_v) {
        runs.emplace_back(0, 3);
        for (std::size_t i = 0; i < nodes.nu(); ++i) append(runs.back(), i, j);
    }
    return runs;
}

/// Curvature along lines of constant v.
std::vector<Points> curvatures_of(const Grid& nodes, SurfaceTarget target) {
    std::vector<Points> runs;
    const std::size_t every = nodes.nv() / most_lines_drawn + 1;
    for (std::size_t j = 1; j + 1 < nodes.nv(); j += every) {
        runs.emplace_back(0, 2);
        for (std::size_t i = 1; i + 1 < nodes.nu(); ++i) {
            const double value = target == SurfaceTarget::gaussian ? gaussian_curvature(nodes, i, j)
                                                                   : mean_curvature(nodes, i, j);
            runs.back().push_back(std::array{static_cast<double>(i), value});
        }
    }
    return runs;
}

Panel curvature_panel(const Grid& before, const Grid& after, SurfaceTarget target) {
    const std::vector<Points> fair = curvatures_of(after, target);
    double least = fair.front()(0, 1), most = least;
    for (const Points& run : fair) {
        for (std::size_t i = 0; i < run.size(); ++i) {
            least = std::fmin(least, run(i, 1));
            most = std::fmax(most, run(i, 1));
        }
    }
    const double margin = 0.6 * std::fmax(most - least, 0.1 * std::fabs(most + least));
    Panel panel;
    panel.caption = target == SurfaceTarget::gaussian ? "Gaussian curvature" : "mean curvature";
    panel.kind = PanelKind::chart;
    panel.x_label = "line u";
    panel.y_label = "curvature";
    if (margin > 0) panel.y_range = Interval{least - margin, most + margin};
    // One line of the noise: all of them would cover the picture.
    const std::vector<Points> rough = curvatures_of(before, target);
    panel.add(PolylineLayer{{rough[rough.size() / 2]}, "nodes", {Tone::grey, Dash::solid, 0.5}});
    panel.add(PolylineLayer{fair, "faired", {Tone::accent, Dash::solid, 0.8}});
    return panel;
}

Drawing picture(const Grid& before, const Grid& after, SurfaceTarget target) {
    Drawing drawing;
    drawing.panels.front().caption = "nodes";
    drawing.add(PolylineLayer{lines_of(before), "nodes", {Tone::grey, Dash::solid, 0.6}});
    drawing.add(PolylineLayer{lines_of(after), "faired", {Tone::accent, Dash::solid, 0.8}});
    drawing.panels.push_back(curvature_panel(before, after, target));
    drawing.columns = 2;
    return drawing;
}

Outcome run(std::span<const Input> inputs, const FairSurfaceOptions& options) {
    const PointGrid given = nodes_input(inputs);
    SurfaceFairing made = [&] {
        try {
            return fair_surface(given.nodes, options);
        } catch (const Error& error) {
            if (error.code().rfind("option.", 0) == 0) throw;
            throw error.at(inputs.front().name + ' ' + error.place());
        }
    }();
    made.report.notes.insert(made.report.notes.begin(), given.notes.begin(), given.notes.end());
    const Grid nodes = made.grid;
    return {rows_of(given, nodes),
            made.report.status,
            {},
            report_value(made.report),
            [before = given.nodes, nodes, options] {
                return picture(before, nodes, options.target);
            },
            {{"obj", [nodes] { return obj_mesh(nodes); }},
             {"ply", [nodes] { return ply_mesh(nodes); }},
             {"stl", [nodes] { return stl_mesh(nodes); }}}};
}

}  // namespace

Operation fair_surface_row() {
    return row<FairSurfaceOptions>({"fair-surface",
                                    "a noisy grid of points made fair, its curvature even",
                                    InputKind::grid, OutputKind::rows},
                                   run);
}

}  // namespace batten::api
