#pragma once

#include "make/fit/growth.hpp"

namespace batten::fitting {

/// Takes out knots as long as delta2 stays within `target`: the one that is missed least, and with
/// it as many others, far from it and each other, as are missed by half of what is left to the
/// target. Up to 10 intervals, every interval is halved in turn too, and that kept where it makes
/// more than one other knot spare.
///
/// Whether there are fewer knots now; `growth` is solved. Open splines of one side.
bool take_out_spare(Growth& growth, double target);

}  // namespace batten::fitting
