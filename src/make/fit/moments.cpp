#include "make/fit/moments.hpp"

#include "make/fit/lanes.hpp"

namespace batten::fitting {
namespace {

/// The last, incomplete block of lanes: filled up with samples of weight 0.
struct Tail {
    double x[lanes], y[lanes], weight_sq[lanes];
};

template <int Order>
BATTEN_INLINE void accumulate(const Lanes& u, const Lanes& weight_sq, const Lanes& y,
                              Lanes* gram, Lanes* side) {
    Lanes before = weight_sq;
    Lanes here = weight_sq * u;
    const Lanes twice = u + u;
    gram[0] += before;
    side[0] += before * y;
    if (Order > 1) {
        gram[1] += here;
        side[1] += here * y;
    }
    for (int m = 2; m < 2 * Order - 1; ++m) {
        const Lanes next = twice * here - before;
        before = here;
        here = next;
        gram[m] += here;
        if (m < Order) side[m] += here * y;
    }
}

template <int Order>
BATTEN_INLINE void moments_of(const SampleRun& run, LocalScale scale, Moments& out) {
    Lanes gram[2 * Order - 1] = {}, side[Order] = {}, largest = {};
    const std::size_t whole = run.count / lanes * lanes;
    const Lanes one = {1, 1, 1, 1, 1, 1, 1, 1};
    Lanes x, y, weight_sq = one;
    for (std::size_t i = 0; i < whole; i += lanes) {
        load(run.x + i, x);
        load(run.y + i, y);
        if (run.sigma) {
            Lanes sigma;
            load(run.sigma + i, sigma);
            weight_sq = one / (sigma * sigma);
            largest = weight_sq > largest ? weight_sq : largest;
        }
        accumulate<Order>((x - scale.middle) * scale.scale, weight_sq, y, gram, side);
    }
    if (whole < run.count) {
        Tail tail = {};
        for (std::size_t l = 0; whole + l < run.count; ++l) {
            const double s = run.sigma ? run.sigma[whole + l] : 1;
            tail.x[l] = (run.x[whole + l] - scale.middle) * scale.scale;
            tail.y[l] = run.y[whole + l];
            tail.weight_sq[l] = 1 / (s * s);
        }
        load(tail.x, x);
        load(tail.y, y);
        load(tail.weight_sq, weight_sq);
        largest = weight_sq > largest ? weight_sq : largest;
        accumulate<Order>(x, weight_sq, y, gram, side);
    }
    for (int m = 0; m < 2 * Order - 1; ++m) {
        out.gram[static_cast<std::size_t>(m)] = sum_of(gram[m]);
    }
    for (int j = 0; j < Order; ++j) out.side[static_cast<std::size_t>(j)] = sum_of(side[j]);
    if (run.sigma) out.largest_weight_sq = largest_of(largest);
}

template <int Order>
BATTEN_INLINE double rest_of(const SampleRun& run, LocalScale scale, const double* p) {
    // Clenshaw's recurrence [DLMF, 3.11(ii)], all lanes at once.
    Lanes sum = {};
    const std::size_t whole = run.count / lanes * lanes;
    for (std::size_t i = 0; i < whole; i += lanes) {
        Lanes x, y;
        load(run.x + i, x);
        load(run.y + i, y);
        const Lanes u = (x - scale.middle) * scale.scale;
        const Lanes twice = u + u;
        Lanes b1 = {}, b2 = {};
        for (int j = Order - 1; j > 0; --j) {
            const Lanes b0 = p[j] + (twice * b1 - b2);
            b2 = b1;
            b1 = b0;
        }
        Lanes e = y - (p[0] + (u * b1 - b2));
        if (run.sigma) {
            Lanes sigma;
            load(run.sigma + i, sigma);
            e /= sigma;
        }
        sum += e * e;
    }
    double total = sum_of(sum);
    for (std::size_t i = whole; i < run.count; ++i) {
        const double u = (run.x[i] - scale.middle) * scale.scale;
        double b1 = 0, b2 = 0;
        for (int j = Order - 1; j > 0; --j) {
            const double b0 = p[j] + (2 * u * b1 - b2);
            b2 = b1;
            b1 = b0;
        }
        double e = run.y[i] - (p[0] + (u * b1 - b2));
        if (run.sigma) e /= run.sigma[i];
        total += e * e;
    }
    return total;
}

#define BATTEN_KERNELS(order)                                                             \
    BATTEN_CLONES void moments_##order(const SampleRun& run, LocalScale scale, Moments& out) { \
        moments_of<order>(run, scale, out);                                               \
    }                                                                                     \
    BATTEN_CLONES double rest_##order(const SampleRun& run, LocalScale scale, const double* p) { \
        return rest_of<order>(run, scale, p);                                             \
    }
BATTEN_KERNELS(1)
BATTEN_KERNELS(2)
BATTEN_KERNELS(3)
BATTEN_KERNELS(4)
BATTEN_KERNELS(5)
BATTEN_KERNELS(6)
#undef BATTEN_KERNELS

BATTEN_CLONES void residuals_of(const SampleRun& run, LocalScale scale, int order,
                                const double* p, double* out) {
    const std::size_t whole = run.count / lanes * lanes;
    for (std::size_t i = 0; i < whole; i += lanes) {
        Lanes x, y;
        load(run.x + i, x);
        load(run.y + i, y);
        const Lanes u = (x - scale.middle) * scale.scale;
        const Lanes twice = u + u;
        Lanes b1 = {}, b2 = {};
        for (int j = order - 1; j > 0; --j) {
            const Lanes b0 = p[j] + (twice * b1 - b2);
            b2 = b1;
            b1 = b0;
        }
        const Lanes e = y - (p[0] + (u * b1 - b2));
        std::memcpy(out + i, &e, sizeof e);
    }
    for (std::size_t i = whole; i < run.count; ++i) {
        const double u = (run.x[i] - scale.middle) * scale.scale;
        double b1 = 0, b2 = 0;
        for (int j = order - 1; j > 0; --j) {
            const double b0 = p[j] + ((u + u) * b1 - b2);
            b2 = b1;
            b1 = b0;
        }
        out[i] = run.y[i] - (p[0] + (u * b1 - b2));
    }
}

}  // namespace

Moments chebyshev_moments(const SampleRun& run, LocalScale scale, int order) {
    constexpr decltype(&moments_1) kernels[] = {moments_1, moments_2, moments_3,
                                                moments_4, moments_5, moments_6};
    Moments result;
    kernels[order - 1](run, scale, result);
    return result;
}

void residuals(const SampleRun& run, LocalScale scale, int order, const double* p, double* out) {
    residuals_of(run, scale, order, p, out);
}

double squared_rest(const SampleRun& run, LocalScale scale, int order, const double* p) {
    constexpr decltype(&rest_1) kernels[] = {rest_1, rest_2, rest_3, rest_4, rest_5, rest_6};
    return kernels[order - 1](run, scale, p);
}

}  // namespace batten::fitting
