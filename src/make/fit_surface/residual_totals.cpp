#include "make/fit_surface/residual_totals.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"
#include "num/tensor_kernels.hpp"

namespace batten::surface_fitting {
namespace {

using num::Lanes;
using num::lanes;

using Sums = ResidualTotals::Sums;

/// One node by itself, in the first lane.
BATTEN_INLINE double add_node(const Piece& piece, std::size_t s, Sums& sums) {
    double d = piece.heights ? piece.z[s] - piece.heights[s] : piece.z[s];
    double e = piece.weight * d;
    if (piece.weights) {
        e *= piece.weights[s];
        if (piece.weights[s] == 0) d = 0;
    }
    const double sq = e * e;
    sums.delta2[0] += sq;
    sums.highest[0] = std::max(sums.highest[0], d);
    sums.lowest[0] = std::min(sums.lowest[0], d);
    sums.beyond[0][0] += sq > 1 ? 1 : 0;
    sums.beyond[1][0] += sq > 4 ? 1 : 0;
    sums.beyond[2][0] += sq > 9 ? 1 : 0;
    return e;
}

/// The sums in registers.
struct LaneSums {
    Lanes delta2, highest, lowest, beyond[3];
    const Lanes one = {1, 1, 1, 1, 1, 1, 1, 1};

    BATTEN_INLINE explicit LaneSums(const Sums& sums) {
        num::load(sums.delta2.data(), delta2);
        num::load(sums.highest.data(), highest);
        num::load(sums.lowest.data(), lowest);
        for (std::size_t w = 0; w < 3; ++w) num::load(sums.beyond[w].data(), beyond[w]);
    }
    BATTEN_INLINE void leave(Sums& sums) const {
        num::store(delta2, sums.delta2.data());
        num::store(highest, sums.highest.data());
        num::store(lowest, sums.lowest.data());
        for (std::size_t w = 0; w < 3; ++w) num::store(beyond[w], sums.beyond[w].data());
    }
    BATTEN_INLINE void add(const Lanes& d, const Lanes& e, Lanes& largest) {
        const Lanes sq = e * e;
        delta2 += sq;
        largest = sq > largest ? sq : largest;
        highest = d > highest ? d : highest;
        lowest = d < lowest ? d : lowest;
        beyond[0] = sq > 1 ? beyond[0] + one : beyond[0];
        beyond[1] = sq > 4 ? beyond[1] + one : beyond[1];
        beyond[2] = sq > 9 ? beyond[2] + one : beyond[2];
    }
};

/// e = the residuals d weighted; d becomes 0 where there is no weight.
BATTEN_INLINE void weigh(double weight, const double* weights, Lanes& d, Lanes& e) {
    e = weight * d;
    if (!weights) return;
    Lanes more;
    num::load(weights, more);
    e *= more;
    d = more == 0 ? Lanes{} : d;
}

BATTEN_INLINE void fetch(const double* z) {
#ifdef __GNUC__
    __builtin_prefetch(z);
#else
    static_cast<void>(z);
#endif
}

/// e = the weighted residuals; the largest of their squares.
BATTEN_CLONES double weigh_piece(const Piece& piece, double* e, Sums& sums) {
    LaneSums all(sums);
    Lanes largest = {};
    const std::size_t whole = piece.count / lanes * lanes;
    for (std::size_t s = 0; s < whole; s += lanes) {
        Lanes d, weighted;
        num::load(piece.z + s, d);
        if (piece.heights) {
            Lanes heights;
            num::load(piece.heights + s, heights);
            d -= heights;
        }
        fetch(piece.z + s + piece.count);
        weigh(piece.weight, piece.weights ? piece.weights + s : nullptr, d, weighted);
        all.add(d, weighted, largest);
        num::store(weighted, e + s);
    }
    all.leave(sums);
    double largest_sq = num::largest_of(largest);
    for (std::size_t s = whole; s < piece.count; ++s) {
        e[s] = add_node(piece, s, sums);
        largest_sq = std::max(largest_sq, e[s] * e[s]);
    }
    return largest_sq;
}

using FourLargest = std::array<double, 4>;

template <int Rows>
BATTEN_INLINE void weigh_few(const CubicRows& piece, Sums& sums, FourLargest& largest_sq) {
    LaneSums all(sums);
    Lanes largest[Rows] = {};
    const std::size_t whole = piece.count / lanes * lanes;
    for (std::size_t s = 0; s < whole; s += lanes) {
        Lanes line[4];
        for (std::size_t i = 0; i < 4; ++i) num::load(piece.lines[i] + s, line[i]);
        for (std::size_t q = 0; q < Rows; ++q) {
            const double* const z = piece.z + q * piece.stride + s;
            const double* const a = piece.factors + 4 * q;
            Lanes d, weighted;
            num::load(z, d);
            fetch(z + piece.count);
            d -= (a[0] * line[0] + a[1] * line[1]) + (a[2] * line[2] + a[3] * line[3]);
            weigh(piece.weight[q], piece.weights ? piece.weights + s : nullptr, d, weighted);
            all.add(d, weighted, largest[q]);
        }
    }
    all.leave(sums);
    for (std::size_t q = 0; q < Rows; ++q) {
        largest_sq[q] = num::largest_of(largest[q]);
        const double* const a = piece.factors + 4 * q;
        for (std::size_t s = whole; s < piece.count; ++s) {
            const double height = (a[0] * piece.lines[0][s] + a[1] * piece.lines[1][s]) +
                                  (a[2] * piece.lines[2][s] + a[3] * piece.lines[3][s]);
            const double e = add_node({piece.z + q * piece.stride + s, &height, piece.weight[q],
                                       piece.weights ? piece.weights + s : nullptr, 1},
                                      0, sums);
            largest_sq[q] = std::max(largest_sq[q], e * e);
        }
    }
}

BATTEN_CLONES void weigh_rows(const CubicRows& piece, std::size_t rows, Sums& sums,
                              FourLargest& largest_sq) {
    if (rows == 4) weigh_few<4>(piece, sums, largest_sq);
    if (rows == 3) weigh_few<3>(piece, sums, largest_sq);
    if (rows == 2) weigh_few<2>(piece, sums, largest_sq);
    if (rows == 1) weigh_few<1>(piece, sums, largest_sq);
}

/// How many of 4, 5 ... psi_count standard deviations each residual is beyond.
BATTEN_CLONES void count_large(const double* e, std::size_t count,
                               std::array<double, psi_count>& beyond) {
    std::size_t s = 0;
    num::LaneMask masks[psi_count] = {};
    for (; s + lanes <= count; s += lanes) {
        Lanes size;
        num::load(e + s, size);
        size = size < 0 ? -size : size;
        for (int w = 4; w <= psi_count; ++w) masks[w - 1] -= size > static_cast<double>(w);
    }
    for (std::size_t w = 3; w < psi_count; ++w) {
        beyond[w] += static_cast<double>(num::sum_of(masks[w]));
    }
    for (; s < count; ++s) {
        for (int w = 4; w <= psi_count && std::fabs(e[s]) > w; ++w) {
            beyond[static_cast<std::size_t>(w - 1)] += 1;
        }
    }
}

}  // namespace

void ResidualTotals::add(const Piece& piece, double* e) {
    if (weigh_piece(piece, e, sums_) > 16) count_large(e, piece.count, beyond_);
}

void ResidualTotals::add(const CubicRows& piece, std::size_t rows) {
    FourLargest largest_sq{};
    weigh_rows(piece, rows, sums_, largest_sq);
    for (std::size_t q = 0; q < rows; ++q) {
        if (!(largest_sq[q] > 16)) continue;
        Sums known;
        std::vector<double> e(piece.count);
        num::combine(piece.lines.data(), piece.factors + 4 * q, 4, {0, piece.count}, e.data());
        weigh_piece({piece.z + q * piece.stride, e.data(), piece.weight[q], piece.weights,
                     piece.count},
                    e.data(), known);
        count_large(e.data(), piece.count, beyond_);
    }
}

void ResidualTotals::finish(Misfit& result, std::size_t count) const {
    const auto sum_of = [](const std::array<double, lanes>& sums) {
        Lanes all;
        num::load(sums.data(), all);
        return num::sum_of(all);
    };
    result.delta2 = sum_of(sums_.delta2);
    result.max_residual =
        std::max(*std::max_element(sums_.highest.begin(), sums_.highest.end()),
                 -*std::min_element(sums_.lowest.begin(), sums_.lowest.end()));
    const double all = static_cast<double>(count);
    for (std::size_t w = 0; w < psi_count; ++w) {
        const double beyond = w < 3 ? sum_of(sums_.beyond[w]) : beyond_[w];
        result.psi[w] = (all - beyond) / all;
    }
}

NodeTotals::NodeTotals(const Nodes& nodes)
    : nodes_(nodes),
      has_one_weight_(nodes.is_full() &&
                      std::all_of(nodes.y_weight.begin(), nodes.y_weight.end(),
                                  [&](double w) { return w == nodes.y_weight[0]; })) {}

void NodeTotals::add(std::size_t r, num::PlaceRange columns, const double* heights, double* e) {
    const std::size_t from = r * nodes_.y.size() + columns.first;
    totals_.add({nodes_.z.data() + from, heights, row_weight(r),
                 has_one_weight_ ? nullptr : weights(from, columns), columns.count()},
                e);
}

void NodeTotals::add(const num::Tensor::Block& block, const num::TensorSide& x) {
    if (x.order == 4 && nodes_.is_full()) return add_cubic(block, x);
    heights_.resize(block.columns.count());
    for (std::size_t r = block.rows.first; r < block.rows.last; ++r) {
        num::combine(block.lines, x.at(r), static_cast<std::size_t>(x.order), block.columns,
                     heights_.data());
        add(r, block.columns, heights_.data(), heights_.data());
    }
}

void NodeTotals::add_cubic(const num::Tensor::Block& block, const num::TensorSide& x) {
    const std::size_t stride = nodes_.y.size(), from = block.columns.first;
    CubicRows piece{nullptr, stride, {}, nullptr, {},
                    has_one_weight_ ? nullptr : nodes_.y_weight.data() + from,
                    block.columns.count()};
    for (std::size_t i = 0; i < 4; ++i) piece.lines[i] = block.lines[i] + from;
    for (std::size_t r = block.rows.first; r < block.rows.last; r += 4) {
        const std::size_t rows = std::min<std::size_t>(4, block.rows.last - r);
        piece.z = nodes_.z.data() + r * stride + from;
        piece.factors = x.at(r);
        for (std::size_t q = 0; q < rows; ++q) piece.weight[q] = row_weight(r + q);
        totals_.add(piece, rows);
    }
}

const double* NodeTotals::weights(std::size_t from, num::PlaceRange columns) {
    const double* const y_weight = nodes_.y_weight.data() + columns.first;
    if (nodes_.is_full()) return y_weight;
    weights_.resize(columns.count());
    for (std::size_t s = 0; s < columns.count(); ++s) {
        weights_[s] = y_weight[s] * std::sqrt(nodes_.cell_factor_sq[from + s]);
    }
    return weights_.data();
}

}  // namespace batten::surface_fitting
