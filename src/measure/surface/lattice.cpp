#include "measure/surface/lattice.hpp"

#include <algorithm>
#include <cmath>

namespace batten::contouring {
namespace {

using surfaces::Sheet;

constexpr std::size_t cells_a_piece = 8;
constexpr std::size_t least_cells = 64;

std::size_t cells_of_each(std::size_t count) {
    return std::max(cells_a_piece, (least_cells + count - 1) / count);
}

/// The bends of `cells` edges between nodes `stride` apart: second differences, continued
/// straight to the outer two nodes.
void add_bends(const double* z, std::size_t stride, std::size_t cells, double* out) {
    const auto second = [&](std::size_t k) {
        return z[(k - 1) * stride] - 2 * z[k * stride] + z[(k + 1) * stride];
    };
    double before = 2 * second(1) - second(2);
    for (std::size_t k = 1; k <= cells; ++k) {
        const double here =
            k < cells ? second(k) : 2 * second(cells - 1) - second(cells - 2);
        out[(k - 1) * stride] = std::max(std::fabs(before), std::fabs(here));
        before = here;
    }
}

/// The cells of the interval that starts with line `first`.
std::size_t cells_from(const Lattice& lattice, std::size_t first) {
    const std::size_t interval = lattice.lines[first].interval;
    std::size_t last = first;
    while (last + 1 < lattice.lines.size() && lattice.lines[last].interval == interval &&
           lattice.lines[last].share < 1) {
        ++last;
    }
    return last - first;
}

}  // namespace

Lattice lattice_of(const Sheet& sheet) {
    const std::size_t count = sheet.intervals().size();
    Lattice lattice{sheet.lines(std::vector<std::size_t>(count, cells_of_each(count))), {}, 0};
    const std::vector<double> strips = sheet.strips();
    lattice.row_cells = cells_of_each(strips.size() - 1);
    for (std::size_t p = 0; p + 1 < strips.size(); ++p) {
        const Interval strip{strips[p], strips[p + 1]};
        for (std::size_t k = 0; k < lattice.row_cells; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(lattice.row_cells);
            lattice.rows.push_back(strip.lo + share * strip.length());
        }
    }
    lattice.rows.push_back(strips.back());
    return lattice;
}

LatticeBends bends_of(const Lattice& lattice, GridView z) {
    LatticeBends bends{Grid(z.nu(), z.nv()), Grid(z.nu(), z.nv())};
    const double* const heights = z.values().data();
    for (std::size_t first = 0; first + 1 < z.nu();) {
        const std::size_t cells = cells_from(lattice, first);
        for (std::size_t j = 0; j < z.nv() && cells > 0; ++j) {
            add_bends(heights + first * z.nv() + j, z.nv(), cells, &bends.along_x(first, j));
        }
        first += std::max<std::size_t>(cells, 1);
    }
    for (std::size_t i = 0; i < z.nu(); ++i) {
        for (std::size_t j = 0; j + 1 < z.nv(); j += lattice.row_cells) {
            add_bends(heights + i * z.nv() + j, 1, lattice.row_cells, &bends.along_y(i, j));
        }
    }
    return bends;
}

}  // namespace batten::contouring
