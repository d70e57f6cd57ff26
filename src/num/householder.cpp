#include "num/householder.hpp"

#include <algorithm>
#include <cmath>

namespace batten::num {
namespace {

/// The first component of a reflection's vector, and 2 over the vector's square; `alpha` becomes what
/// the reflection makes of it. `below_sq` > 0: the square of what goes to zero.
struct ReflectionStart {
    double head, factor;
};

inline ReflectionStart start_of(double& alpha, double below_sq) {
    const double size = std::sqrt(alpha * alpha + below_sq);
    const double beta = alpha > 0 ? -size : size;
    const double head = alpha - beta;
    alpha = beta;
    return {head, 2 / (head * head + below_sq)};
}

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
    const auto [head, factor] = start_of(top[c], below_sq);
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

/// The same for sizes that are known beforehand: the loops unroll, the sums stay in order.
template <int Rows, int Width>
void reflect_fixed(const Triangle& into, const RowBlock& block, int c) {
    double* const top = into.data + static_cast<std::size_t>(c) * into.stride;
    double* row[Rows];
    double below_sq = 0;
    for (int i = 0; i < Rows; ++i) {
        row[i] = block.data + static_cast<std::size_t>(i) * block.stride;
        below_sq += row[i][c] * row[i][c];
    }
    if (below_sq == 0) return;
    const auto [head, factor] = start_of(top[c], below_sq);
    for (int j = c + 1; j < Width; ++j) {
        double sum = head * top[j];
        for (int i = 0; i < Rows; ++i) sum += row[i][c] * row[i][j];
        sum *= factor;
        top[j] -= sum * head;
        for (int i = 0; i < Rows; ++i) row[i][j] -= sum * row[i][c];
    }
}

/// Four rows of a cubic spline and one side: what fits are made of.
void absorb_cubic(const Triangle& into, const RowBlock& block) {
    reflect_fixed<4, 5>(into, block, 0);
    reflect_fixed<4, 5>(into, block, 1);
    reflect_fixed<4, 5>(into, block, 2);
    reflect_fixed<4, 5>(into, block, 3);
}

}  // namespace

void absorb(const Triangle& into, const RowBlock& block, BlockShape shape) {
    const bool is_cubic = into.columns == 4 && into.width == 5 && block.rows == 4;
    if (is_cubic && shape == BlockShape::full) return absorb_cubic(into, block);
    for (int c = 0; c < into.columns; ++c) {
        const int rows =
            shape == BlockShape::triangular ? std::min(block.rows, c + 1) : block.rows;
        reflect(into, block, c, rows);
    }
}

}  // namespace batten::num
