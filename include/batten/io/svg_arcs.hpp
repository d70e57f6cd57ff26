#pragma once

#include <string>

#include "batten/shape/arc_chain.hpp"

namespace batten {

/// A chain of arcs as SVG path data with true arcs (`A`) and lines (`L`), in data coordinates (y
/// up), numbers in their shortest exact form; `Z` where it is closed [SVG2, chapter 9].
///
/// The ends are exact; the radius is rounded once, and a reader makes the centre from it: for half
/// a circle and thereabouts it may be off by the radius times the root of an ulp.
std::string svg_path(const ArcChain& chain);

}  // namespace batten
