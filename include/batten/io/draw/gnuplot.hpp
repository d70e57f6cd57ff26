#pragma once

#include <string>

#include "batten/io/draw/drawing.hpp"

namespace batten {

/// What gnuplot writes.
enum class ChartFormat { svg, png, pdf };

/// The drawing as a program for gnuplot 5.2 or later, which writes the picture to its standard
/// output: the picture that `svg(drawing)` is, shape by shape, in a font of gnuplot's.
///
/// Throws what `svg` throws. Cost: gnuplot takes about a millisecond for each colour of a sheet's
/// cells in turn, a second for a surface with its level lines.
std::string gnuplot_script(const Drawing& drawing, ChartFormat format);

}  // namespace batten
