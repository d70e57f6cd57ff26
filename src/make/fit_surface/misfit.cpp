#include <algorithm>

#include "make/fit_surface/residual_totals.hpp"
#include "make/fit_surface/solve.hpp"
#include "num/clones.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_of_misfit = 16;

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

Misfit misfit_with_strips(const Nodes& nodes, const Axis& x, const Axis& y,
                          const std::vector<double>& c, StripRule rule) {
    const num::Tensor tensor(x.plain(), y.plain());
    const std::size_t lines = nodes.x.size(), ny = nodes.y.size();
    std::vector<double> buffer(std::min(rows_of_misfit, lines) * ny);
    Strips strips(nodes, x, y, rule);
    NodeTotals totals(nodes);
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
    NodeTotals totals(nodes);
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
