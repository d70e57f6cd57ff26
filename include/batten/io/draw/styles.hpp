#pragma once

#include <optional>

/// How lines look, in every kind of layer.
namespace batten {

/// The colours of the one theme, told apart by colour-blind readers too.
enum class Tone { ink, blue, accent, teal, ochre, violet, grey };

enum class Dash { solid, dashed, dotted };

/// Without a tone, curves and polylines take the tones from ink to violet in turn.
struct LineStyle {
    std::optional<Tone> tone = {};
    Dash dash = Dash::solid;
    double width = 1.7;  ///< pixels
};

}  // namespace batten
