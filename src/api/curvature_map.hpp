#pragma once

#include <string>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/make/fair_surface.hpp"

namespace batten::api {

/// One of the two curvatures of a surface over its parameters.
struct CurvatureField {
    SurfaceTarget curvature = SurfaceTarget::gaussian;
    std::vector<double> u, v;  ///< rising
    Grid values{0, 0};         ///< u.size() x v.size(); nodes without a normal are missing
    double rounding = 0;       ///< by how much values may differ and yet be the same

    /// Widens `rounding` for a node of these curvatures, where rounded coordinates move the normal
    /// curvatures by `off`.
    void allow(double gaussian, double mean, double off);
};

std::string name_of(SurfaceTarget curvature);

/// Colours on a scale symmetric about 0; where the curvature is the same all over but for rounding
/// the caption says so, in place of a map of rounding. `of` follows its name in the caption.
Panel curvature_map(CurvatureField field, const std::string& of = {});

}  // namespace batten::api
