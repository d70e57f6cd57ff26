#pragma once

#include <string>

#include "batten/io/draw/surface_plots.hpp"
#include "batten/make/fit_surface.hpp"

namespace papers {

/// Heights with one error for all.
struct SurfaceSet {
    std::string name;
    batten::Heights heights;
    double sigma = 1;

    batten::SurfaceSamples view() const { return {heights.x, heights.y, heights.z}; }
};

/// Figure 3.1: 61 x 51 equally spaced nodes, two Gaussian hills on a polynomial of degree 4 in x and
/// in y, errors of 1; the shipped set, rebuilt after the paper.
SurfaceSet equal_set(const std::string& cases);
/// Figure 3.2: the same truth at places at random.
SurfaceSet unequal_set();
/// In place of a chest X-ray, 128 x 130: two lungs with ribs, a spine and a heart.
SurfaceSet chest_set();
/// In place of a terrain, 100 x 101: hills and valleys at random.
SurfaceSet terrain_set();
/// In place of the light of a scintillator, 156 x 21 unequally spaced nodes: a steep front.
SurfaceSet scintillator_set();

}  // namespace papers
