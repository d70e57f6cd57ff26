#include "batten/measure/level_lines.hpp"

#include <array>
#include <string>

#include "batten/base/error.hpp"
#include "measure/surface/chains.hpp"

namespace batten {
namespace {

struct LevelGrid {
    std::span<const double> x, y;
    GridView z;
    double level;

    bool has(const contouring::LatticeEdge& edge) const {
        return z.has(edge.i, edge.j) &&
               (edge.is_along_x ? z.has(edge.i + 1, edge.j) : z.has(edge.i, edge.j + 1));
    }

    std::array<double, 2> crossing(const contouring::LatticeEdge& edge) const {
        const std::size_t i = edge.i, j = edge.j;
        const double from = z(i, j), to = edge.is_along_x ? z(i + 1, j) : z(i, j + 1);
        // Halved, since the difference of two doubles may be none.
        const double share = (0.5 * level - 0.5 * from) / (0.5 * to - 0.5 * from);
        if (edge.is_along_x) return {(1 - share) * x[i] + share * x[i + 1], y[j]};
        return {x[i], (1 - share) * y[j] + share * y[j + 1]};
    }
};

void add_runs(std::vector<Points>& runs, const LevelGrid& grid, const contouring::Chain& chain) {
    Points run(0, 2);
    const auto finish = [&] {
        if (run.size() > 1) runs.push_back(std::move(run));
        run = Points(0, 2);
    };
    for (const contouring::LatticeEdge& edge : chain.edges) {
        if (grid.has(edge)) run.push_back(grid.crossing(edge));
        else finish();
    }
    if (chain.is_closed && grid.has(chain.edges.front()) && !run.empty()) {
        run.push_back(grid.crossing(chain.edges.front()));
    }
    finish();
}

}  // namespace

std::vector<Points> level_lines(std::span<const double> x, std::span<const double> y, GridView z,
                                double level) {
    if (x.size() != z.nu() || y.size() != z.nv() || x.size() < 2 || y.size() < 2) {
        throw Error("grid.places", "x and y",
                    std::to_string(x.size()) + " and " + std::to_string(y.size()) + " places",
                    "the grid has " + std::to_string(z.nu()) + " x " + std::to_string(z.nv()) +
                        " nodes, two at least each way");
    }
    Grid above(z.nu(), z.nv()), middles(z.nu() - 1, z.nv() - 1);
    for (std::size_t i = 0; i < z.nu(); ++i) {
        for (std::size_t j = 0; j < z.nv(); ++j) {
            above(i, j) = z.has(i, j) && z(i, j) >= level ? 1 : 0;
            if (i + 1 == z.nu() || j + 1 == z.nv()) continue;
            middles(i, j) = 0.25 * z(i, j) + 0.25 * z(i + 1, j) + 0.25 * z(i, j + 1) +
                            0.25 * z(i + 1, j + 1) - level;
        }
    }
    std::vector<Points> runs;
    for (const contouring::Chain& chain : contouring::chains_of(above, middles)) {
        add_runs(runs, {x, y, z, level}, chain);
    }
    return runs;
}

}  // namespace batten
