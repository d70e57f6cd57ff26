#pragma once

#include <cstddef>
#include <vector>

#include "batten/base/grid.hpp"

/// Which lattice edges a level crosses, one after the other.
namespace batten::contouring {

/// The edge from node (i, j) to (i + 1, j), or to (i, j + 1).
struct LatticeEdge {
    std::size_t i = 0, j = 0;
    bool is_along_x = true;
};

struct Chain {
    std::vector<LatticeEdge> edges;
    bool is_closed = false;
};

/// `above(i, j)`: the nodes' signs; `middles(i, j)`: heights in the middle of cells less the level,
/// which tell how saddles connect. Every crossed edge is in one chain.
std::vector<Chain> chains_of(GridView above, GridView middles);

}  // namespace batten::contouring
