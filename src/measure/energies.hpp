#pragma once

#include <optional>
#include <vector>

#include "batten/measure/measured.hpp"
#include "measure/bezier/panel.hpp"

namespace batten::bezier {

/// int kappa^2 ds of each piece of the curve, in 1 / normal units; or where it does not exist.
struct Energies {
    std::vector<Measured> pieces;
    std::optional<double> diverges_at;  ///< the curve's parameter
};
Energies energies(const Motion& motion);

/// Sum of E_i L_i^2, in normal units.
Measured pseudo_energy(const Energies& energies, const std::vector<Measured>& lengths);

/// The product with its error.
Measured product(const Measured& a, const Measured& b);

}  // namespace batten::bezier
