#include <algorithm>
#include <cmath>

#include "make/fit_surface/solve.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_of_misfit = 16;
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
            const double value = a.at(r)[i];
            for (std::size_t s = 0; s < ny; ++s) to[s] += value * e[s];
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
    explicit Totals(const Nodes& nodes) : nodes_(nodes) {}

    void add_row(std::size_t r, const double* e) {
        const std::size_t ny = nodes_.y.size();
        double sum = 0, largest = 0, beyond[3] = {};
        for (std::size_t s = 0; s < ny; ++s) {
            const double size = std::fabs(e[s]);
            sum += e[s] * e[s];
            largest = std::max(largest, size);
            for (int w = 0; w < 3; ++w) beyond[w] += size > w + 1.0;
        }
        delta2_ += sum;
        for (std::size_t w = 0; w < 3; ++w) beyond_[w] += beyond[w];
        if (largest > 4) add_large(e);
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
    double delta2_ = 0, largest_ = 0;
    std::array<double, psi_count> beyond_{};
};

void weigh_row(const Nodes& nodes, std::size_t r, double* e) {
    const std::size_t ny = nodes.y.size();
    const double weight = nodes.x_weight[r];
    for (std::size_t s = 0; s < ny; ++s) e[s] *= weight * nodes.y_weight[s];
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
    Totals totals(nodes);
    for (std::size_t first = 0; first < lines; first += rows_of_misfit) {
        const num::PlaceRange rows{first, std::min(lines, first + rows_of_misfit)};
        tensor.expand(c, rows, {buffer.data(), rows.count() * ny});
        for (std::size_t r = rows.first; r < rows.last; ++r) {
            double* const e = buffer.data() + (r - rows.first) * ny;
            for (std::size_t s = 0; s < ny; ++s) e[s] = nodes.z[r * ny + s] - e[s];
            weigh_row(nodes, r, e);
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
