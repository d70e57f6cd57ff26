#include "make/fit_surface/residual_totals.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"

namespace batten::surface_fitting {
namespace {

using num::Lanes;
using num::lanes;

struct PieceSums {
    double delta2 = 0, largest_sq = 0;    ///< of weighted residuals
    double highest = 0, lowest = 0;       ///< residual in data units, where there is a weight
    std::array<double, 3> beyond{};       ///< one, two, three standard deviations
};

/// One node by itself.
BATTEN_INLINE double add_node(const Piece& piece, std::size_t s, PieceSums& sums) {
    double d = piece.heights ? piece.z[s] - piece.heights[s] : piece.z[s];
    double e = piece.weight * d;
    if (piece.weights) {
        e *= piece.weights[s];
        if (piece.weights[s] == 0) d = 0;
    }
    const double sq = e * e;
    sums.delta2 += sq;
    sums.largest_sq = std::max(sums.largest_sq, sq);
    sums.highest = std::max(sums.highest, d);
    sums.lowest = std::min(sums.lowest, d);
    sums.beyond[0] += sq > 1 ? 1 : 0;
    sums.beyond[1] += sq > 4 ? 1 : 0;
    sums.beyond[2] += sq > 9 ? 1 : 0;
    return e;
}

/// e = the weighted residuals and their sums: lane by lane, so that all widths of vectors give the same bits.
BATTEN_CLONES void weigh_piece(const Piece& piece, double* e, PieceSums& sums) {
    Lanes delta2 = {}, largest = {}, highest = {}, lowest = {};
    num::LaneMask one = {}, two = {}, three = {};
    const std::size_t whole = piece.count / lanes * lanes;
    for (std::size_t s = 0; s < whole; s += lanes) {
        Lanes d;
        num::load(piece.z + s, d);
#ifdef __GNUC__
        __builtin_prefetch(piece.z + s + piece.count);
#endif
        if (piece.heights) {
            Lanes heights;
            num::load(piece.heights + s, heights);
            d -= heights;
        }
        Lanes weighted = piece.weight * d;
        if (piece.weights) {
            Lanes weights;
            num::load(piece.weights + s, weights);
            weighted *= weights;
            d = weights == 0 ? Lanes{} : d;
        }
        const Lanes sq = weighted * weighted;
        delta2 += sq;
        largest = sq > largest ? sq : largest;
        highest = d > highest ? d : highest;
        lowest = d < lowest ? d : lowest;
        one -= sq > 1;
        two -= sq > 4;
        three -= sq > 9;
        num::store(weighted, e + s);
    }
    sums.delta2 = num::sum_of(delta2);
    sums.largest_sq = num::largest_of(largest);
    sums.highest = num::largest_of(highest);
    sums.lowest = -num::largest_of(-lowest);
    sums.beyond = {static_cast<double>(num::sum_of(one)), static_cast<double>(num::sum_of(two)),
                   static_cast<double>(num::sum_of(three))};
    for (std::size_t s = whole; s < piece.count; ++s) e[s] = add_node(piece, s, sums);
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
    PieceSums sums;
    weigh_piece(piece, e, sums);
    delta2_ += sums.delta2;
    largest_ = std::max({largest_, sums.highest, -sums.lowest});
    for (std::size_t w = 0; w < 3; ++w) beyond_[w] += sums.beyond[w];
    if (sums.largest_sq > 16) count_large(e, piece.count, beyond_);
}

void ResidualTotals::finish(Misfit& result, std::size_t count) const {
    result.delta2 = delta2_;
    result.max_residual = largest_;
    const double all = static_cast<double>(count);
    for (std::size_t w = 0; w < psi_count; ++w) result.psi[w] = (all - beyond_[w]) / all;
}

NodeTotals::NodeTotals(const Nodes& nodes)
    : nodes_(nodes),
      has_one_weight_(nodes.is_full() &&
                      std::all_of(nodes.y_weight.begin(), nodes.y_weight.end(),
                                  [&](double w) { return w == nodes.y_weight[0]; })) {}

void NodeTotals::add(std::size_t r, num::PlaceRange columns, const double* heights, double* e) {
    const std::size_t from = r * nodes_.y.size() + columns.first;
    totals_.add({nodes_.z.data() + from, heights,
                 nodes_.x_weight[r] * (has_one_weight_ ? nodes_.y_weight[0] : 1),
                 has_one_weight_ ? nullptr : weights(from, columns), columns.count()},
                e);
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
