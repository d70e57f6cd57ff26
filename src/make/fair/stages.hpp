#pragma once

/// What the fairing of plane and of space curves have in common: how lambda and softness go down.
namespace batten::fairing {

constexpr double soft = 0.1, hard = 0.03;  ///< of the typical curvature
constexpr double ratio = 10;               ///< from one lambda to the next
constexpr double most_rms = 1.5;           ///< over sigma, where the search for lambda ends

}  // namespace batten::fairing
