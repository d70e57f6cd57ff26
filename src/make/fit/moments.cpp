#include "make/fit/moments.hpp"

#include <algorithm>
#include <limits>

#include "num/lanes.hpp"

namespace batten::fitting {
namespace {

using num::Lanes;
using num::lanes;

/// Eight samples, or fewer: then filled up with samples of weight 0.
struct Block {
    Lanes u, y, sigma;
    bool has_sigma;
    std::size_t first, count;
};

BATTEN_INLINE void load_block(const SampleRun& run, LocalScale scale, std::size_t first,
                              Block& block) {
    Lanes x;
    num::load(run.x + first, x);
    num::load(run.y + first, block.y);
    if (run.sigma) num::load(run.sigma + first, block.sigma);
    block.u = (x - scale.middle) * scale.scale;
    block.has_sigma = run.sigma != nullptr;
    block.first = first;
    block.count = lanes;
}

BATTEN_INLINE void load_rest(const SampleRun& run, LocalScale scale, std::size_t first,
                             Block& block) {
    double u[lanes] = {}, y[lanes] = {}, sigma[lanes];
    std::fill_n(sigma, lanes, std::numeric_limits<double>::infinity());
    block.count = run.count - first;
    for (std::size_t l = 0; l < block.count; ++l) {
        u[l] = (run.x[first + l] - scale.middle) * scale.scale;
        y[l] = run.y[first + l];
        sigma[l] = run.sigma ? run.sigma[first + l] : 1;
    }
    num::load(u, block.u);
    num::load(y, block.y);
    num::load(sigma, block.sigma);
    block.has_sigma = true;
    block.first = first;
}

template <class Work>
BATTEN_INLINE void for_blocks(const SampleRun& run, LocalScale scale, Work& work) {
    const std::size_t whole = run.count / lanes * lanes;
    Block block;
    for (std::size_t i = 0; i < whole; i += lanes) {
        load_block(run, scale, i, block);
        work.add(block);
    }
    if (whole == run.count) return;
    load_rest(run, scale, whole, block);
    work.add(block);
}

template <int Order>
struct MomentSums {
    Lanes gram[2 * Order - 1] = {}, side[Order] = {}, largest = {};

    BATTEN_INLINE void add(const Block& block) {
        const Lanes one = {1, 1, 1, 1, 1, 1, 1, 1};
        Lanes before = one;
        if (block.has_sigma) {
            before = one / (block.sigma * block.sigma);
            largest = before > largest ? before : largest;
        }
        Lanes here = before * block.u;
        const Lanes twice = block.u + block.u;
        gram[0] += before;
        side[0] += before * block.y;
        if constexpr (Order > 1) {
            gram[1] += here;
            side[1] += here * block.y;
        }
        for (int m = 2; m < 2 * Order - 1; ++m) {
            const Lanes next = twice * here - before;
            before = here;
            here = next;
            gram[m] += here;
            if (m < Order) side[m] += here * block.y;
        }
    }
};

template <int Order>
BATTEN_INLINE void moments_of(const SampleRun& run, LocalScale scale, Moments& out) {
    MomentSums<Order> sums;
    for_blocks(run, scale, sums);
    for (int m = 0; m < 2 * Order - 1; ++m) {
        out.gram[static_cast<std::size_t>(m)] = num::sum_of(sums.gram[m]);
    }
    for (int j = 0; j < Order; ++j) {
        out.side[static_cast<std::size_t>(j)] = num::sum_of(sums.side[j]);
    }
    if (run.sigma) out.largest_weight_sq = num::largest_of(sums.largest);
}

/// y - p(u) by Clenshaw's recurrence [DLMF, 3.11(ii)].
BATTEN_INLINE void residual_of(const Block& block, int order, const double* p, Lanes& out) {
    const Lanes twice = block.u + block.u;
    Lanes b1 = {}, b2 = {};
    for (int j = order - 1; j > 0; --j) {
        const Lanes b0 = p[j] + (twice * b1 - b2);
        b2 = b1;
        b1 = b0;
    }
    out = block.y - (p[0] + (block.u * b1 - b2));
}

template <int Order>
struct RestSum {
    const double* p;
    Lanes sum = {};

    BATTEN_INLINE void add(const Block& block) {
        Lanes e;
        residual_of(block, Order, p, e);
        if (block.has_sigma) e /= block.sigma;
        sum += e * e;
    }
};

template <int Order>
BATTEN_INLINE double rest_of(const SampleRun& run, LocalScale scale, const double* p) {
    RestSum<Order> rest{p};
    for_blocks(run, scale, rest);
    return num::sum_of(rest.sum);
}

struct ResidualWriter {
    int order;
    const double* p;
    double* out;

    BATTEN_INLINE void add(const Block& block) {
        Lanes e;
        residual_of(block, order, p, e);
        std::memcpy(out + block.first, &e, block.count * sizeof(double));
    }
};

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

BATTEN_CLONES void residuals_of(const SampleRun& run, LocalScale scale, ResidualWriter& writer) {
    for_blocks(run, scale, writer);
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
    ResidualWriter writer{order, p, out};
    residuals_of(run, scale, writer);
}

double squared_rest(const SampleRun& run, LocalScale scale, int order, const double* p) {
    constexpr decltype(&rest_1) kernels[] = {rest_1, rest_2, rest_3, rest_4, rest_5, rest_6};
    return kernels[order - 1](run, scale, p);
}

}  // namespace batten::fitting
