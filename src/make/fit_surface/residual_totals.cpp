#include "make/fit_surface/residual_totals.hpp"

#include <algorithm>
#include <cmath>

#include "num/lanes.hpp"

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

/// e = the weighted residuals; the largest of their squares.
BATTEN_CLONES double weigh_piece(const Piece& piece, double* e, Sums& sums) {
    const Lanes one = {1, 1, 1, 1, 1, 1, 1, 1};
    Lanes delta2, highest, lowest, beyond[3], largest = {};
    num::load(sums.delta2.data(), delta2);
    num::load(sums.highest.data(), highest);
    num::load(sums.lowest.data(), lowest);
    for (std::size_t w = 0; w < 3; ++w) num::load(sums.beyond[w].data(), beyond[w]);
    const std::size_t whole = piece.count / lanes * lanes;
    for (std::size_t s = 0; s < whole; s += lanes) {
        Lanes d;
        num::load(piece.z + s, d);
        if (piece.heights) {
            Lanes heights;
            num::load(piece.heights + s, heights);
            d -= heights;
        }
#ifdef __GNUC__
        __builtin_prefetch(piece.z + s + piece.count);
#endif
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
        beyond[0] = sq > 1 ? beyond[0] + one : beyond[0];
        beyond[1] = sq > 4 ? beyond[1] + one : beyond[1];
        beyond[2] = sq > 9 ? beyond[2] + one : beyond[2];
        num::store(weighted, e + s);
    }
    num::store(delta2, sums.delta2.data());
    num::store(highest, sums.highest.data());
    num::store(lowest, sums.lowest.data());
    for (std::size_t w = 0; w < 3; ++w) num::store(beyond[w], sums.beyond[w].data());
    double largest_sq = num::largest_of(largest);
    for (std::size_t s = whole; s < piece.count; ++s) {
        e[s] = add_node(piece, s, sums);
        largest_sq = std::max(largest_sq, e[s] * e[s]);
    }
    return largest_sq;
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
