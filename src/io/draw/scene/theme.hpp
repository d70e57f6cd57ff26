#pragma once

#include <string_view>

#include "batten/io/draw/layers.hpp"

/// The look of every picture, in one place. Lengths in pixels.
namespace batten::drawing {

inline constexpr std::string_view paper_color = "#ffffff";
inline constexpr std::string_view ink_color = "#1f2933";
inline constexpr std::string_view text_color = "#52606d";
inline constexpr std::string_view grid_color = "#e9edf1";
inline constexpr std::string_view axis_color = "#b8c2cc";
inline constexpr std::string_view shadow_color = "#d5dbe1";
inline constexpr std::string_view fonts =
    "Inter, 'Helvetica Neue', Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif";

/// The six tones for curves differ by at least 28 in CIE76 from one another, also as protanopes,
/// deuteranopes and tritanopes see them [Machado2009, table 1].
constexpr std::string_view color_of(Tone tone) {
    switch (tone) {
        case Tone::ink: return ink_color;
        case Tone::blue: return "#2b5cb8";
        case Tone::accent: return "#c6401a";
        case Tone::teal: return "#1fae86";
        case Tone::ochre: return "#eda924";
        case Tone::violet: return "#a58cc8";
        case Tone::grey: break;
    }
    return "#8a96a3";
}

inline constexpr double margin = 20;
inline constexpr double title_size = 16;
inline constexpr double subtitle_size = 12;
inline constexpr double caption_size = 13;
inline constexpr double label_size = 11;
inline constexpr double index_size = 9.5;
inline constexpr double numbers_width = 46;  ///< room for the numbers left of a panel
inline constexpr double numbers_height = 20;
inline constexpr double tick_length = 10;
inline constexpr double arrow_length = 34;

}  // namespace batten::drawing
