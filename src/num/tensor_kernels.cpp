#include "num/tensor_kernels.hpp"

#include <algorithm>

#include "num/lanes.hpp"

namespace batten::num {
namespace {

/// The sums of `Functions` functions, from `first` on, with `Count` rows.
template <int Functions, int Count>
BATTEN_INLINE void add_few(const Rows& rows, std::size_t first, const RowSums& sums) {
    const double* const a = rows.factors + first;
    double* t[Functions];
    for (std::size_t i = 0; i < Functions; ++i) t[i] = sums.at[first + i] + sums.from;
    std::size_t s = 0;
    for (; s + lanes <= sums.count; s += lanes) {
        Lanes sum[Functions];
        for (std::size_t i = 0; i < Functions; ++i) load(t[i] + s, sum[i]);
        for (std::size_t q = 0; q < Count; ++q) {
            const double* const from = rows.z + q * rows.stride + s;
            Lanes u;
            load(from, u);
#ifdef __GNUC__
            __builtin_prefetch(from + tensor_block);
#endif
            for (std::size_t i = 0; i < Functions; ++i) sum[i] += a[q * rows.order + i] * u;
        }
        for (std::size_t i = 0; i < Functions; ++i) store(sum[i], t[i] + s);
    }
    for (; s < sums.count; ++s) {
        for (std::size_t i = 0; i < Functions; ++i) {
            for (std::size_t q = 0; q < Count; ++q) {
                t[i][s] += a[q * rows.order + i] * rows.z[q * rows.stride + s];
            }
        }
    }
}

template <int Functions>
BATTEN_INLINE void add_all(Rows rows, std::size_t row_count, std::size_t first,
                           const RowSums& sums) {
    for (; row_count >= 4; row_count -= 4) {
        add_few<Functions, 4>(rows, first, sums);
        rows.z += 4 * rows.stride;
        rows.factors += 4 * rows.order;
    }
    if (row_count == 3) add_few<Functions, 3>(rows, first, sums);
    if (row_count == 2) add_few<Functions, 2>(rows, first, sums);
    if (row_count == 1) add_few<Functions, 1>(rows, first, sums);
}

typedef double Four __attribute__((vector_size(32)));

/// g(q, j) += sum over s of from(q, s) y(s, j) for `Count` rows and as many j as a vector holds.
template <class Vector, int Count>
BATTEN_INLINE void add_products_of(const double* from, std::size_t stride, const double* y,
                                   std::size_t width, std::size_t count, Vector* sums) {
    Vector t[Count] = {};
    Vector odd[Count] = {};  // apart, so that no addition waits for the one before it
    std::size_t s = 0;
    for (; s + 2 <= count; s += 2) {
        Vector v, w;
        std::memcpy(&v, y + s * width, sizeof v);
        std::memcpy(&w, y + (s + 1) * width, sizeof w);
        for (std::size_t q = 0; q < Count; ++q) {
            t[q] += from[q * stride + s] * v;
            odd[q] += from[q * stride + s + 1] * w;
        }
    }
    if (s < count) {
        Vector v;
        std::memcpy(&v, y + s * width, sizeof v);
        for (std::size_t q = 0; q < Count; ++q) t[q] += from[q * stride + s] * v;
    }
    for (std::size_t q = 0; q < Count; ++q) sums[q] = t[q] + odd[q];
}

template <class Vector, int Count>
BATTEN_INLINE void add_product_rows(const Product& p, std::size_t row) {
    constexpr std::size_t wide = sizeof(Vector) / sizeof(double);
    for (std::size_t j = 0; j < p.order; j += wide) {
        Vector t[Count];
        add_products_of<Vector, Count>(p.from + row * p.stride, p.stride, p.y + j, p.width,
                                       p.places, t);
        const std::size_t few = std::min(wide, p.order - j);
        for (int q = 0; q < Count; ++q) {
            double* const to = p.g + (row + static_cast<std::size_t>(q)) * p.reach + j;
            for (std::size_t l = 0; l < few; ++l) to[l] += t[q][l];
        }
    }
}

template <class Vector>
BATTEN_INLINE void add_product(const Product& p, std::size_t count) {
    std::size_t row = 0;
    for (; row + 4 <= count; row += 4) add_product_rows<Vector, 4>(p, row);
    for (; row < count; ++row) add_product_rows<Vector, 1>(p, row);
}

}  // namespace

BATTEN_CLONES void add_rows(Rows rows, std::size_t row_count, const RowSums& sums) {
    std::size_t i = 0;
    for (; i + 4 <= rows.order; i += 4) add_all<4>(rows, row_count, i, sums);
    for (; i < rows.order; ++i) add_all<1>(rows, row_count, i, sums);
}

BATTEN_CLONES void add_products(const Product& p, std::size_t count) {
    if (p.width == 4) add_product<Four>(p, count);
    else add_product<Lanes>(p, count);
}

BATTEN_CLONES void combine(const double* const* lines, const double* h, std::size_t order,
                           PlaceRange places, double* __restrict out) {
    const std::size_t count = places.count();
    if (order == 4) {
        const double* const y0 = lines[0] + places.first;
        const double* const y1 = lines[1] + places.first;
        const double* const y2 = lines[2] + places.first;
        const double* const y3 = lines[3] + places.first;
        std::size_t s = 0;
        for (; s + lanes <= count; s += lanes) {
            Lanes a, b, c, d;
            load(y0 + s, a);
            load(y1 + s, b);
            load(y2 + s, c);
            load(y3 + s, d);
            store((h[0] * a + h[1] * b) + (h[2] * c + h[3] * d), out + s);
        }
        for (; s < count; ++s) {
            out[s] = (h[0] * y0[s] + h[1] * y1[s]) + (h[2] * y2[s] + h[3] * y3[s]);
        }
        return;
    }
    std::fill_n(out, count, 0.0);
    for (std::size_t j = 0; j < order; ++j) {
        const double* const line = lines[j] + places.first;
        for (std::size_t s = 0; s < count; ++s) out[s] += h[j] * line[s];
    }
}

}  // namespace batten::num
