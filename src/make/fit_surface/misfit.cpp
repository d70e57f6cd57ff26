#include <algorithm>
#include <cmath>

#include "make/fit_surface/solve.hpp"
#include "num/lanes.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

using num::Lanes;
using num::lanes;

constexpr std::size_t rows_of_misfit = 16;

/// A piece of one row: heights, the surface there, and weights.
struct Piece {
    const double* z;
    const double* heights;
    double weight;             ///< of the whole row
    const double* weights;     ///< times these, unless null
    std::size_t count;
};

struct PieceSums {
    double delta2 = 0, largest_sq = 0;    ///< of weighted residuals
    double highest = 0, lowest = 0;       ///< residual in data units, where there is a weight
    std::array<double, 3> beyond{};       ///< one, two, three standard deviations
};

/// One node by itself.
BATTEN_INLINE double add_node(const Piece& piece, std::size_t s, PieceSums& sums) {
    double d = piece.z[s] - piece.heights[s], e = piece.weight * d;
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

/// e = the weighted residuals, which may take the place of the heights, and their sums: lane by
/// lane, so that all widths of vectors give the same bits.
BATTEN_CLONES void weigh_piece(const Piece& piece, double* e, PieceSums& sums) {
    Lanes delta2 = {}, largest = {}, highest = {}, lowest = {};
    num::LaneMask one = {}, two = {}, three = {};
    const std::size_t whole = piece.count / lanes * lanes;
    for (std::size_t s = 0; s < whole; s += lanes) {
        Lanes z, height, weighted;
        num::load(piece.z + s, z);
        num::load(piece.heights + s, height);
#ifdef __GNUC__
        __builtin_prefetch(piece.z + s + piece.count);
#endif
        Lanes d = z - height;
        weighted = piece.weight * d;
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

BATTEN_CLONES void add_scaled(const double* e, double value, std::size_t count,
                              double* __restrict to) {
    for (std::size_t s = 0; s < count; ++s) to[s] += value * e[s];
}

/// Where x-strips are measured: residuals e of weight 1, row after row.
class Strips {
public:
    Strips(const Nodes& nodes, const Axis& x, const Axis& y, StripRule rule)
        : nodes_(nodes), x_(x), y_(y), rule_(rule), x_part_(x.basis().breaks().size() - 1, 0.0) {
        const std::size_t width = rule == StripRule::projected ? x.functions() : 1;
        y_sums_.assign(width * nodes.y.size(), 0.0);
        if (rule == StripRule::marginal) y_counts_.assign(nodes.y.size(), 0.0);
    }

    void add_row(std::size_t r, const double* e) {
        if (rule_ == StripRule::projected) add_projected(r, e);
        else add_marginal(r, e);
    }

    void finish(Misfit& result) {
        result.x_strips = std::move(x_part_);
        result.y_strips.assign(y_.basis().breaks().size() - 1, 0.0);
        const std::size_t ny = nodes_.y.size();
        const std::size_t width = y_sums_.size() / ny;
        if (rule_ == StripRule::projected) x_.forward_rows(y_sums_, ny);
        for (std::size_t s = 0; s < ny; ++s) {
            double sum = 0;
            for (std::size_t i = 0; i < width; ++i) {
                sum += y_sums_[i * ny + s] * y_sums_[i * ny + s];
            }
            const double share = rule_ == StripRule::projected ? static_cast<double>(width)
                                                               : y_counts_[s];
            result.y_strips[strip_of(y_, nodes_.y[s])] += share > 0 ? sum / share : 0;
        }
    }

private:
    static std::size_t strip_of(const Axis& axis, double t) {
        const std::span<const double> breaks = axis.basis().breaks();
        const auto inside = breaks.subspan(1, breaks.size() - 2);
        return static_cast<std::size_t>(std::upper_bound(inside.begin(), inside.end(), t) -
                                        inside.begin());
    }

    void add_projected(std::size_t r, const double* e) {
        const std::size_t ny = nodes_.y.size(), q = y_.functions();
        const num::TensorSide& b = y_.weighted();
        along_.assign(q, 0.0);
        for (std::size_t s = 0; s < ny; ++s) {
            const double* const values = b.at(s);
            for (int j = 0; j < b.order; ++j) {
                along_[b.first[s] + static_cast<std::size_t>(j)] += e[s] * values[j];
            }
        }
        y_.forward_rows(along_, 1);
        double sum = 0;
        for (const double a : along_) sum += a * a;
        x_part_[strip_of(x_, nodes_.x[r])] += sum / static_cast<double>(q);
        const num::TensorSide& a = x_.weighted();
        for (int i = 0; i < a.order; ++i) {
            double* const to = y_sums_.data() + (a.first[r] + static_cast<std::size_t>(i)) * ny;
            add_scaled(e, a.at(r)[i], ny, to);
        }
    }

    void add_marginal(std::size_t r, const double* e) {
        const std::size_t ny = nodes_.y.size();
        double sum = 0, count = 0;
        for (std::size_t s = 0; s < ny; ++s) {
            const bool counts = nodes_.is_full() || nodes_.cell_factor_sq[r * ny + s] > 0;
            sum += e[s];
            count += counts;
            y_sums_[s] += e[s];
            y_counts_[s] += counts;
        }
        if (count > 0) x_part_[strip_of(x_, nodes_.x[r])] += sum * sum / count;
    }

    const Nodes& nodes_;
    const Axis& x_;
    const Axis& y_;
    StripRule rule_;
    std::vector<double> x_part_, y_sums_, y_counts_, along_;
};

/// delta2, the counts behind psi and the largest residual.
class Totals {
public:
    explicit Totals(const Nodes& nodes)
        : nodes_(nodes),
          has_one_weight_(nodes.is_full() &&
                          std::all_of(nodes.y_weight.begin(), nodes.y_weight.end(),
                                      [&](double w) { return w == nodes.y_weight[0]; })) {}

    /// Takes in a piece of row r; e becomes its weighted residuals.
    void add(std::size_t r, num::PlaceRange columns, const double* heights, double* e) {
        const std::size_t from = r * nodes_.y.size() + columns.first;
        const Piece piece{nodes_.z.data() + from, heights,
                          nodes_.x_weight[r] * (has_one_weight_ ? nodes_.y_weight[0] : 1),
                          has_one_weight_ ? nullptr : weights(from, columns), columns.count()};
        PieceSums sums;
        weigh_piece(piece, e, sums);
        delta2_ += sums.delta2;
        largest_ = std::max({largest_, sums.highest, -sums.lowest});
        for (std::size_t w = 0; w < 3; ++w) beyond_[w] += sums.beyond[w];
        if (sums.largest_sq > 16) add_large(e, columns.count());
    }

    void finish(Misfit& result) const {
        result.delta2 = delta2_;
        result.max_residual = largest_;
        for (std::size_t w = 0; w < psi_count; ++w) {
            const double count = static_cast<double>(nodes_.count);
            result.psi[w] = (count - beyond_[w]) / count;
        }
    }

private:
    const double* weights(std::size_t from, num::PlaceRange columns) {
        const double* const y_weight = nodes_.y_weight.data() + columns.first;
        if (nodes_.is_full()) return y_weight;
        weights_.resize(columns.count());
        for (std::size_t s = 0; s < columns.count(); ++s) {
            weights_[s] = y_weight[s] * std::sqrt(nodes_.cell_factor_sq[from + s]);
        }
        return weights_.data();
    }

    void add_large(const double* e, std::size_t count) {
        for (std::size_t s = 0; s < count; ++s) {
            const double size = std::fabs(e[s]);
            for (int w = 4; w <= psi_count && size > w; ++w) {
                beyond_[static_cast<std::size_t>(w - 1)] += 1;
            }
        }
    }

    const Nodes& nodes_;
    bool has_one_weight_;  ///< in each row
    double delta2_ = 0, largest_ = 0;
    std::array<double, psi_count> beyond_{};
    std::vector<double> weights_;
};

Misfit misfit_with_strips(const Nodes& nodes, const Axis& x, const Axis& y,
                          const std::vector<double>& c, StripRule rule) {
    const num::Tensor tensor(x.plain(), y.plain());
    const std::size_t lines = nodes.x.size(), ny = nodes.y.size();
    std::vector<double> buffer(std::min(rows_of_misfit, lines) * ny);
    Strips strips(nodes, x, y, rule);
    Totals totals(nodes);
    for (std::size_t first = 0; first < lines; first += rows_of_misfit) {
        const num::PlaceRange rows{first, std::min(lines, first + rows_of_misfit)};
        tensor.expand(c, rows, {buffer.data(), rows.count() * ny});
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            double* const e = buffer.data() + (r - rows.first) * ny;
            totals.add(r, {0, ny}, e, e);
            strips.add_row(r, e);
        }
    }
    Misfit result;
    totals.finish(result);
    strips.finish(result);
    return result;
}

}  // namespace

Misfit misfit(const Nodes& nodes, const Axis& x, const Axis& y, const std::vector<double>& c,
              std::optional<StripRule> rule) {
    if (rule) return misfit_with_strips(nodes, x, y, c, *rule);
    Totals totals(nodes);
    std::vector<double> e(nodes.y.size());
    num::Tensor(x.plain(), y.plain())
        .for_each_piece(c, {0, nodes.x.size()},
                        [&](std::size_t r, num::PlaceRange columns, const double* heights) {
                            totals.add(r, columns, heights, e.data());
                        });
    Misfit result;
    totals.finish(result);
    return result;
}

}  // namespace batten::surface_fitting
