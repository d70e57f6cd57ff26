#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "batten/api/operation.hpp"

/// Inputs that hold several curves.
namespace batten::api {

/// Each curve as an input of its own, called by the file's name and its number from 0.
std::vector<Input> single_curves(const Input& several);

/// `inputs` with each curve as an input of its own.
std::vector<Input> with_single_curves(std::span<const Input> inputs);

/// The one input that holds several curves, or null.
const Input* several_curves(std::span<const Input> inputs);

/// `run` for each curve by itself, in one outcome: the reports as a list `curves`; rows below one
/// another, the curve's number in front; curves as curves; pictures over one another. The status is
/// the first that is not `met`. Errors tell the curve.
Outcome over_curves(const Input& several, const std::function<Outcome(const Input&)>& run);

/// Curve number `only` of `input`, or the one that it is. Throws `option.range`.
Input only_curve(const Input& input, int only);

}  // namespace batten::api
