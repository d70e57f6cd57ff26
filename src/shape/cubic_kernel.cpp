#include "shape/cubic_kernel.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "num/clones.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define BATTEN_HAS_X86_LEVELS
#include <immintrin.h>
#endif

namespace batten::cubics {
namespace {

using patches::Level;

/// Fewer neighbours on one piece than these are no run.
constexpr std::size_t shortest_run = 8;
/// Runs are looked at in blocks, long enough for the compiler to make vectors of the loop, and
/// worked on while they are in the nearest cache.
constexpr std::size_t block_size = 32;
constexpr std::size_t longest_run = 512;
/// Enough scattered parameters for the waits for memory to overlap.
constexpr std::size_t batch_size = 64;

/// A piece of the curve's parameter.
struct Stretch {
    double lo, hi;
    BATTEN_INLINE bool holds(double t) const { return (lo <= t) & (t < hi); }
};

BATTEN_INLINE bool holds_block(Stretch stretch, const double* t) {
    std::int64_t outside = 0;
    for (std::size_t i = 0; i < block_size; ++i) outside |= !stretch.holds(t[i]);
    return outside == 0;
}

/// How many of the first parameters lie in a stretch.
BATTEN_INLINE std::size_t count_in(Stretch stretch, std::span<const double> t) {
    std::size_t count = 0;
    while (count + block_size <= t.size() && holds_block(stretch, t.data() + count)) {
        count += block_size;
    }
    while (count < t.size() && stretch.holds(t[count])) ++count;
    return count;
}

BATTEN_INLINE std::uint32_t piece_of(const Indexed& curve, double t) {
    const std::uint32_t* const cell = curve.first + cell_of(curve, t);
    std::uint32_t lo = cell[0], hi = cell[1];
    while (hi > lo + 1) {
        const std::uint32_t middle = lo + (hi - lo) / 2;
        (curve.breaks[middle] <= t ? lo : hi) = middle;
    }
    // Without a branch: half of the random parameters go either way.
    return lo + static_cast<std::uint32_t>((curve.breaks[lo + 1] <= t) & (lo < hi));
}

BATTEN_INLINE Stretch stretch_of(const Indexed& curve, std::size_t piece) {
    return {curve.breaks[piece], curve.breaks[piece + 1]};
}

/// Whether the first parameters look like a run. t[0] itself lies outside at the end of the domain
/// and beyond.
BATTEN_INLINE bool starts_run(Stretch stretch, std::span<const double> t) {
    return t.size() >= shortest_run && stretch.holds(t[0]) && stretch.holds(t[shortest_run / 2]) &&
           stretch.holds(t[shortest_run - 1]);
}

/// The piece of t: first the one after `piece` is tried, if there is one.
BATTEN_INLINE std::size_t next_piece(const Indexed& curve, std::size_t piece, double t) {
    const bool is_next =
        piece + 2 < curve.breaks.size() && stretch_of(curve, piece + 1).holds(t);
    return is_next ? piece + 1 : piece_of(curve, t);
}

/// One coordinate of a cubic and its derivatives.
template <int Order>
BATTEN_INLINE void put(const double* c, double u, std::size_t dim, double* out) {
    const double c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3];
    out[0] = c0 + u * (c1 + u * (c2 + u * c3));
    if constexpr (Order > 0) out[dim] = c1 + u * (2 * c2 + u * 3 * c3);
    if constexpr (Order > 1) out[2 * dim] = 2 * c2 + u * 6 * c3;
}

/// `Dim` is the dimension where the loop is to be a short one, else 0.
template <int Order, std::size_t Dim>
struct Kernel {
    const Indexed& curve;

    BATTEN_INLINE std::size_t dim() const { return Dim > 0 ? Dim : curve.dim; }
    BATTEN_INLINE std::size_t stride() const { return (Order + 1) * dim(); }

    BATTEN_INLINE void run(std::size_t piece, std::span<const double> t, double* out) const {
        const double origin = curve.breaks[piece];
        const std::size_t numbers = stride();
        for (std::size_t k = 0; k < dim(); ++k) {
            const double* const from = curve.coefficients + 4 * (piece * dim() + k);
            const double c[4] = {from[0], from[1], from[2], from[3]};
            for (std::size_t i = 0; i < t.size(); ++i) {
                put<Order>(c, t[i] - origin, dim(), out + i * numbers + k);
            }
        }
    }

    BATTEN_INLINE void scattered(std::span<const double> t, double* out) const {
        std::array<std::uint32_t, batch_size> pieces;
        for (std::size_t i = 0; i < t.size(); ++i) pieces[i] = piece_of(curve, t[i]);
        const double end = curve.breaks.back();
        bool is_at_end = false;
        for (std::size_t i = 0; i < t.size(); ++i) {
            const std::size_t piece = pieces[i];
            const double u = t[i] - curve.breaks[piece];
            for (std::size_t k = 0; k < dim(); ++k) {
                put<Order>(curve.coefficients + 4 * (piece * dim() + k), u, dim(),
                           out + i * stride() + k);
            }
            is_at_end |= t[i] == end;
        }
        if (!is_at_end) return;
        for (std::size_t i = 0; i < t.size(); ++i) {
            if (t[i] == end) std::copy_n(curve.last_point, dim(), out + i * stride());
        }
    }

    BATTEN_INLINE void operator()(std::span<const double> t, double* out) const {
        std::size_t piece = curve.breaks.size();
        while (!t.empty()) {
            piece = next_piece(curve, piece, t[0]);
            const Stretch stretch = stretch_of(curve, piece);
            std::size_t count;
            if (starts_run(stretch, t)) {
                count = count_in(stretch, t.first(std::min(t.size(), longest_run)));
                // Whole vectors: what is too much is written again.
                run(piece, t.first(std::min((count + 7) / 8 * 8, t.size())), out);
            } else {
                count = std::min(t.size(), batch_size);
                scattered(t.first(count), out);
            }
            t = t.subspan(count);
            out += count * stride();
        }
    }
};

template <int Order>
BATTEN_INLINE void evaluate_with(const Indexed& curve, std::span<const double> t, double* out) {
    if (curve.dim == 1) return Kernel<Order, 1>{curve}(t, out);
    if (curve.dim == 2) return Kernel<Order, 2>{curve}(t, out);
    Kernel<Order, 0>{curve}(t, out);
}

BATTEN_INLINE void evaluate_any(const Indexed& curve, std::span<const double> t, int order,
                                double* out) {
    if (order == 0) return evaluate_with<0>(curve, t, out);
    if (order == 1) return evaluate_with<1>(curve, t, out);
    evaluate_with<2>(curve, t, out);
}

void evaluate_plain(const Indexed& curve, std::span<const double> t, int order, double* out) {
    evaluate_any(curve, t, order, out);
}

#ifdef BATTEN_HAS_X86_LEVELS
__attribute__((target("avx2"))) void evaluate_avx2(const Indexed& curve,
                                                   std::span<const double> t, int order,
                                                   double* out) {
    evaluate_any(curve, t, order, out);
}

/// A piece of one coordinate in each lane.
struct Avx512Piece {
    __m512d lo, hi, c[4];

    __attribute__((target("avx512f"), always_inline)) inline static Avx512Piece of(
        const Indexed& curve, std::size_t piece) {
        const double* const c = curve.coefficients + 4 * piece;
        return {_mm512_set1_pd(curve.breaks[piece]),
                _mm512_set1_pd(curve.breaks[piece + 1]),
                {_mm512_set1_pd(c[0]), _mm512_set1_pd(c[1]), _mm512_set1_pd(c[2]),
                 _mm512_set1_pd(c[3])}};
    }
    __attribute__((target("avx512f"), always_inline)) inline __mmask8 holds(__m512d t) const {
        return _mm512_mask_cmp_pd_mask(_mm512_cmp_pd_mask(lo, t, _CMP_LE_OQ), t, hi, _CMP_LT_OQ);
    }
    __attribute__((target("avx512f"), always_inline)) inline __m512d at(__m512d t) const {
        const __m512d u = _mm512_sub_pd(t, lo);
        __m512d sum = c[3];  // products are not fused: the bits of all levels
        for (int k = 3; k-- > 0;) sum = _mm512_add_pd(c[k], _mm512_mul_pd(u, sum));
        return sum;
    }
    /// This one, and `other` in the lanes of the mask.
    __attribute__((target("avx512f"), always_inline)) inline Avx512Piece with(
        const Avx512Piece& other, __mmask8 lanes) const {
        Avx512Piece both = *this;
        both.lo = _mm512_mask_mov_pd(lo, lanes, other.lo);
        for (int k = 0; k < 4; ++k) both.c[k] = _mm512_mask_mov_pd(c[k], lanes, other.c[k]);
        return both;
    }
};

/// Values of one coordinate, eight at a time as long as they lie on a piece or on it and the next:
/// one wrong guess of a branch a piece. Returns how many, and the piece of the last of them.
struct Avx512Way {
    std::size_t count, piece;
};
__attribute__((target("avx512f"))) Avx512Way walk_avx512(const Indexed& curve, std::size_t piece,
                                                         std::span<const double> t, double* out) {
    constexpr std::size_t lanes = 8;
    Avx512Piece now = Avx512Piece::of(curve, piece);
    std::size_t i = 0;
    for (; i + lanes <= t.size(); i += lanes) {
        const __m512d at = _mm512_loadu_pd(t.data() + i);
        const unsigned on_it = now.holds(at);
        if (on_it == 0xff) {
            _mm512_storeu_pd(out + i, now.at(at));
            continue;
        }
        if (piece + 2 >= curve.breaks.size()) break;
        const Avx512Piece next = Avx512Piece::of(curve, piece + 1);
        const __mmask8 on_next = next.holds(at);
        if ((on_it | on_next) != 0xff) break;
        _mm512_storeu_pd(out + i, now.with(next, on_next).at(at));
        now = next;
        ++piece;
    }
    return {i, piece};
}

__attribute__((target("avx512f"))) void values_avx512(const Indexed& curve,
                                                      std::span<const double> t, double* out) {
    const Kernel<0, 1> kernel{curve};
    std::size_t piece = curve.breaks.size();
    while (!t.empty()) {
        piece = next_piece(curve, piece, t[0]);
        const Avx512Way way = walk_avx512(curve, piece, t, out);
        piece = way.piece;
        std::size_t count = way.count;
        if (count == 0) {
            count = std::min(t.size(), batch_size);
            kernel.scattered(t.first(count), out);
        }
        t = t.subspan(count);
        out += count;
    }
}

__attribute__((target("avx512f"))) void evaluate_avx512(
    const Indexed& curve, std::span<const double> t, int order, double* out) {
    if (order == 0 && curve.dim == 1) return values_avx512(curve, t, out);
    evaluate_any(curve, t, order, out);
}
#endif

Level best_level() {
    for (const Level level : {Level::avx512, Level::avx2}) {
        if (patches::is_offered(level)) return level;
    }
    return Level::plain;
}

}  // namespace

void evaluate_at(patches::Level level, const Indexed& curve, std::span<const double> t, int order,
                 std::span<double> out) {
#ifdef BATTEN_HAS_X86_LEVELS
    if (level == Level::avx512) return evaluate_avx512(curve, t, order, out.data());
    if (level == Level::avx2) return evaluate_avx2(curve, t, order, out.data());
#endif
    assert(level == Level::plain);
    evaluate_plain(curve, t, order, out.data());
}

void evaluate(const Indexed& curve, std::span<const double> t, int order, std::span<double> out) {
    static const Level best = best_level();
    evaluate_at(best, curve, t, order, out);
}

}  // namespace batten::cubics
