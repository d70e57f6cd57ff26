#pragma once

#include <string>

#include "batten/base/grid.hpp"
#include "batten/base/value.hpp"
#include "batten/io/files.hpp"
#include "batten/shape/surface.hpp"

namespace batten {

/// The tree of a `batten.surface/1` file: every number of the surface, exact.
///
/// Law: surface_of(surface_value(s)) is s, bit for bit.
Value surface_value(const SplineSurface& surface, const std::string& name = {});

/// The surface that such a tree describes. Throws `surface.format`, `surface.entry`, and what
/// BSplineBasis and SplineSurface throw.
SplineSurface surface_of(const Value& tree, const std::string& place);

/// A surface with curved knot lines, kind `curved-knots`, exact too.
Value surface_value(const CurvedKnotSurface& surface, const std::string& name = {});
CurvedKnotSurface curved_surface_of(const Value& tree, const std::string& place);

/// A surface of either kind.
Value surface_value(const Surface& surface, const std::string& name = {});
Surface any_surface_of(const Value& tree, const std::string& place);
/// Throws also what parse_json throws.
Surface parse_surface(const Source& source);
Surface read_surface(const std::string& path);

/// Whether a tree, or a file, calls itself a surface rather than a curve.
bool is_surface(const Value& tree);
bool holds_surface(const Source& source);

/// Points of a surface as a mesh of two triangles a cell, seen from above counter-clockwise: at
/// these places; where knot lines are curved, on lines that follow them (three columns between two
/// of them at least, where there are lines enough), about as many as there are places across, so
/// that fronts are sharp. Where the surface jumps both sides are joined by an upright wall.
struct MeshPlaces {
    std::vector<double> x, y;
};
/// Wavefront OBJ: vertices with normals, quadrilaterals.
std::string obj_mesh(const Surface& surface, const MeshPlaces& places);
/// STL, binary: single precision, as the format asks. Throws `number.overflow`.
std::string stl_mesh(const Surface& surface, const MeshPlaces& places);
/// PLY, binary little endian, vertices in double precision.
std::string ply_mesh(const Surface& surface, const MeshPlaces& places);

/// The same of a grid of points in space (3 values a node, none missing); OBJ without normals.
std::string obj_mesh(const GridView& nodes);
std::string stl_mesh(const GridView& nodes);
std::string ply_mesh(const GridView& nodes);

}  // namespace batten
