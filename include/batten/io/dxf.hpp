#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <type_traits>

#include "batten/base/fields.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

enum class DxfVersion {
    r12,    ///< AC1009: lines, arcs and polylines, read by everything
    r2000,  ///< AC1015: also splines
};

constexpr std::array<Named<DxfVersion>, 2> names_of(DxfVersion) {
    return {{{"r12", DxfVersion::r12}, {"r2000", DxfVersion::r2000}}};
}

/// What a chain of arcs becomes.
enum class DxfArcs {
    polyline,  ///< one polyline with bulges
    separate,  ///< an ARC or a LINE each
};

constexpr std::array<Named<DxfArcs>, 2> names_of(DxfArcs) {
    return {{{"polyline", DxfArcs::polyline}, {"separate", DxfArcs::separate}}};
}

/// The drawing's unit, for programs that ask; coordinates are written as they are.
enum class DxfUnits { none, inch, mm, cm, m };

constexpr std::array<Named<DxfUnits>, 5> names_of(DxfUnits) {
    return {{{"none", DxfUnits::none},
             {"inch", DxfUnits::inch},
             {"mm", DxfUnits::mm},
             {"cm", DxfUnits::cm},
             {"m", DxfUnits::m}}};
}

struct DxfOptions {
    DxfVersion version = DxfVersion::r2000;
    DxfArcs arcs = DxfArcs::polyline;
    DxfUnits units = DxfUnits::none;
    std::string layer = "0";
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, DxfOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("version", o.version, anything, "version of the format; r12 knows no splines");
    visit("arcs", o.arcs, anything, "arcs as one polyline with bulges, or one entity each");
    visit("units", o.units, anything, "the unit of the coordinates");
    visit("layer", o.layer, anything, "name of the layer");
}

/// A DXF drawing of the curves [Autodesk1999, "ENTITIES Section"].
///
/// | curve | r2000 | r12 |
/// |---|---|---|
/// | `ArcChain` | LWPOLYLINE with bulges, or ARC and LINE | POLYLINE with bulges, or ARC and LINE |
/// | straight pieces in the plane | LWPOLYLINE | POLYLINE |
/// | straight pieces in space | POLYLINE (3-D) | the same |
/// | `BSplineCurve` of degree 2 or 3, rational too | SPLINE, its own knots | error |
/// | other cubic pieces | SPLINE: Bezier pieces, every knot three times | error |
///
/// Numbers in their shortest form that reads back to the same double: splines, polylines and lines
/// are exact; ARC has its centre, radius and angles (degrees) rounded once more, so its ends meet
/// their neighbours within a few ulps of the radius only.
/// Throws `curve.dimension` for curves neither plane nor in space; `dxf.needs-r2000` for a spline
/// in r12; `curve.not-exact` for what none of these holds: convert it first; `dxf.layer` unless the
/// layer's name is 1 to 31 letters, digits, `$`, `-` or `_`; `number.overflow`.
std::string dxf(std::span<const Curve> curves, const DxfOptions& options = {});
std::string dxf(const Curve& curve, const DxfOptions& options = {});

}  // namespace batten
