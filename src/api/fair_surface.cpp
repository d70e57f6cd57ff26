#include "batten/make/fair_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "api/curvature_map.hpp"
#include "api/row.hpp"
#include "batten/base/error.hpp"
#include "batten/io/point_grid.hpp"
#include "batten/io/surface_file.hpp"

namespace batten::api {
namespace {

constexpr std::size_t most_lines_drawn = 40;
constexpr std::size_t most_lines_mapped = 80;
constexpr int maps_width = 960;

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

double curvature_at(const Grid& nodes, SurfaceTarget target, std::size_t i, std::size_t j) {
    return target == SurfaceTarget::gaussian ? gaussian_curvature(nodes, i, j)
                                             : mean_curvature(nodes, i, j);
}

/// Curvature along lines of constant v.
std::vector<Points> curvatures_of(const Grid& nodes, SurfaceTarget target) {
    std::vector<Points> runs;
    const std::size_t every = nodes.nv() / most_lines_drawn + 1;
    for (std::size_t j = 1; j + 1 < nodes.nv(); j += every) {
        runs.emplace_back(0, 2);
        for (std::size_t i = 1; i + 1 < nodes.nu(); ++i) {
            const double value = curvature_at(nodes, target, i, j);
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
    panel.caption = name_of(target) + ", line by line";
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

/// By how much rounded coordinates may move the normal curvatures at inner node (i, j): second
/// differences of coordinates over the squared shortest chord.
double bend_rounding(const Grid& nodes, std::size_t i, std::size_t j) {
    double reach = 0, u_sq = 0, v_sq = 0;
    for (int k = 0; k < 3; ++k) {
        const double here = nodes(i, j, k);
        const double along_u = nodes(i + 1, j, k) - here, along_v = nodes(i, j + 1, k) - here;
        reach = std::fmax(reach, std::fabs(here));
        u_sq += along_u * along_u;
        v_sq += along_v * along_v;
    }
    return 32 * std::numeric_limits<double>::epsilon() * reach / std::fmin(u_sq, v_sq);
}

/// The curvature of the inner nodes, or of every few of many.
CurvatureField curvatures_of(const PointGrid& grid, SurfaceTarget target) {
    const Grid& nodes = grid.nodes;
    const std::size_t every_u = nodes.nu() / most_lines_mapped + 1;
    const std::size_t every_v = nodes.nv() / most_lines_mapped + 1;
    CurvatureField field{target, {}, {}};
    for (std::size_t i = 1; i + 1 < nodes.nu(); i += every_u) field.u.push_back(grid.u[i]);
    for (std::size_t j = 1; j + 1 < nodes.nv(); j += every_v) field.v.push_back(grid.v[j]);
    field.values = Grid(field.u.size(), field.v.size());
    for (std::size_t p = 0; p < field.u.size(); ++p) {
        for (std::size_t q = 0; q < field.v.size(); ++q) {
            const std::size_t i = 1 + p * every_u, j = 1 + q * every_v;
            field.values(p, q) = curvature_at(nodes, target, i, j);
            field.allow(gaussian_curvature(nodes, i, j), mean_curvature(nodes, i, j),
                        bend_rounding(nodes, i, j));
        }
    }
    return field;
}

Drawing picture(const Grid& before, const PointGrid& faired, SurfaceTarget target) {
    const Grid& after = faired.nodes;
    Drawing drawing;
    drawing.width = maps_width;
    drawing.panels.front().caption = "nodes";
    drawing.add(PolylineLayer{lines_of(before), "nodes", {Tone::grey, Dash::solid, 0.6}});
    drawing.add(PolylineLayer{lines_of(after), "faired", {Tone::accent, Dash::solid, 0.8}});
    drawing.panels.push_back(curvature_panel(before, after, target));
    for (const SurfaceTarget curvature : {SurfaceTarget::gaussian, SurfaceTarget::mean}) {
        drawing.panels.push_back(curvature_map(curvatures_of(faired, curvature), ", faired"));
    }
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
            [given, nodes, options] {
                return picture(given.nodes, {given.u, given.v, nodes, {}}, options.target);
            },
            {{"obj", [nodes] { return obj_mesh(nodes); }},
             {"ply", [nodes] { return ply_mesh(nodes); }},
             {"stl", [nodes] { return stl_mesh(nodes); }}}};
}

}  // namespace

Operation fair_surface_row() {
    return row<FairSurfaceOptions>({"fair-surface",
                                    "a noisy grid of points made fair, its curvature even",
                                    InputKind::grid, OutputKind::rows, {"obj", "ply", "stl"}},
                                   run);
}

}  // namespace batten::api
