#include <algorithm>
#include <cassert>

#include "batten/shape/spline_function.hpp"
#include "num/clones.hpp"
#include "shape/horner.hpp"

/// Many abscissae at once: runs of one piece with its coefficients in registers.
namespace batten {
namespace {

using knots::PowerForm;

/// Abscissae are looked at in blocks, which compilers turn into vectors.
constexpr std::size_t run_block = 32;

/// How many of the first abscissae lie in [lo, hi).
BATTEN_CLONES std::size_t run_length(const double* x, std::size_t count, Interval piece) {
    std::size_t n = 0;
    for (; n + run_block <= count; n += run_block) {
        long long outside = 0;
        for (std::size_t i = 0; i < run_block; ++i) {
            const double at = x[n + i];
            outside += !((piece.lo <= at) & (at < piece.hi));
        }
        if (outside > 0) break;
    }
    while (n < count && piece.lo <= x[n] && x[n] < piece.hi) ++n;
    return n;
}

/// The same for the last piece, or where the first abscissa is outside: that one counts anyway.
std::size_t run_from(std::span<const double> x, std::size_t first, Interval piece) {
    return std::max<std::size_t>(1, run_length(x.data() + first, x.size() - first, piece));
}

template <int Degree>
BATTEN_INLINE void horner(const PowerForm& c, double origin, std::span<const double> x,
                          double* out) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        knots::horner_at<Degree, double>(c, x[i] - origin, out[i]);
    }
}

BATTEN_CLONES void horner_any(const PowerForm& c, int degree, double origin,
                              std::span<const double> x, double* out) {
    switch (degree) {
        case 0: return horner<0>(c, origin, x, out);
        case 1: return horner<1>(c, origin, x, out);
        case 2: return horner<2>(c, origin, x, out);
        case 3: return horner<3>(c, origin, x, out);
        case 4: return horner<4>(c, origin, x, out);
        case 5: return horner<5>(c, origin, x, out);
        default: break;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = x[i] - origin;
        double sum = c[degree];
        for (int j = degree; j-- > 0;) sum = sum * u + c[j];
        out[i] = sum;
    }
}

}  // namespace

void SplineFunction::evaluate(std::span<const double> x, int derivative,
                              std::span<double> out) const {
    assert(out.size() >= x.size() && derivative >= 0);
    const int degree = degree_ - derivative;
    if (degree < 0) {
        std::fill_n(out.begin(), x.size(), 0.0);
        return;
    }
    PowerForm factor{}, c{};
    for (int j = 0; j <= degree; ++j) {
        factor[j] = 1;
        for (int r = 0; r < derivative; ++r) factor[j] *= j + derivative - r;
    }
    const std::size_t stride = pieces();
    for (std::size_t first = 0; first < x.size();) {
        const std::size_t piece = piece_of(x[first]);
        for (int j = 0; j <= degree; ++j) {
            c[j] = factor[j] * power_[static_cast<std::size_t>(j + derivative) * stride + piece];
        }
        const std::size_t n = run_from(x, first, {breaks_[piece], breaks_[piece + 1]});
        horner_any(c, degree, breaks_[piece], x.subspan(first, n), out.data() + first);
        first += n;
    }
}

void SplineFunction::evaluate_jets(std::span<const double> x, std::span<double> value,
                                   std::span<double> first_out,
                                   std::span<double> second_out) const {
    PowerForm c{};
    const std::size_t stride = pieces();
    for (std::size_t first = 0; first < x.size();) {
        const std::size_t piece = piece_of(x[first]);
        for (int j = 0; j <= degree_; ++j) c[j] = power_[static_cast<std::size_t>(j) * stride + piece];
        const double origin = breaks_[piece];
        const std::size_t last =
            first + run_from(x, first, {origin, breaks_[piece + 1]});
        for (; first < last; ++first) {
            const double u = x[first] - origin;
            double y = c[degree_], slope = 0, half_second = 0;
            for (int j = degree_; j-- > 0;) {
                half_second = half_second * u + slope;
                slope = slope * u + y;
                y = y * u + c[j];
            }
            value[first] = y;
            first_out[first] = slope;
            second_out[first] = 2 * half_second;
        }
    }
}

}  // namespace batten
