#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "batten/base/fields.hpp"
#include "batten/shape/arc_chain.hpp"

namespace batten {

enum class GcodeUnits { mm, inch };

constexpr std::array<Named<GcodeUnits>, 2> names_of(GcodeUnits) {
    return {{{"mm", GcodeUnits::mm}, {"inch", GcodeUnits::inch}}};
}

struct GcodeOptions {
    double feed = 500;
    GcodeUnits units = GcodeUnits::mm;
    int decimals = 3;
    std::optional<double> z = {};
    std::string header = {};
    std::string footer = "M2";
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, GcodeOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("feed", o.feed, more_than(0), "speed along the path, in units a minute");
    visit("units", o.units, anything, "what the coordinates are in; they are not converted");
    visit("decimals", o.decimals, between(0, 9), "decimals of every coordinate");
    visit("z", o.z, anything, "height to go to, at the feed, before the first move");
    visit("header", o.header, anything, "lines to put in front");
    visit("footer", o.footer, anything, "lines to put at the end");
}

/// A chain of arcs as moves of a machine: G0 to its start, then G1, G2 (clockwise) and G3 with I
/// and J, the centre seen from the move's start.
///
/// Absolute coordinates (G90) in the xy plane (G17), G21 or G20 for the units. `feeds`, if not
/// empty, is one speed for each arc of the chain, in place of `feed`.
/// All is made from the rounded ends: the centre lies on the perpendicular bisector of the rounded
/// chord, rounded to that one of the four decimals around it whose radii to both ends differ least:
/// by no more than one last decimal. An arc whose sagitta is below half of the last decimal becomes
/// G1; one of more than half a circle two; one whose ends round to the same point is left out.
/// The path is within two last decimals of the chain.
/// Throws `option.range` for feeds that are not positive and finite or decimals outside 0 to 9,
/// `gcode.feeds` where there is not one for each arc, `gcode.too-large` where a coordinate has
/// more than 15 digits.
std::string gcode(const ArcChain& chain, const GcodeOptions& options = {},
                  std::span<const double> feeds = {});

}  // namespace batten
