#pragma once

#include "batten/base/interval.hpp"
#include "make/fit/samples.hpp"

/// Which samples belong to an interval: few of them are looked at.
namespace batten::fitting {

/// The rows with lo <= x < hi, or <= hi for the last interval of a spline.
enum class RightEnd { open, closed };
Rows rows_in(const Samples& samples, Rows within, Interval span, RightEnd end);
/// The first of the rows, all of them from span.lo on, whose x is not below span.hi.
std::size_t end_of_run(const Samples& samples, Rows within, Interval span);

}  // namespace batten::fitting
