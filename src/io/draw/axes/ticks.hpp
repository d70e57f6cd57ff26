#pragma once

#include <string>
#include <vector>

#include "batten/base/interval.hpp"

namespace batten::drawing {

struct Tick {
    double at = 0;      ///< in the axis' units: on a logarithmic axis the logarithm
    std::string label;  ///< empty on a minor tick
};

/// Where an axis carries numbers. They are to be multiplied by and added to what `note` says, as
/// in `x10^-4 + 1x10^9` (in typographic signs); it is empty in most cases. No label is longer than
/// 7 letters.
struct AxisTicks {
    std::vector<Tick> ticks;
    std::string note;
    double step = 0;
};

/// Multiples of 1, 2 or 5 times a power of ten in `shown`, at least `least_step` apart. Both must
/// be finite and positive in length; `shown` at least
/// 2e-14 of its larger end.
AxisTicks linear_ticks(Interval shown, double least_step);

/// Powers of ten in `shown` = log10 of the two ends, labels at least `least_step` decades apart;
/// where there is room their multiples by 2 and 5 carry labels too. Less than a decade is numbered
/// evenly.
AxisTicks log_ticks(Interval shown, double least_step);

/// `x` to three digits, for people: `0.0123` or 1.23 times a power of ten.
std::string short_number(double x);

/// 10^exponent, rounded once.
double power_of_ten(int exponent);

}  // namespace batten::drawing
