#pragma once

#include <string>

#include "batten/batten.hpp"

/// Points of a curve in space, seen in perspective: new points made in space and then projected,
/// against new points made in the picture. The paper's own use of its method (section 1).
namespace nakajima {

struct Projection {
    batten::Drawing drawing;
    double space_first = 0;    ///< largest distance from the true picture, % of its extent
    double picture_first = 0;
    double apart_in_parallel = 0;  ///< of both ways in a parallel projection, % of the extent
};

Projection project_screw();

}  // namespace nakajima
