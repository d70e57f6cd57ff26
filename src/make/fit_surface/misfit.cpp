#include <algorithm>
#include <cmath>

#include "make/fit_surface/solve.hpp"
#include "num/tensor.hpp"

#if defined(__x86_64__) && defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define BATTEN_MISFIT_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define BATTEN_MISFIT_CLONES
#endif

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_of_misfit = 16;
constexpr std::size_t sum_lanes = 8;

/// Sums of one row, lane by lane: the same bits for every vector width.
struct RowSums {
    double delta2[sum_lanes] = {}, largest[sum_lanes] = {};
    double beyond[3][sum_lanes] = {};
};

BATTEN_MISFIT_CLONES void sum_whole_lanes(const double* e, std::size_t count, RowSums& sums) {
    double delta2[sum_lanes] = {}, largest[sum_lanes] = {};
    double one[sum_lanes] = {}, two[sum_lanes] = {}, three[sum_lanes] = {};
    for (std::size_t s = 0; s + sum_lanes <= count; s += sum_lanes) {
        for (std::size_t l = 0; l < sum_lanes; ++l) {
            const double sq = e[s + l] * e[s + l];
            delta2[l] += sq;
            largest[l] = sq > largest[l] ? sq : largest[l];
            one[l] += sq > 1 ? 1.0 : 0.0;
            two[l] += sq > 4 ? 1.0 : 0.0;
            three[l] += sq > 9 ? 1.0 : 0.0;
        }
    }
    for (std::size_t l = 0; l < sum_lanes; ++l) {
        sums.delta2[l] = delta2[l];
        sums.largest[l] = largest[l];
        sums.beyond[0][l] = one[l];
        sums.beyond[1][l] = two[l];
        sums.beyond[2][l] = three[l];
    }
}

RowSums sums_of(const double* e, std::size_t count) {
    RowSums sums;
    sum_whole_lanes(e, count, sums);
    for (std::size_t s = count / sum_lanes * sum_lanes; s < count; ++s) {
        const double sq = e[s] * e[s];
        sums.delta2[0] += sq;
        sums.largest[0] = std::max(sums.largest[0], sq);
        for (std::size_t w = 0; w < 3; ++w) {
            const double limit = static_cast<double>(w + 1);
            sums.beyond[w][0] += sq > limit * limit ? 1.0 : 0.0;
        }
    }
    return sums;
}

/// e = weight (z - e).
BATTEN_MISFIT_CLONES void take_residuals(const double* z, double weight, std::size_t count,
                                         double* __restrict e) {
    for (std::size_t s = 0; s < count; ++s) e[s] = weight * (z[s] - e[s]);
}

BATTEN_MISFIT_CLONES void add_scaled(const double* e, double value, std::size_t count,
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
    Totals(const Nodes& nodes, bool has_one_weight)
        : nodes_(nodes), has_one_weight_(has_one_weight) {}

    void add_row(std::size_t r, const double* e) {
        const std::size_t ny = nodes_.y.size();
        const RowSums sums = sums_of(e, ny);
        double largest = 0;
        for (std::size_t l = 0; l < sum_lanes; ++l) {
            delta2_ += sums.delta2[l];
            largest = std::max(largest, sums.largest[l]);
            for (std::size_t w = 0; w < 3; ++w) beyond_[w] += sums.beyond[w][l];
        }
        if (largest > 16) add_large(e);
        if (has_one_weight_) {
            largest_ = std::max(largest_, std::sqrt(largest) /
                                              (nodes_.x_weight[r] * nodes_.y_weight[0]));
            return;
        }
        for (std::size_t s = 0; s < ny; ++s) {
            const double factor =
                nodes_.is_full() ? 1 : std::sqrt(nodes_.cell_factor_sq[r * ny + s]);
            const double weight = factor * nodes_.x_weight[r] * nodes_.y_weight[s];
            if (weight > 0) largest_ = std::max(largest_, std::fabs(e[s]) / weight);
        }
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
    void add_large(const double* e) {
        for (std::size_t s = 0; s < nodes_.y.size(); ++s) {
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
};

/// Residuals of row r from the surface's heights, times their weights.
void weigh_row(const Nodes& nodes, std::size_t r, bool has_one_weight, double* e) {
    const std::size_t ny = nodes.y.size();
    const double weight = nodes.x_weight[r] * (has_one_weight ? nodes.y_weight[0] : 1);
    take_residuals(nodes.z.data() + r * ny, weight, ny, e);
    if (has_one_weight) return;
    for (std::size_t s = 0; s < ny; ++s) e[s] *= nodes.y_weight[s];
    if (nodes.is_full()) return;
    for (std::size_t s = 0; s < ny; ++s) e[s] *= std::sqrt(nodes.cell_factor_sq[r * ny + s]);
}

}  // namespace

Misfit misfit(const Nodes& nodes, const Axis& x, const Axis& y, const std::vector<double>& c,
              std::optional<StripRule> rule) {
    const num::Tensor tensor(x.plain(), y.plain());
    const std::size_t lines = nodes.x.size(), ny = nodes.y.size();
    std::vector<double> buffer(std::min(rows_of_misfit, lines) * ny);
    std::optional<Strips> strips;
    if (rule) strips.emplace(nodes, x, y, *rule);
    const bool has_one_weight =
        nodes.is_full() && std::all_of(nodes.y_weight.begin(), nodes.y_weight.end(),
                                       [&](double w) { return w == nodes.y_weight[0]; });
    Totals totals(nodes, has_one_weight);
    for (std::size_t first = 0; first < lines; first += rows_of_misfit) {
        const num::PlaceRange rows{first, std::min(lines, first + rows_of_misfit)};
        tensor.expand(c, rows, {buffer.data(), rows.count() * ny});
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            double* const e = buffer.data() + (r - rows.first) * ny;
            weigh_row(nodes, r, has_one_weight, e);
            totals.add_row(r, e);
            if (strips) strips->add_row(r, e);
        }
    }
    Misfit result;
    totals.finish(result);
    if (strips) strips->finish(result);
    return result;
}

}  // namespace batten::surface_fitting
