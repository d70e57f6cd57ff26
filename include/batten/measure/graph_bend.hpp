#pragma once

#include <array>

#include "batten/shape/surface.hpp"

namespace batten {

/// How the graph z = S(x, y) bends at a point. The normal points up; the mean curvature is positive
/// where the graph bends up, so that a bowl has a positive one.
struct GraphBend {
    std::array<double, 3> normal{};
    double gaussian = 0;
    double mean = 0;
    double largest = 0, least = 0;  ///< principal curvatures
};

/// Accuracy: a few ulps of the second derivatives. Throws nothing.
/// Source: [DoCarmo1976, 3.3, example 5].
GraphBend graph_bend(const HeightJet& jet);
inline GraphBend graph_bend(const Surface& surface, double x, double y) {
    return graph_bend(jet_at(surface, x, y));
}

}  // namespace batten
