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
#include "batten/make/sample_options.hpp"

/// What machines and drawing programs are told beside the curve: options of the operations whose
/// result can be written as G-code or DXF.
namespace batten::api {

struct MachineOptions {
    double feed = 500;
    Law feed_law = Law::constant;
    std::optional<double> max_lateral, max_tangential;
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
    visit("feed_law", o.feed_law, anything,
          "G-code: a law of motion for the speed of each arc, the fastest at the feed");
    visit("max_lateral", o.max_lateral, more_than(0),
          "G-code: speed^2 |curvature| not to exceed, in units a second^2 (time-optimal)");
    visit("max_tangential", o.max_tangential, more_than(0),
          "G-code: change of speed not to exceed, in units a second^2 (time-optimal)");
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

/// The forms `dxf` and, for chains of arcs and polylines in the plane, `gcode`.
std::vector<OutputForm> machine_forms(const Curve& curve, const MachineOptions& options);

}  // namespace batten::api
