#include "num/cox_de_boor.hpp"

#include <algorithm>
#include <cassert>

#include "num/clones.hpp"

namespace batten::num {
namespace {

/// `t`: the span's left knot. Unrolls where order and count are known beforehand.
BATTEN_INLINE void values_at(const double* t, int order, const double* x, int count, double* out) {
    for (int i = 0; i < count; ++i) out[i] = 1;
    for (int level = 1; level < order; ++level) {
        double* const last = out + level * count;
        for (int i = 0; i < count; ++i) last[i] = 0;
        for (int j = level - 1; j >= 0; --j) {
            const double right = t[j + 1], left = t[j + 1 - level];
            const double scale = 1 / (right - left);
            double* const here = out + j * count;
            double* const next = here + count;
            for (int i = 0; i < count; ++i) {
                const double share = here[i] * scale;
                here[i] = (right - x[i]) * share;
                next[i] += (x[i] - left) * share;
            }
        }
    }
}

}  // namespace

void basis_values(std::span<const double> knots, std::size_t span, int order, double x,
                  double* out) {
    basis_values_at(knots, span, order, &x, 1, out);
}

void basis_values_at(std::span<const double> knots, std::size_t span, int order, const double* x,
                     int count, double* out) {
    assert(order <= most_order);
    const double* const t = knots.data() + span;
    if (order != 4 || (count != 4 && count != 1)) return values_at(t, order, x, count, out);
    // Cubic: in registers.
    double values[16], at[4];
    std::copy_n(x, count, at);
    if (count == 4) values_at(t, 4, at, 4, values);
    else values_at(t, 4, at, 1, values);
    std::copy_n(values, 4 * count, out);
}

void basis_derivatives(std::span<const double> knots, std::size_t span, int order, double x,
                       int derivative, double* out) {
    for (int j = 0; j < order; ++j) out[j] = 0;
    if (derivative >= order) return;
    basis_values(knots, span, order - derivative, x, out);
    for (int level = order - derivative; level < order; ++level) {
        for (int j = level; j >= 0; --j) {
            const double* const t = knots.data() + span + j;
            const double right = j < level ? out[j] / (t[1] - t[1 - level]) : 0;
            const double left = j > 0 ? out[j - 1] / (t[0] - t[-level]) : 0;
            out[j] = level * (left - right);
        }
    }
}

}  // namespace batten::num
