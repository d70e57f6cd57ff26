#pragma once

#include <string>

#include "batten/io/draw/drawing.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten::api {

/// A curve as a layer; one with jumps as a layer a part, all in one tone.
inline void add_parts(Drawing& drawing, const Curve& curve, const std::string& name = {},
                      Tone tone = Tone::ink) {
    if (!has_jumps(curve)) {
        drawing.add(CurveLayer{curve, name, {}});
        return;
    }
    std::string label = name;
    for (const Curve& part : parts_between_jumps(curve)) {
        drawing.add(CurveLayer{part, label, {tone}});
        label.clear();
    }
}

}  // namespace batten::api
