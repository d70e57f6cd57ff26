#include "io/draw/scene/ramp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

constexpr int tones = 7;

/// Two hexadecimal digits of `#rrggbb`.
int channel(std::string_view color, std::size_t k) {
    int value = 0;
    for (const char c : color.substr(1 + 2 * k, 2)) {
        value = 16 * value + (c <= '9' ? c - '0' : c - 'a' + 10);
    }
    return value;
}

/// `share` of `color`, the rest paper.
std::string on_paper(std::string_view color, double share) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (std::size_t k = 0; k < 3; ++k) {
        const double mixed = share * channel(color, k) + (1 - share) * channel(paper_color, k);
        const std::size_t value = static_cast<std::size_t>(std::lround(mixed));
        text += digits[value / 16];
        text += digits[value % 16];
    }
    return text;
}

using Colors = std::array<std::string, ramp_classes>;

Colors rising_colors() {
    Colors colors;
    for (int i = 0; i < ramp_classes; ++i) {
        const double share = 0.03 + 0.87 * i / (ramp_classes - 1);
        colors[static_cast<std::size_t>(i)] = on_paper(color_of(Tone::blue), share);
    }
    return colors;
}

/// Around 0 nearly paper, so that what is neither above nor below leans to neither colour.
Colors diverging_colors() {
    Colors colors;
    constexpr int half = ramp_classes / 2;
    static_assert(ramp_classes == 2 * half + 1, "0 lies in the middle of a class");
    colors[half] = on_paper(color_of(Tone::grey), 0.06);
    for (int i = 1; i <= half; ++i) {
        const double share = 0.06 + 0.92 * i / half;
        const std::size_t step = static_cast<std::size_t>(i);
        colors[half + step] = on_paper(color_of(Tone::accent), share);
        colors[half - step] = on_paper(color_of(Tone::blue), share);
    }
    return colors;
}

using Shades = std::array<std::string, tones * shade_classes>;

Shades all_shades() {
    Shades shades;
    for (int tone = 0; tone < tones; ++tone) {
        for (int i = 0; i < shade_classes; ++i) {
            const double share = 0.82 - 0.7 * i / (shade_classes - 1);
            shades[static_cast<std::size_t>(tone * shade_classes + i)] =
                on_paper(color_of(static_cast<Tone>(tone)), share);
        }
    }
    return shades;
}

}  // namespace

std::string_view ramp_color(Ramp ramp, int which) {
    static const Colors rising = rising_colors(), diverging = diverging_colors();
    return (ramp == Ramp::rising ? rising : diverging)[static_cast<std::size_t>(which)];
}

std::string_view shade_color(Tone tone, int which) {
    static const Shades shades = all_shades();
    return shades[static_cast<std::size_t>(static_cast<int>(tone) * shade_classes + which)];
}

int class_of(double x, Interval range, int classes) {
    const double width = 0.5 * range.hi - 0.5 * range.lo;
    if (!(width > 0)) return classes / 2;
    const double share = std::clamp((0.5 * x - 0.5 * range.lo) / width, 0.0, 1.0);
    return std::min(static_cast<int>(share * classes), classes - 1);
}

}  // namespace batten::drawing
