#pragma once

#include <span>

#include "batten/shape/basis.hpp"
#include "num/tensor.hpp"

namespace batten::surfaces {

/// The functions of `basis`, or a derivative of them, at rising places.
num::TensorSide side_of(const BSplineBasis& basis, std::span<const double> places,
                        int derivative = 0);

}  // namespace batten::surfaces
