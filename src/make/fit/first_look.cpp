#include "make/fit/first_look.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"

namespace batten::fitting {
namespace {

using num::LaneMask;
using num::Lanes;
using num::lanes;

constexpr double beyond_any = std::numeric_limits<double>::infinity();

/// The running extremes and counts of one column.
struct Column {
    Lanes least = Lanes{} + beyond_any, largest = {};
    LaneMask finite = {};

    BATTEN_INLINE void add(const Lanes& v) {
        least = v < least ? v : least;
        largest = v > largest ? v : largest;
        finite -= v <= std::numeric_limits<double>::max();
    }
};

struct LookSums {
    Column sizes, sigma;  ///< |y|, sigma
    LaneMask rising = {};
};

/// Columns from one row on; x has a row before it. `sigma` may be null.
struct Columns {
    const double *x, *y, *sigma;
};

/// All columns in one loop: the processor fetches what runs on.
BATTEN_CLONES void add_rows(const Columns& from, std::size_t count, LookSums& sums) {
    LookSums s = sums;
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes x, before, y;
        num::load(from.x + i, x);
        num::load(from.x + i - 1, before);
        num::load(from.y + i, y);
        s.rising -= x >= before;
        s.sizes.add(y < 0 ? -y : y);
        if (!from.sigma) continue;
        Lanes sigma;
        num::load(from.sigma + i, sigma);
        s.sigma.add(sigma);
    }
    sums = s;
}

void add_sigma(double sigma, SigmaRange& range) {
    range.least = std::min(range.least, sigma);
    range.largest = std::max(range.largest, sigma);
    range.are_usable &= sigma > 0 && std::isfinite(sigma);
}

}  // namespace

bool FirstLook::is_clean(const Samples& samples) const {
    return rows == samples.size() && !falls && std::isfinite(largest) && sigma.are_usable;
}

void look_at(const Samples& samples, Rows rows, FirstLook& look) {
    if (rows.first != look.rows) look.falls = true;
    look.rows = rows.last;
    const std::span<const double> y = samples.sides[0];
    const double* const sigma = samples.sigma.empty() ? nullptr : samples.sigma.data();
    const auto add_one = [&](std::size_t i) {
        // The first one of all has none before it, but is not to be NaN.
        look.falls |= !(samples.x[i] >= samples.x[i > 0 ? i - 1 : i]);
        look.largest = std::max(look.largest, std::isfinite(y[i]) ? std::fabs(y[i]) : beyond_any);
        if (sigma) add_sigma(sigma[i], look.sigma);
    };
    std::size_t row = rows.first;
    if (row == 0 && rows.last > 0) add_one(row++);
    const std::size_t whole = (rows.last - row) / lanes * lanes;
    LookSums sums;
    add_rows({samples.x.data() + row, y.data() + row, sigma ? sigma + row : nullptr}, whole, sums);
    const long long all = static_cast<long long>(whole);
    look.falls |= num::sum_of(sums.rising) != all;
    const bool are_finite = num::sum_of(sums.sizes.finite) == all;
    look.largest =
        std::max(look.largest, are_finite ? num::largest_of(sums.sizes.largest) : beyond_any);
    if (sigma && whole > 0) {
        look.sigma.least = std::min(look.sigma.least, -num::largest_of(-sums.sigma.least));
        look.sigma.largest = std::max(look.sigma.largest, num::largest_of(sums.sigma.largest));
        look.sigma.are_usable &= num::sum_of(sums.sigma.finite) == all && look.sigma.least > 0;
    }
    for (row += whole; row < rows.last; ++row) add_one(row);
}

}  // namespace batten::fitting
