#pragma once

#include <array>
#include <vector>

#include "batten/io/draw/drawing.hpp"
#include "io/draw/shapes/comb.hpp"
#include "io/draw/shapes/frame.hpp"
#include "io/draw/shapes/trace.hpp"

namespace batten::drawing {

/// A layer with everything that can be known before the panel has its place on the paper.
struct ReadyLayer {
    const Layer* layer = nullptr;
    Tone tone = Tone::ink;
    Trace trace;
    Comb comb;
    double peak = 0;  ///< the largest curvature of a comb, per data unit
};

struct ReadyPanel {
    const Panel* panel = nullptr;
    std::vector<ReadyLayer> layers;
    Box box;  ///< what is shown, on the axes' scales; in space without the air around
    std::array<bool, 3> is_log{};
    double padding = 0;  ///< pixels that markers, arrows and labels need beyond the box
    bool is_cut = false;  ///< whether there may be something outside of the box
};

/// Checks a drawing and makes everything that does not depend on the layout. Throws as
/// `svg(const Drawing&)` says.
std::vector<ReadyPanel> prepare(const Drawing& drawing);

/// The name of a layer in the legend, or an empty one.
const std::string& name_of(const Layer& layer);

}  // namespace batten::drawing
