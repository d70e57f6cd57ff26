#include "num/patch_kernel.hpp"

#include <cassert>

#if defined(__x86_64__) && defined(__GNUC__)
#define BATTEN_HAS_X86_LEVELS
#include <immintrin.h>
#endif

namespace batten::patches {
namespace {

// Four outputs are worked on side by side: the layout of the coefficients is [i][j][output].
constexpr int lanes = 4;

template <int Size>
Outputs plain_polynomial(const double* c, double u, double v) {
    Outputs out{};
    for (int i = Size; i-- > 0;) {
        const double* const row = c + i * Size * lanes;
        Outputs sum{};
        for (int j = Size; j-- > 0;) {
            for (std::size_t k = 0; k < lanes; ++k) sum[k] = sum[k] * v + row[j * lanes + k];
        }
        for (std::size_t k = 0; k < lanes; ++k) out[k] = out[k] * u + sum[k];
    }
    return out;
}

constexpr int small_size = 8;

double plain_8x8(const double* c, double x, double y) {
    std::array<double, small_size> sums{};
    for (int j = small_size; j-- > 0;) {
        for (std::size_t i = 0; i < small_size; ++i) {
            sums[i] = sums[i] * y + c[static_cast<std::size_t>(j) * small_size + i];
        }
    }
    return polynomial_8(sums.data(), x);
}

#ifdef BATTEN_HAS_X86_LEVELS

__attribute__((target("avx2,fma"))) double avx2_8x8(const double* c, double x, double y) {
    const __m256d in_y = _mm256_set1_pd(y);
    const double* const last = c + (small_size - 1) * small_size;
    __m256d low = _mm256_loadu_pd(last), high = _mm256_loadu_pd(last + 4);
    for (int j = small_size - 1; j-- > 0;) {
        low = _mm256_fmadd_pd(low, in_y, _mm256_loadu_pd(c + j * small_size));
        high = _mm256_fmadd_pd(high, in_y, _mm256_loadu_pd(c + j * small_size + 4));
    }
    double sums[small_size];
    _mm256_storeu_pd(sums, low);
    _mm256_storeu_pd(sums + 4, high);
    return polynomial_8(sums, x);
}

template <int Size>
__attribute__((target("avx2,fma"))) Outputs avx2_polynomial(const double* c, double u, double v) {
    const __m256d in_v = _mm256_set1_pd(v), in_u = _mm256_set1_pd(u);
    __m256d rows[Size];
    for (int i = 0; i < Size; ++i) rows[i] = _mm256_loadu_pd(c + (i * Size + Size - 1) * lanes);
    for (int j = Size - 1; j-- > 0;) {
        for (int i = 0; i < Size; ++i) {
            rows[i] = _mm256_fmadd_pd(rows[i], in_v, _mm256_loadu_pd(c + (i * Size + j) * lanes));
        }
    }
    __m256d sum = rows[Size - 1];
    for (int i = Size - 1; i-- > 0;) sum = _mm256_fmadd_pd(sum, in_u, rows[i]);
    Outputs out;
    _mm256_storeu_pd(out.data(), sum);
    return out;
}

/// Even and odd powers of v side by side, by Horner's rule in v^2.
template <int Size>
__attribute__((target("avx512f"))) Outputs avx512_polynomial(const double* c, double u, double v) {
    static_assert(Size % 2 == 0);
    constexpr int pairs = Size / 2;
    const __m512d in_v = _mm512_set1_pd(v * v), in_u = _mm512_set1_pd(u);
    __m512d rows[Size];
    for (int i = 0; i < Size; ++i) {
        rows[i] = _mm512_loadu_pd(c + (i * Size + Size - 2) * lanes);
    }
    for (int j = pairs - 1; j-- > 0;) {
        for (int i = 0; i < Size; ++i) {
            rows[i] =
                _mm512_fmadd_pd(rows[i], in_v, _mm512_loadu_pd(c + (i * Size + 2 * j) * lanes));
        }
    }
    __m512d sum = rows[Size - 1];
    for (int i = Size - 1; i-- > 0;) sum = _mm512_fmadd_pd(sum, in_u, rows[i]);
    double both[2 * lanes];
    _mm512_storeu_pd(both, sum);
    Outputs out;
    for (std::size_t k = 0; k < lanes; ++k) out[k] = both[k] + v * both[lanes + k];
    return out;
}

#endif

Level best_level() {
    for (const Level level : {Level::avx512, Level::avx2}) {
        if (is_offered(level)) return level;
    }
    return Level::plain;
}

template <int Size>
Outputs sized_polynomial(Level level, const double* c, double u, double v) {
#ifdef BATTEN_HAS_X86_LEVELS
    if (level == Level::avx512) return avx512_polynomial<Size>(c, u, v);
    if (level == Level::avx2) return avx2_polynomial<Size>(c, u, v);
#endif
    assert(level == Level::plain);
    return plain_polynomial<Size>(c, u, v);
}

}  // namespace

bool is_offered(Level level) {
#ifdef BATTEN_HAS_X86_LEVELS
    if (level == Level::avx512) return __builtin_cpu_supports("avx512f");
    if (level == Level::avx2) {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    }
#endif
    return level == Level::plain;
}

Outputs polynomial_at(Level level, const Shape& shape, const double* c, double u, double v) {
    assert(shape.outputs == lanes && shape.width == shape.height);
    assert(shape.width == 12 || shape.width == 10);
    return shape.width == 12 ? sized_polynomial<12>(level, c, u, v)
                             : sized_polynomial<10>(level, c, u, v);
}

double polynomial_8x8(const double* c, double x, double y) {
#ifdef BATTEN_HAS_X86_LEVELS
    static const bool has_avx2 = is_offered(Level::avx2);
    if (has_avx2) return avx2_8x8(c, x, y);
#endif
    return plain_8x8(c, x, y);
}

Outputs polynomial(const Shape& shape, const double* c, double u, double v) {
    static const Level best = best_level();
    return polynomial_at(best, shape, c, u, v);
}

}  // namespace batten::patches
