#pragma once

#include <string>

#include "batten/io/draw/drawing.hpp"

namespace batten {

/// What gnuplot writes.
enum class ChartFormat { svg, png, pdf };

/// The drawing as a program for gnuplot 5, which writes the picture to its standard output: what
/// `svg(drawing)` shows, in gnuplot's own look.
///
/// Throws what `svg` throws, and `drawing.gnuplot` for what gnuplot is not asked to draw: combs,
/// arrows and control polygons; in space all but curves, lines, points and sheets.
std::string gnuplot_script(const Drawing& drawing, ChartFormat format);

}  // namespace batten
