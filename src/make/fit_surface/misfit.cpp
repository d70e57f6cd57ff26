#include <algorithm>

#include "make/fit_surface/residual_totals.hpp"
#include "make/fit_surface/solve.hpp"
#include "num/rows.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_of_misfit = 16;

/// Where x-strips are measured: residuals e of weight 1, row after row.
class Strips {
public:
    Strips(const Nodes& nodes, const Axis& x, const Axis& y, StripRule rule)
        : nodes_(nodes), x_(x), y_(y), rule_(rule),
          tensor_(x.weighted(), y.weighted(), num::Tensor::Use::products),
          x_part_(x.basis().breaks().size() - 1, 0.0) {
        const std::size_t width = rule == StripRule::projected ? x.functions() : 1;
        y_sums_.assign(width * nodes.y.size(), 0.0);
        if (rule == StripRule::projected) return;
        ones_.assign(nodes.y.size(), 1.0);
        y_counts_.assign(nodes.y.size(),
                         nodes.is_full() ? static_cast<double>(nodes.x.size()) : 0.0);
    }

    void add(num::PlaceRange rows, std::span<const double> e) {
        if (rule_ == StripRule::projected) return add_projected(rows, e);
        const std::size_t ny = nodes_.y.size();
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            add_marginal(r, e.subspan((r - rows.first) * ny, ny));
        }
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
            result.y_strips[strip_of(y_.basis(), nodes_.y[s])] += share > 0 ? sum / share : 0;
        }
    }

private:
    void add_projected(num::PlaceRange rows, std::span<const double> e) {
        const std::size_t q = y_.functions();
        along_.assign(rows.count() * q, 0.0);
        tensor_.contract_apart(e, rows, y_sums_, along_);
        y_.forward_columns(along_);
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            const double sum =
                num::sum_of_squares(std::span(along_).subspan((r - rows.first) * q, q));
            x_part_[strip_of(x_.basis(), nodes_.x[r])] += sum / static_cast<double>(q);
        }
    }

    void add_marginal(std::size_t r, std::span<const double> e) {
        const std::size_t ny = nodes_.y.size();
        double count = static_cast<double>(ny);
        if (!nodes_.is_full()) {
            count = 0;
            for (std::size_t s = 0; s < ny; ++s) {
                const bool counts = nodes_.cell_factor_sq[r * ny + s] > 0;
                count += counts;
                y_counts_[s] += counts;
            }
        }
        const double sum = num::dot(e, ones_);
        num::add_times(1, e, y_sums_);
        if (count > 0) x_part_[strip_of(x_.basis(), nodes_.x[r])] += sum * sum / count;
    }

    const Nodes& nodes_;
    const Axis& x_;
    const Axis& y_;
    StripRule rule_;
    num::Tensor tensor_;
    std::vector<double> x_part_, y_sums_, y_counts_, ones_, along_;
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
        }
        strips.add(rows, {buffer.data(), rows.count() * ny});
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
    num::Tensor(x.plain(), y.plain())
        .for_each_block(c, [&](const num::Tensor::Block& block) { totals.add(block, x.plain()); });
    Misfit result;
    totals.finish(result);
    return result;
}

}  // namespace batten::surface_fitting
