#include "make/fit/local_basis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "num/clones.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

/// Unrolls where order and columns are known beforehand.
BATTEN_INLINE void transform(const double* matrix, const double* values, int order, int columns,
                             double* out) {
    for (int j = 0; j < order; ++j) {
        const double* const weights = matrix + j * order;
        for (int c = 0; c < columns; ++c) {
            const double* const column = values + c * order;
            double sum = 0;
            for (int i = 0; i < order; ++i) sum += weights[i] * column[i];
            out[j * columns + c] = sum;
        }
    }
}

}  // namespace

LocalBasis::LocalBasis(int order)
    : order_(order),
      nodes_(order),
      to_coefficients_(order * order),
      integrals_(order),
      left_(order * order),
      right_(order * order) {
    for (int i = 0; i < order; ++i) {
        const double angle = std::numbers::pi * (i + 0.5) / order;
        nodes_[i] = 2 * i + 1 == order ? 0 : std::cos(angle);
        for (int j = 0; j < order; ++j) {
            to_coefficients_[j * order + i] = (j == 0 ? 1.0 : 2.0) / order * std::cos(j * angle);
        }
        integrals_[i] = i % 2 == 1 ? 0 : 2.0 / (1.0 - i * i);
    }
    restriction(0.5, -0.5, left_.data());
    restriction(0.5, 0.5, right_.data());
}

void LocalBasis::values(double u, double* out) const {
    out[0] = 1;
    if (order_ > 1) out[1] = u;
    for (int j = 2; j < order_; ++j) out[j] = 2 * u * out[j - 1] - out[j - 2];
}

void LocalBasis::coefficients(const double* values, int columns, double* out) const {
    if (order_ == 4 && columns == 4) return transform(to_coefficients_.data(), values, 4, 4, out);
    transform(to_coefficients_.data(), values, order_, columns, out);
}

void LocalBasis::restriction(double scale, double shift, double* out) const {
    double table[num::most_order * num::most_order];
    double at_node[num::most_order];
    for (int i = 0; i < order_; ++i) {
        values(scale * nodes_[i] + shift, at_node);
        for (int c = 0; c < order_; ++c) table[c * order_ + i] = at_node[c];
    }
    coefficients(table, order_, out);
    for (int j = 0; j < order_; ++j) std::fill(out + j * order_, out + j * order_ + j, 0.0);
}

void LocalBasis::restriction(Interval whole, Interval part, double* out) const {
    const LocalScale local(whole);
    const double scale = 0.5 * (part.hi - part.lo) * local.scale;
    const double shift = local(part.lo + 0.5 * (part.hi - part.lo));
    if (scale == 0.5 && shift == -0.5) {
        std::copy(left_.begin(), left_.end(), out);
    } else if (scale == 0.5 && shift == 0.5) {
        std::copy(right_.begin(), right_.end(), out);
    } else {
        restriction(scale, shift, out);
    }
}

}  // namespace batten::fitting
