#pragma once

#include <cstddef>
#include <vector>

#include "make/densify/bubble.hpp"
#include "make/densify/cells.hpp"

namespace batten::lagrange {

/// Calls visit(cell, p, q, g) for every cell in order, `size` being the maker's terms and dim;
/// returns the cells that were tamed. Throws what `CellMaker::make` throws.
template <class Size, class Visit>
std::vector<std::size_t> run_cells(Size size, const CellMaker& maker, Visit&& visit) {
    std::vector<std::size_t> tamed;
    auto other = size.bubble_room();
    const CellMaker::Uniform uniform = maker.uniform();
    const auto one = [&](std::size_t cell) {
        if (!maker.make(cell, other)) tamed.push_back(cell);
        visit(cell, maker.start(cell), maker.end(cell), other.data());
    };
    for (std::size_t cell = 0; cell < uniform.first; ++cell) one(cell);
    auto g = size.bubble_room();
    const double* p = maker.start(uniform.first);
    for (std::size_t cell = uniform.first; cell < uniform.last; ++cell, p += size.dim) {
        const double* const q = p + size.dim;
        make_bubble(
            size, uniform.recipe, p, q,
            [&](std::size_t i) {
                return p + uniform.recipe.other[i] * static_cast<std::ptrdiff_t>(size.dim);
            },
            g.data());
        if (is_surely_tame(size, p, q, g.data())) {
            visit(cell, p, q, g.data());
        } else {
            one(cell);
        }
    }
    for (std::size_t cell = uniform.last; cell < maker.cells(); ++cell) one(cell);
    return tamed;
}

/// Calls run(size), with sizes known to the compiler for the usual ones.
template <class Run>
auto with_size(const CellMaker& maker, Run&& run) {
    const std::size_t terms = maker.terms(), dim = maker.dim();
    if (terms == 2 && dim == 2) return run(FixedSize<2, 2, 2>{});
    if (terms == 2 && dim == 3) return run(FixedSize<2, 3, 1>{});
    if (terms == 1 && dim == 2) return run(FixedSize<1, 2, 2>{});
    return run(RunTimeSize{terms, dim});
}

}  // namespace batten::lagrange
