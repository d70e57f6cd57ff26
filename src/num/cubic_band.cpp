#include "num/cubic_band.hpp"

#include <cmath>
#include <cstring>

#include "num/clones.hpp"

namespace batten::num {
namespace {

typedef double Four __attribute__((vector_size(32)));

/// One row: its first column, and the others with the side at last.
struct BandRow {
    double first;
    Four rest;
};

BATTEN_INLINE void load_row(const double* from, BandRow& row) {
    row.first = from[0];
    std::memcpy(&row.rest, from + 1, sizeof row.rest);
}

BATTEN_INLINE void store_row(const BandRow& row, double* to) {
    to[0] = row.first;
    std::memcpy(to + 1, &row.rest, sizeof row.rest);
}

template <int Column>
BATTEN_INLINE double entry(const BandRow& row) {
    return Column == 0 ? row.first : row.rest[Column == 0 ? 0 : Column - 1];
}

/// Column `Column` of the block goes to zero. All later columns follow; earlier ones, which are
/// spent, take part and stay undefined.
template <int Column>
BATTEN_INLINE void reflect_column(BandRow (&front)[4], BandRow (&block)[4]) {
    double x[4];
    for (int i = 0; i < 4; ++i) x[i] = entry<Column>(block[i]);
    const double below_sq = (x[0] * x[0] + x[1] * x[1]) + (x[2] * x[2] + x[3] * x[3]);
    if (below_sq == 0) return;
    BandRow& top = front[Column];
    const double alpha = entry<Column>(top);
    const double size = std::sqrt(alpha * alpha + below_sq);
    const double beta = alpha > 0 ? -size : size;
    const Four before = top.rest;
    const Four products = (x[0] * block[0].rest + x[1] * block[1].rest) +
                          (x[2] * block[2].rest + x[3] * block[3].rest);
    const Four after = (alpha * before + products) * (1 / beta);
    const Four share = (before - after) * (1 / (alpha - beta));
    for (int i = 0; i < 4; ++i) block[i].rest -= x[i] * share;
    top.rest = after;
    if (Column == 0) top.first = beta;
    else top.rest[Column == 0 ? 0 : Column - 1] = beta;
}

/// Row 0 is done: the others become the front one column on.
BATTEN_INLINE void advance(BandRow (&front)[4]) {
    for (int i = 0; i < 4; ++i) {
        if (i == 3) {
            front[i] = {0, Four{}};
            break;
        }
        const Four next = front[i + 1].rest;
        front[i] = {next[0], Four{next[1], next[2], 0, next[3]}};
    }
}

BATTEN_CLONES double reduce_all(const int* firsts, std::size_t count, const double* blocks,
                                int columns, double* rows) {
    BandRow front[4] = {}, block[4];
    int first = 0;
    double rest_sq = 0;
    for (std::size_t b = 0; b < count; ++b) {
        for (; first < firsts[b]; ++first) {
            store_row(front[0], rows + first * 5);
            advance(front);
        }
        const double* const from = blocks + b * 20;
        for (int i = 0; i < 4; ++i) load_row(from + i * 5, block[i]);
        reflect_column<0>(front, block);
        reflect_column<1>(front, block);
        reflect_column<2>(front, block);
        reflect_column<3>(front, block);
        for (int i = 0; i < 4; ++i) rest_sq += block[i].rest[3] * block[i].rest[3];
    }
    for (; first < columns; ++first) {
        store_row(front[0], rows + first * 5);
        advance(front);
    }
    for (int i = 0; i < 4; ++i) rest_sq += front[i].rest[3] * front[i].rest[3];
    return rest_sq;
}

template <int Reach>
void inverse(const double* rows, std::size_t stride, int columns, double* out) {
    // Column d of row j is that of the entry (j, j + d).
    const auto at = [](double* here, int l, int d) -> double {
        return d >= l ? here[l * Reach + d - l] : here[d * Reach + l - d];
    };
    for (int j = columns; j-- > 0;) {
        const double* const r = rows + static_cast<std::size_t>(j) * stride;
        if (r[0] == 0) continue;
        double* const here = out + j * Reach;
        const double scale = 1 / r[0];
        const double q[4] = {0, r[1] * scale, r[2] * scale, r[3] * scale};
        for (int d = Reach - 1; d >= 0; --d) {
            // What the row before gave comes last: so rows wait least for each other.
            const double far = q[3] * at(here, 3, d) + q[2] * at(here, 2, d);
            const double known = d == 0 ? scale * scale : 0;
            here[d] = (known - far) - q[1] * at(here, 1, d);
        }
    }
}

}  // namespace

double reduce_cubic_band(std::span<const int> firsts, const double* blocks, int columns,
                         double* rows) {
    return reduce_all(firsts.data(), firsts.size(), blocks, columns, rows);
}

void solve_cubic_band(const double* rows, std::size_t stride, int columns, const double* z,
                      double* out) {
    double next[3] = {0, 0, 0};
    for (int j = columns; j-- > 0;) {
        const double* const r = rows + static_cast<std::size_t>(j) * stride;
        const double scale = r[0] == 0 ? 0 : 1 / r[0];
        const double far = (z[j] - (r[3] * next[2] + r[2] * next[1])) * scale;
        const double here = far - r[1] * scale * next[0];
        next[2] = next[1];
        next[1] = next[0];
        out[j] = next[0] = here;
    }
}

void inverse_of_cubic_band(const double* rows, std::size_t stride, int columns, int reach,
                           double* out) {
    if (reach == 4) inverse<4>(rows, stride, columns, out);
    else inverse<5>(rows, stride, columns, out);
}

}  // namespace batten::num
