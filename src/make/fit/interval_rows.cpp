#include "make/fit/interval_rows.hpp"

#include <algorithm>

namespace batten::fitting {
namespace {

/// The first of the abscissae that is not below a bound, sought from `near` on: few of them are
/// looked at, and they lie close together.
template <class Below>
const double* first_not(const double* from, const double* near, const double* to, Below below) {
    std::ptrdiff_t step = 16;
    const double *lo = from, *hi = to;
    if (near == to || !below(*near)) {
        hi = near;
        while (hi - from > step && !below(hi[-step])) {
            hi -= step;
            step *= 2;
        }
        lo = hi - std::min(step, hi - from);
    } else {
        lo = near;
        while (to - lo > step && below(lo[step])) {
            lo += step;
            step *= 2;
        }
        hi = lo + std::min(step, to - lo);
    }
    return std::partition_point(lo, hi, below);
}

/// Where the rows in an interval would end if they were evenly spread.
const double* likely_end(const Samples& samples, const double* first, const double* to,
                         Interval span) {
    const double whole = samples.range.length();
    const double share = whole > 0 ? std::clamp(span.length() / whole, 0.0, 1.0) : 0;
    const double count = share * static_cast<double>(samples.size());
    return first + std::min(static_cast<std::ptrdiff_t>(count), to - first);
}

auto below(double bound) {
    return [bound](double x) { return x < bound; };
}

}  // namespace

Rows rows_in(const Samples& samples, Rows within, Interval span, RightEnd end) {
    const double* const begin = samples.x.data();
    const double* const to = begin + within.last;
    const double* const from = begin + within.first;
    const double* const first = first_not(from, from, to, below(span.lo));
    const double* const near = likely_end(samples, first, to, span);
    const double* const last =
        end == RightEnd::closed
            ? first_not(first, near, to, [hi = span.hi](double x) { return x <= hi; })
            : first_not(first, near, to, below(span.hi));
    return {static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin)};
}

std::size_t end_of_run(const Samples& samples, Rows within, Interval span) {
    const double* const begin = samples.x.data();
    const double *const first = begin + within.first, *const to = begin + within.last;
    const double* const near = likely_end(samples, first, to, span);
    return static_cast<std::size_t>(first_not(first, near, to, below(span.hi)) - begin);
}

}  // namespace batten::fitting
