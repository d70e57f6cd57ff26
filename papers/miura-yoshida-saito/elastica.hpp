#pragma once

#include <cstddef>

#include "batten/shape/curve.hpp"

namespace batten::papers {

/// The points of the elastica that has the ends, the end tangents and the length of a curve: equal
/// steps whose turns have the least sum of squares. It knows nothing of the curve between its ends,
/// as Miura, Yoshida & Saito say of such methods.
///
/// Newton's method on the directions of the steps and two multipliers, from the curve's own.
Points elastica(const Curve& curve, std::size_t count);

}  // namespace batten::papers
