#include "api/machine_options.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/make/sample.hpp"
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

/// The feed to six digits, not above: more no machine reads.
double short_feed(double feed) {
    constexpr double kept = 1 + 0x1p-40;  // numbers of six digits stay what they are
    const double digits = std::pow(10.0, 5 - std::floor(std::log10(feed)));
    const double shorter = std::floor(feed * digits * kept) / digits;
    return shorter > 0 && std::isfinite(shorter) ? shorter : feed;
}

/// The speed of each arc in units a minute; none where all have the one feed.
std::vector<double> feeds_for(const ArcChain& moves, const MachineOptions& options) {
    if (options.feed_law == Law::constant) return {};
    constexpr double seconds = 60;  // a minute: the limits are told by the second
    SampleOptions walk;
    walk.law = options.feed_law;
    if (options.feed_law == Law::time_optimal) walk.max_speed = options.feed / seconds;
    walk.max_lateral = options.max_lateral;
    walk.max_tangential = options.max_tangential;
    std::vector<double> feeds = piece_speeds(moves, walk);
    const double fastest =
        walk.max_speed ? *walk.max_speed : *std::max_element(feeds.begin(), feeds.end());
    for (double& feed : feeds) feed = short_feed(feed * (options.feed / fastest));
    return feeds;
}

std::string program_for(const Curve& curve, const MachineOptions& options) {
    const ArcChain moves = moves_of(curve);
    return gcode(moves, gcode_options(options), feeds_for(moves, options));
}

}  // namespace

std::vector<OutputForm> machine_forms(const Curve& curve, const MachineOptions& options) {
    return {{"dxf", [curve, options] { return dxf(curve, dxf_options(options)); }},
            {"gcode", [curve, options] { return program_for(curve, options); }}};
}

}  // namespace batten::api
