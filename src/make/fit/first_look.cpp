#include "make/fit/first_look.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"

namespace batten::fitting {
namespace {

using num::LaneMask;
using num::Lanes;
using num::lanes;

constexpr long long sign_bit = std::numeric_limits<long long>::min();
constexpr double beyond_any = std::numeric_limits<double>::infinity();
constexpr long long bits_beyond_any = 0x7ff0'0000'0000'0000;

/// Numbers as the integers their bits are: from 0 up in the same order, then Inf, then NaN; below 0
/// whatever has a sign.
BATTEN_INLINE void load_bits(const double* from, LaneMask& to) {
    std::memcpy(&to, from, sizeof to);
}

struct LookSums {
    LaneMask largest = {};  ///< |y|
    LaneMask least_sigma = LaneMask{} + bits_beyond_any;
    LaneMask largest_sigma = {};
    LaneMask rising = {};
};

/// Columns from one row on; x has a row before it. `sigma` may be null.
struct Columns {
    const double *x, *y, *sigma;
};

template <bool HasSigma>
BATTEN_INLINE void add_blocks(const Columns& from, std::size_t count, LookSums& sums) {
    LookSums s = sums;
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes x, before;
        LaneMask size;
        num::load(from.x + i, x);
        num::load(from.x + i - 1, before);
        load_bits(from.y + i, size);
        s.rising -= x >= before;
        size &= ~sign_bit;
        s.largest = size > s.largest ? size : s.largest;
        if (!HasSigma) continue;
        LaneMask sigma;
        load_bits(from.sigma + i, sigma);
        s.least_sigma = sigma < s.least_sigma ? sigma : s.least_sigma;
        s.largest_sigma = sigma > s.largest_sigma ? sigma : s.largest_sigma;
    }
    sums = s;
}

/// All columns in one loop: the processor fetches what runs on.
BATTEN_CLONES void add_rows(const Columns& from, std::size_t count, LookSums& sums) {
    if (from.sigma) add_blocks<true>(from, count, sums);
    else add_blocks<false>(from, count, sums);
}

double number_of(long long bits) {
    double number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

void add_size(double size, FirstLook& look) {
    look.largest = std::max(look.largest, std::isfinite(size) ? size : beyond_any);
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
        add_size(std::fabs(y[i]), look);
        if (sigma) add_sigma(sigma[i], look.sigma);
    };
    std::size_t row = rows.first;
    if (row == 0 && rows.last > 0) add_one(row++);
    const std::size_t whole = (rows.last - row) / lanes * lanes;
    if (whole > 0) {
        LookSums sums;
        add_rows({samples.x.data() + row, y.data() + row, sigma ? sigma + row : nullptr}, whole,
                 sums);
        look.falls |= num::sum_of(sums.rising) != static_cast<long long>(whole);
        add_size(number_of(num::largest_of(sums.largest)), look);
        if (sigma) {
            add_sigma(number_of(~num::largest_of(~sums.least_sigma)), look.sigma);
            add_sigma(number_of(num::largest_of(sums.largest_sigma)), look.sigma);
        }
    }
    for (row += whole; row < rows.last; ++row) add_one(row);
}

}  // namespace batten::fitting
