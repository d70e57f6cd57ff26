#include "num/householder.hpp"

#include <algorithm>
#include <cmath>

namespace batten::num {
namespace {

/// One reflection: column `c` of `rows` rows goes to zero, the columns after it follow.
void reflect(const Triangle& into, const RowBlock& block, int c, int rows) {
    double* const top = into.data + static_cast<std::size_t>(c) * into.stride;
    double below_sq = 0;
    for (int i = 0; i < rows; ++i) {
        const double x = block.data[static_cast<std::size_t>(i) * block.stride +
                                    static_cast<std::size_t>(c)];
        below_sq += x * x;
    }
    if (below_sq == 0) return;
    const double alpha = top[c];
    const double beta = alpha > 0 ? -std::sqrt(alpha * alpha + below_sq)
                                  : std::sqrt(alpha * alpha + below_sq);
    const double head = alpha - beta;
    const double factor = 2 / (head * head + below_sq);
    top[c] = beta;
    for (int j = c + 1; j < into.width; j += 8) {
        const int last = std::min(into.width, j + 8);
        double sums[8];
        for (int l = j; l < last; ++l) sums[l - j] = head * top[l];
        for (int i = 0; i < rows; ++i) {
            const double* const row = block.data + static_cast<std::size_t>(i) * block.stride;
            for (int l = j; l < last; ++l) sums[l - j] += row[c] * row[l];
        }
        for (int l = j; l < last; ++l) {
            sums[l - j] *= factor;
            top[l] -= sums[l - j] * head;
        }
        for (int i = 0; i < rows; ++i) {
            double* const row = block.data + static_cast<std::size_t>(i) * block.stride;
            for (int l = j; l < last; ++l) row[l] -= sums[l - j] * row[c];
        }
    }
}

}  // namespace

void absorb(const Triangle& into, const RowBlock& block, BlockShape shape) {
    for (int c = 0; c < into.columns; ++c) {
        const int rows =
            shape == BlockShape::triangular ? std::min(block.rows, c + 1) : block.rows;
        reflect(into, block, c, rows);
    }
}

}  // namespace batten::num
