#include "api/surface_values.hpp"

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/measure/graph_bend.hpp"

namespace batten::api {
namespace {

std::vector<Partial> partials_up_to(int order) {
    std::vector<Partial> all;
    for (int total = 0; total <= order; ++total) {
        for (int y = 0; y <= total; ++y) all.push_back({total - y, y});
    }
    return all;
}

std::string name_of_partial(Partial p) {
    if (p == Partial{}) return "z";
    return "z_" + std::string(static_cast<std::size_t>(p.x), 'x') +
           std::string(static_cast<std::size_t>(p.y), 'y');
}

Points places_of(const Surface& surface, const SurfaceQuestions& questions) {
    const Rectangle domain = domain_of(surface);
    if (questions.at.size() % 2 != 0) {
        throw Error("option.value", "at", std::to_string(questions.at.size()) + " numbers",
                    "places on a surface are pairs X,Y");
    }
    Points places(questions.at, 2);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::span<const double> place = places[i];
        if (domain.x.contains(place[0]) && domain.y.contains(place[1])) continue;
        throw Error("surface.outside", "at", format_number(place[0]) + ',' + format_number(place[1]),
                    "must lie in the surface's domain [" + format_number(domain.x.lo) + ", " +
                        format_number(domain.x.hi) + "] x [" + format_number(domain.y.lo) + ", " +
                        format_number(domain.y.hi) + "]");
    }
    const auto count = static_cast<std::size_t>(questions.count);
    if (count == 0) return places;
    const std::vector<double> x = even_places(domain.x, count), y = even_places(domain.y, count);
    for (const double across : x) {
        for (const double along : y) places.push_back(std::array{across, along});
    }
    return places;
}

std::string patches_json(const Surface& any) {
    const SplineSurface* const product = std::get_if<SplineSurface>(&any);
    if (!product) {
        throw Error("surface.patches", "format", "patches",
                    "between curved knot lines a surface is no polynomial of x and y: take json, "
                    "which is exact, or a mesh (obj, ply, stl)");
    }
    const SplineSurface& surface = *product;
    ValueList list;
    for (const BezierPatch& patch : bezier_patches(surface)) {
        const Rectangle& p = patch.part;
        list.push_back(ValueMap{{"domain", ValueList{p.x.lo, p.x.hi, p.y.lo, p.y.hi}},
                                {"heights", Value(patch.heights)}});
    }
    return dump_json(ValueMap{{"format", "batten.patches/1"},
                              {"degree_x", surface.x_basis().degree()},
                              {"degree_y", surface.y_basis().degree()},
                              {"patches", std::move(list)}});
}

}  // namespace

Rows surface_rows(const Surface& surface, const SurfaceQuestions& questions) {
    const Points places = places_of(surface, questions);
    const std::vector<Partial> partials = partials_up_to(questions.derivatives);
    Rows rows{{"x", "y"}, Points(0, 1)};
    for (const Partial p : partials) rows.names.push_back(name_of_partial(p));
    if (questions.curvature) {
        for (const char* const name : {"nx", "ny", "nz", "gaussian", "mean"}) {
            rows.names.push_back(name);
        }
    }
    rows.cells = Points(places.size(), static_cast<int>(rows.names.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double x = places(i, 0), y = places(i, 1);
        std::vector<double> row{x, y};
        for (const Partial p : partials) row.push_back(height_at(surface, x, y, p));
        if (questions.curvature) {
            const GraphBend bend = graph_bend(surface, x, y);
            row.insert(row.end(), bend.normal.begin(), bend.normal.end());
            row.insert(row.end(), {bend.gaussian, bend.mean});
        }
        std::copy(row.begin(), row.end(), rows.cells[i].begin());
    }
    return rows;
}

std::vector<OutputForm> surface_forms(const Surface& surface, std::vector<double> x,
                                      std::vector<double> y) {
    const MeshPlaces places{std::move(x), std::move(y)};
    const auto heights = [surface, places] { return heights_on(surface, places.x, places.y); };
    return {{"csv", [=] { return csv_grid(places.x, places.y, heights()); }},
            {"npy", [=] { return npy_grid(heights()); }},
            {"obj", [=] { return obj_mesh(surface, places); }},
            {"patches", [=] { return patches_json(surface); }},
            {"ply", [=] { return ply_mesh(surface, places); }},
            {"stl", [=] { return stl_mesh(surface, places); }}};
}

}  // namespace batten::api
