#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>

#include "api/curvature_map.hpp"
#include "api/row.hpp"
#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/measure/surface.hpp"

namespace batten::api {
namespace {

struct CoonsOptions {
    bool zebra = false;
    std::vector<double> eye;
    std::vector<double> axis{0, 0, 1};
    int stripes = 12;
    int count = 33;
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, CoonsOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("zebra", o.zebra, anything, "draw what tubes of light around the axis look like, mirrored");
    visit("eye", o.eye, anything, "X,Y,Z: where the eye is; without it far in front, above");
    visit("axis", o.axis, anything, "X,Y,Z: the direction of the axis of the tubes");
    visit("stripes", o.stripes, between(1, 1000), "dark stripes around the axis");
    visit("count", o.count, between(2, 1000), "points along each side of what is written");
}

struct CurvatureRange {
    double min = 0;
    double max = 0;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, CurvatureRange>
void visit_fields(Report& r, Visit&& visit) {
    visit("min", r.min, "least");
    visit("max", r.max, "largest");
}

struct CoonsReport {
    CurvatureRange gaussian_curvature;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, CoonsReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("gaussian_curvature", r.gaussian_curvature, "least and largest Gaussian curvature");
}

CoonsPatch patch_of(std::span<const Input> inputs) {
    std::vector<Curve> edges;
    for (const Input& input : inputs) {
        const Curve* curve = std::get_if<Curve>(&input.content);
        if (!curve) throw Error("input.kind", input.name, "points", "this operation takes curves");
        edges.push_back(*curve);
    }
    if (edges.size() != 4) {
        throw Error("input.count", "input", std::to_string(edges.size()),
                    "a patch has four edges: two along u at v = 0 and 1, two along v");
    }
    return {edges[0], edges[1], edges[2], edges[3]};
}

std::array<double, 3> triple(const std::vector<double>& numbers, const char* name) {
    if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
    throw Error("option.value", name, std::to_string(numbers.size()) + " numbers",
                "must be three numbers X,Y,Z");
}

Rows samples(const CoonsPatch& patch, int count) {
    Rows rows{{"u", "v", "x", "y", "z", "gaussian", "mean"}, Points(0, 7)};
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const double u = double(i) / (count - 1), v = double(j) / (count - 1);
            const SurfaceJet jet = patch.jet(u, v);
            const SurfaceBend bend = surface_bend(jet).value_or(SurfaceBend{});
            rows.cells.push_back(std::array{u, v, jet.point[0], jet.point[1], jet.point[2],
                                            bend.gaussian, bend.mean});
        }
    }
    return rows;
}

Grid nodes_of(const CoonsPatch& patch, int count) {
    const std::size_t n = static_cast<std::size_t>(count);
    Grid nodes(n, n, 3);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const auto point = patch.jet(double(i) / (count - 1), double(j) / (count - 1)).point;
            for (std::size_t k = 0; k < 3; ++k) nodes(i, j, static_cast<int>(k)) = point[k];
        }
    }
    return nodes;
}

/// The patch, exact: its four edges.
std::string json_of(std::span<const Input> inputs) {
    ValueList edges;
    for (const Input& input : inputs) {
        edges.push_back(curve_value(std::get<Curve>(input.content)));
    }
    return dump_json(ValueMap{{"format", "batten.coons/1"}, {"edges", std::move(edges)}});
}

/// The dark stripes along one v, from u = 0 to 1.
std::vector<Points> stripes_along(const CoonsPatch& patch, double v, const ZebraView& view) {
    constexpr int steps = 600;
    std::vector<Points> runs;
    bool is_drawing = false;
    for (int i = 0; i <= steps; ++i) {
        const SurfaceJet jet = patch.jet(double(i) / steps, v);
        const std::optional<double> angle = zebra_angle(jet, view);
        const bool draws = angle && is_dark(*angle, view.stripes);
        if (draws && !is_drawing) runs.emplace_back(0, 3);
        // Ends exactly, and so many between that no bend of a sensible patch is lost.
        const bool ends = draws != is_drawing || i == steps;
        if ((draws || is_drawing) && (ends || i % 12 == 0)) runs.back().push_back(jet.point);
        is_drawing = draws;
    }
    return runs;
}

void add_stripes(Drawing& drawing, const CoonsPatch& patch, const ZebraView& view) {
    constexpr int lines = 160;
    std::vector<Points> runs;
    for (int j = 0; j <= lines; ++j) {
        for (Points& run : stripes_along(patch, double(j) / lines, view)) {
            if (run.size() > 1) runs.push_back(std::move(run));
        }
    }
    if (!runs.empty()) {
        drawing.add(PolylineLayer{runs, {}, {Tone::ink, Dash::solid, 2.2}});
    }
}

/// The patch as a lit sheet with lines of equal u and of equal v.
SheetLayer sheet_of(const CoonsPatch& patch) {
    constexpr int cells = 36, cells_a_line = 4;
    SheetLayer sheet;
    sheet.nodes = Grid(cells + 1, cells + 1, 3);
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            const auto point = patch.jet(double(i) / cells, double(j) / cells).point;
            for (int k = 0; k < 3; ++k) {
                sheet.nodes(static_cast<std::size_t>(i), static_cast<std::size_t>(j), k) =
                    point[static_cast<std::size_t>(k)];
            }
        }
    }
    for (int i = 0; i <= cells; i += cells_a_line) {
        const double at = i;
        const LineStyle line{Tone::blue, Dash::solid, i % cells == 0 ? 1.4 : 0.6};
        sheet.lines.push_back({Points({at, 0, at, cells}, 2), line});
        sheet.lines.push_back({Points({0, at, cells, at}, 2), line});
    }
    return sheet;
}

Points border_of(const CoonsPatch& patch) {
    constexpr int steps = 100;
    Points border(0, 3);
    for (int side = 0; side < 4; ++side) {
        for (int i = 0; i <= steps; ++i) {
            const double x = double(i) / steps;
            const double u = side == 0 ? x : side == 1 ? 1 : side == 2 ? 1 - x : 0;
            const double v = side == 0 ? 0 : side == 1 ? x : side == 2 ? 1 : 1 - x;
            border.push_back(patch.jet(u, v).point);
        }
    }
    return border;
}

/// By how much rounded coordinates may move the normal curvatures.
double bend_rounding(const SurfaceJet& jet) {
    const auto size = [](const std::array<double, 3>& a) { return std::hypot(a[0], a[1], a[2]); };
    const double least = std::fmin(size(jet.u), size(jet.v));
    const double most = std::fmax(size(jet.point), std::fmax(size(jet.u), size(jet.v)));
    return 64 * std::numeric_limits<double>::epsilon() * most / (least * least);
}

CurvatureField curvatures_of(const CoonsPatch& patch, SurfaceTarget curvature) {
    constexpr std::size_t cells = 60;
    CurvatureField field{curvature, {}, {}, Grid(cells + 1, cells + 1)};
    for (std::size_t i = 0; i <= cells; ++i) {
        field.u.push_back(double(i) / cells);
        field.v.push_back(double(i) / cells);
    }
    for (std::size_t i = 0; i <= cells; ++i) {
        for (std::size_t j = 0; j <= cells; ++j) {
            const SurfaceJet jet = patch.jet(field.u[i], field.v[j]);
            const auto bend = surface_bend(jet);
            if (!bend) {
                field.values.drop(i, j);
                continue;
            }
            field.values(i, j) = curvature == SurfaceTarget::mean ? bend->mean : bend->gaussian;
            field.allow(bend->gaussian, bend->mean, bend_rounding(jet));
        }
    }
    return field;
}

Drawing picture(const CoonsPatch& patch, const std::optional<ZebraView>& view) {
    Drawing drawing;
    if (!view) {
        drawing.add(sheet_of(patch));
        drawing.panels.front().caption = "the patch";
        for (const SurfaceTarget curvature : {SurfaceTarget::gaussian, SurfaceTarget::mean}) {
            drawing.panels.push_back(curvature_map(curvatures_of(patch, curvature)));
        }
        return drawing;
    }
    add_stripes(drawing, patch, *view);
    drawing.add(PolylineLayer{{border_of(patch)}, {}, {Tone::blue, Dash::solid, 1.4}});
    return drawing;
}

/// Ten extents away along the diagonal of the axes that pictures are seen from.
std::array<double, 3> far_eye(const CoonsPatch& patch) {
    const auto low = patch.jet(0, 0).point, high = patch.jet(1, 1).point;
    const double reach = 10 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    return {low[0] + reach, low[1] - reach, low[2] + reach};
}

Outcome run(std::span<const Input> inputs, const CoonsOptions& options) {
    const CoonsPatch patch = patch_of(inputs);
    const Interval range = gaussian_range(patch);
    std::optional<ZebraView> view;
    if (options.zebra) {
        view = ZebraView{options.eye.empty() ? far_eye(patch) : triple(options.eye, "eye"),
                         triple(options.axis, "axis"), options.stripes};
    }
    return {samples(patch, options.count), Status::met, {},
            report_value(CoonsReport{{range.lo, range.hi}}),
            [patch, view] { return picture(patch, view); },
            {{"json", [edges = std::vector<Input>(inputs.begin(), inputs.end())] {
                  return json_of(edges);
              }},
             {"obj", [=] { return obj_mesh(nodes_of(patch, options.count)); }},
             {"ply", [=] { return ply_mesh(nodes_of(patch, options.count)); }},
             {"stl", [=] { return stl_mesh(nodes_of(patch, options.count)); }}}};
}

}  // namespace

Operation coons_row() {
    return row<CoonsOptions>({"coons", "the bilinear Coons patch of four curves, and its curvature",
                              InputKind::curve, OutputKind::rows, {"obj", "ply", "stl"}, true},
                             run);
}

}  // namespace batten::api
