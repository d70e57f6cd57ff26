#include "num/tensor.hpp"

#include <algorithm>
#include <cassert>

#include "num/cox_de_boor.hpp"

// One copy of the kernels per vector width; contraction is off, so all give the same bits.
#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define BATTEN_TENSOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define BATTEN_TENSOR_CLONES
#endif

namespace batten::num {
namespace {

/// Columns worked on at a time: the sums of one block stay in the first cache.
constexpr std::size_t block = 512;

/// out[s] = sum of h[j] y[j * stride + s].
BATTEN_TENSOR_CLONES void combine_4(const double* y, std::size_t stride, const double* h,
                                    std::size_t count, double* __restrict out) {
    const double h0 = h[0], h1 = h[1], h2 = h[2], h3 = h[3];
    const double* const y1 = y + stride;
    const double* const y2 = y1 + stride;
    const double* const y3 = y2 + stride;
    for (std::size_t s = 0; s < count; ++s) {
        out[s] = (h0 * y[s] + h1 * y1[s]) + (h2 * y2[s] + h3 * y3[s]);
    }
}

void combine(const double* y, std::size_t stride, const double* h, int order, std::size_t count,
             double* out) {
    if (order == 4) return combine_4(y, stride, h, count, out);
    for (std::size_t s = 0; s < count; ++s) {
        double sum = 0;
        for (int j = 0; j < order; ++j) sum += h[j] * y[static_cast<std::size_t>(j) * stride + s];
        out[s] = sum;
    }
}

/// sums[s] += a[0] z0[s] + a[1] z1[s] + a[2] z2[s] + a[3] z3[s].
BATTEN_TENSOR_CLONES void add_rows_4(const double* z, std::size_t stride, const double* a,
                                     std::size_t count, double* __restrict sums) {
    const double a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3];
    const double* const z1 = z + stride;
    const double* const z2 = z1 + stride;
    const double* const z3 = z2 + stride;
    for (std::size_t s = 0; s < count; ++s) {
        sums[s] += (a0 * z[s] + a1 * z1[s]) + (a2 * z2[s] + a3 * z3[s]);
    }
}

/// The same for four functions at once: a[4 i + q] weighs row q for the sums i * block away.
BATTEN_TENSOR_CLONES void add_rows_4x4(const double* z, std::size_t stride, const double* a,
                                       std::size_t count, double* __restrict sums) {
    const double* const z1 = z + stride;
    const double* const z2 = z1 + stride;
    const double* const z3 = z2 + stride;
    double* __restrict const t1 = sums + block;
    double* __restrict const t2 = t1 + block;
    double* __restrict const t3 = t2 + block;
    for (std::size_t s = 0; s < count; ++s) {
        const double u0 = z[s], u1 = z1[s], u2 = z2[s], u3 = z3[s];
        sums[s] += (a[0] * u0 + a[1] * u1) + (a[2] * u2 + a[3] * u3);
        t1[s] += (a[4] * u0 + a[5] * u1) + (a[6] * u2 + a[7] * u3);
        t2[s] += (a[8] * u0 + a[9] * u1) + (a[10] * u2 + a[11] * u3);
        t3[s] += (a[12] * u0 + a[13] * u1) + (a[14] * u2 + a[15] * u3);
    }
}

BATTEN_TENSOR_CLONES void add_row(const double* z, double a, std::size_t count,
                                  double* __restrict sums) {
    for (std::size_t s = 0; s < count; ++s) sums[s] += a * z[s];
}

double dot(const double* a, const double* b, std::size_t count) {
    double lane[4] = {};
    std::size_t s = 0;
    for (; s + 4 <= count; s += 4) {
        for (std::size_t l = 0; l < 4; ++l) lane[l] += a[s + l] * b[s + l];
    }
    for (; s < count; ++s) lane[0] += a[s] * b[s];
    return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

/// out[j] += dot of `from` and y[j * stride ...], four at once; each as `dot`.
BATTEN_TENSOR_CLONES void add_dots_4(const double* from, const double* y, std::size_t stride,
                                     std::size_t count, double* out) {
    double lane[4][4] = {};
    std::size_t s = 0;
    for (; s + 4 <= count; s += 4) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t l = 0; l < 4; ++l) {
                lane[j][l] += from[s + l] * y[j * stride + s + l];
            }
        }
    }
    for (std::size_t j = 0; j < 4; ++j) {
        for (std::size_t t = s; t < count; ++t) lane[j][0] += from[t] * y[j * stride + t];
        out[j] += (lane[j][0] + lane[j][1]) + (lane[j][2] + lane[j][3]);
    }
}

}  // namespace

Tensor::Tensor(const TensorSide& x, const TensorSide& y) : x_(&x), y_(&y) {
    const std::size_t places = y.places(), order = static_cast<std::size_t>(y.order);
    y_turned_.resize(places * order);
    for (std::size_t s = 0; s < places; ++s) {
        for (std::size_t j = 0; j < order; ++j) y_turned_[j * places + s] = y.at(s)[j];
    }
    for (std::size_t s = 0; s < places; ++s) {
        if (s % block == 0) block_runs_.push_back(runs_.size());
        if (s % block == 0 || y.first[s] != y.first[s - 1]) runs_.push_back({s, s, y.first[s]});
        runs_.back().last = s + 1;
    }
    block_runs_.push_back(runs_.size());
}

void Tensor::expand(std::span<const double> c, PlaceRange rows, std::span<double> out) const {
    const std::size_t places = y_->places(), functions = y_->functions;
    const std::size_t y_order = static_cast<std::size_t>(y_->order);
    std::vector<double> h(functions);
    for (std::size_t b = 0; b + 1 < block_runs_.size(); ++b) {
        const std::span<const Run> runs(runs_.data() + block_runs_[b],
                                        block_runs_[b + 1] - block_runs_[b]);
        const std::size_t from = runs.front().function, to = runs.back().function + y_order;
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            std::fill(h.data() + from, h.data() + to, 0.0);
            for (int i = 0; i < x_->order; ++i) {
                const double a = x_->at(r)[i];
                const double* const row =
                    c.data() + (x_->first[r] + static_cast<std::size_t>(i)) * functions;
                for (std::size_t j = from; j < to; ++j) h[j] += a * row[j];
            }
            double* const line = out.data() + (r - rows.first) * places;
            for (const Run& run : runs) {
                combine(y_turned_.data() + run.first, places, h.data() + run.function, y_->order,
                        run.last - run.first, line + run.first);
            }
        }
    }
}

void Tensor::flush(const double* sums, PlaceRange columns, std::size_t run, std::size_t function,
                   std::span<double> g) const {
    const std::size_t places = y_->places();
    const std::size_t y_order = static_cast<std::size_t>(y_->order);
    for (std::size_t i = 0; i < static_cast<std::size_t>(x_->order); ++i) {
        double* const row = g.data() + (function + i) * y_->functions;
        for (std::size_t q = run; q < runs_.size() && runs_[q].first < columns.last; ++q) {
            const Run& at = runs_[q];
            const double* const from = sums + i * block + (at.first - columns.first);
            if (y_order == 4) {
                add_dots_4(from, y_turned_.data() + at.first, places, at.last - at.first,
                           row + at.function);
                continue;
            }
            for (std::size_t j = 0; j < y_order; ++j) {
                row[at.function + j] += dot(from, y_turned_.data() + j * places + at.first,
                                            at.last - at.first);
            }
        }
    }
}

void Tensor::contract(std::span<const double> z, PlaceRange rows, std::span<double> g) const {
    const std::size_t places = y_->places(), order = static_cast<std::size_t>(x_->order);
    std::vector<double> sums(order * block);
    double a[4];
    for (std::size_t b = 0; b + 1 < block_runs_.size(); ++b) {
        const PlaceRange columns{b * block, std::min(places, (b + 1) * block)};
        for (std::size_t r = rows.first; r < rows.last;) {
            const std::size_t function = x_->first[r];
            std::fill(sums.begin(), sums.end(), 0.0);
            for (; r < rows.last && x_->first[r] == function;) {
                const double* const from = z.data() + (r - rows.first) * places + columns.first;
                const bool is_four = r + 4 <= rows.last && x_->first[r + 3] == function;
                if (is_four && order == 4) {
                    double all[16];
                    for (std::size_t k = 0; k < 16; ++k) all[k] = x_->at(r + k % 4)[k / 4];
                    add_rows_4x4(from, places, all, columns.count(), sums.data());
                    r += 4;
                    continue;
                }
                for (std::size_t i = 0; i < order; ++i) {
                    double* const to = sums.data() + i * block;
                    if (!is_four) {
                        add_row(from, x_->at(r)[i], columns.count(), to);
                        continue;
                    }
                    for (std::size_t q = 0; q < 4; ++q) a[q] = x_->at(r + q)[i];
                    add_rows_4(from, places, a, columns.count(), to);
                }
                r += is_four ? 4 : 1;
            }
            flush(sums.data(), columns, block_runs_[b], function, g);
        }
    }
}

}  // namespace batten::num
