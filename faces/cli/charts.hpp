#pragma once

#include <string>

#include "batten/io/draw/drawing.hpp"

namespace batten::cli {

/// The picture as a file of that suffix: svg by Batten itself, png and pdf by gnuplot.
///
/// Throws `output.format` for another suffix, `output.gnuplot` where gnuplot is missing or fails,
/// and what the drawing throws.
std::string picture(const Drawing& drawing, const std::string& suffix);

}  // namespace batten::cli
