#pragma once

#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/io/dxf.hpp"
#include "batten/io/gcode.hpp"

/// What machines and drawing programs are told beside the curve: options of the operations whose
/// result can be written as G-code or DXF.
namespace batten::api {

struct MachineOptions {
    double feed = 500;
    std::optional<GcodeUnits> units;
    int decimals = 3;
    std::optional<double> z;
    std::string header;
    std::string footer = "M2";
    DxfVersion dxf_version = DxfVersion::r2000;
    DxfArcs dxf_arcs = DxfArcs::polyline;
    std::string layer = "0";
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, MachineOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("feed", o.feed, more_than(0), "G-code: speed along the path, in units a minute");
    visit("units", o.units, anything,
          "what the coordinates are in, not converted (G-code mm, DXF none unless given)");
    visit("decimals", o.decimals, between(0, 9), "G-code: decimals of every coordinate");
    visit("z", o.z, anything, "G-code: height to go to, at the feed, before the first move");
    visit("header", o.header, anything, "G-code: lines to put in front");
    visit("footer", o.footer, anything, "G-code: lines to put at the end");
    visit("dxf_version", o.dxf_version, anything, "DXF: its version; r12 knows no splines");
    visit("dxf_arcs", o.dxf_arcs, anything,
          "DXF: arcs as one polyline with bulges, or one entity each");
    visit("layer", o.layer, anything, "DXF: name of the layer");
}

/// The forms `dxf` and, for chains of arcs and polylines in the plane, `gcode`. `feeds`: one speed
/// for each arc, in place of the one feed.
std::vector<OutputForm> machine_forms(const Curve& curve, const MachineOptions& options,
                                      const std::vector<double>& feeds = {});

}  // namespace batten::api
