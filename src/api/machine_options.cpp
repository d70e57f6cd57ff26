#include "api/machine_options.hpp"

#include <utility>

#include "batten/base/error.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/transform.hpp"

namespace batten::api {
namespace {

GcodeOptions gcode_options(const MachineOptions& options) {
    GcodeOptions result;
    result.feed = options.feed;
    result.units = options.units.value_or(GcodeUnits::mm);
    result.decimals = options.decimals;
    result.z = options.z;
    result.header = options.header;
    result.footer = options.footer;
    return result;
}

DxfOptions dxf_options(const MachineOptions& options) {
    DxfOptions result;
    result.version = options.dxf_version;
    result.arcs = options.dxf_arcs;
    result.layer = options.layer;
    if (options.units == GcodeUnits::mm) result.units = DxfUnits::mm;
    if (options.units == GcodeUnits::inch) result.units = DxfUnits::inch;
    return result;
}

/// The moves of a machine: the chain itself, or the lines of a polyline.
ArcChain moves_of(const Curve& curve) {
    if (const ArcChain* chain = curve.shape<ArcChain>()) return *chain;
    std::optional<Points> joints = exact_polyline(curve);
    if (curve.dim() != 2 || !joints) {
        throw Error("curve.not-exact", "curve",
                    curve.dim() != 2 ? std::to_string(curve.dim()) + " coordinates" : "no arcs",
                    "G-code takes arcs and lines of the plane: convert the curve to arcs first");
    }
    return {*std::move(joints), std::vector<double>(curve.pieces(), 0.0)};
}

}  // namespace

std::vector<OutputForm> machine_forms(const Curve& curve, const MachineOptions& options,
                                      const std::vector<double>& feeds) {
    return {{"dxf", [curve, options] { return dxf(curve, dxf_options(options)); }},
            {"gcode", [curve, options, feeds] {
                 return gcode(moves_of(curve), gcode_options(options), feeds);
             }}};
}

}  // namespace batten::api
