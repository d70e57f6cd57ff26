#include "measure/arc/cubic_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "measure/arc/panels.hpp"
#include "num/chebyshev.hpp"
#include "num/gauss.hpp"

namespace batten::arc {
namespace {

constexpr int most_halvings = 40;
constexpr double rounding = 0x1p-50;
/// Of two, for the longest move: lengths in its units are then in range in data units too.
constexpr int most_exponent = 400;

/// Where a panel belongs, and how often it was halved.
struct Owner {
    std::size_t piece = 0;
    int halvings = 0;
};

struct Panel {
    std::array<std::array<double, 3>, most_dim> p{};
    Owner owner;
};

/// For errors of at most `share` of the panel's mean speed.
std::array<Rule, rule_nodes.size()> rules_for(double share) {
    std::array<Rule, rule_nodes.size()> rules;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        double lo = 1.01, hi = 0x1p40;
        while (hi > 1.001 * lo) {
            const double rho = std::sqrt(lo * hi);
            // Half: from [-1, 1] to [0, 1].
            const double bound = chebyshev::gauss_bound(rho, 0.5 * most_growth, rule_nodes[i]);
            (bound <= share ? hi : lo) = rho;
        }
        rules[i] = {rule_nodes[i], 0.5 * (hi + 1 / hi), 0.5 * (hi * hi + 1 / (hi * hi))};
    }
    return rules;
}

class Work {
public:
    Work(const PiecewiseCubic& curve, std::array<Rule, rule_nodes.size()> rules, double scale)
        : curve_(curve), rules_(rules), scale_(scale), values_(curve.pieces()),
          is_left_out_(curve.pieces()) {
        for (std::size_t i = 0; i < rule_nodes.size(); ++i) {
            gauss_[i] = num::gauss_legendre(rule_nodes[i]);
        }
    }

    template <int dim>
    BATTEN_INLINE void run() {
        const std::size_t count = curve_.pieces();
        for (std::size_t i = 0; i < count; i += width) {
            const std::size_t lanes = std::min(width, count - i);
            Panels panels;
            load<dim>(i, lanes, panels);
            std::array<Owner, width> owners;
            for (std::size_t l = 0; l < lanes; ++l) owners[l] = {i + l, 0};
            take<dim>(panels, owners, lanes);
        }
        while (!waiting_.empty()) {
            const std::size_t lanes = std::min(width, waiting_.size());
            Panels panels;
            std::array<Owner, width> owners;
            for (std::size_t l = 0; l < lanes; ++l) {
                const Panel& panel = waiting_.back();
                for (int k = 0; k < dim; ++k) {
                    for (std::size_t j = 0; j < 3; ++j) panels.p[k][j][l] = panel.p[k][j];
                }
                owners[l] = panel.owner;
                waiting_.pop_back();
            }
            take<dim>(panels, owners, lanes);
        }
        for (std::size_t i = 0; i < ready_.size(); ++i) integrate_ready<dim>(i);
    }

    CubicLengths result(double share, double unscale) {
        CubicLengths result;
        result.pieces.resize(values_.size());
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (is_left_out_[i] != 0) result.left_out.push_back(i);
            const double value = is_left_out_[i] != 0 ? 0 : values_[i] * unscale;
            result.pieces[i] = {value, value * share};
        }
        return result;
    }

private:
    template <int dim>
    BATTEN_INLINE void load(std::size_t first, std::size_t lanes, Panels& panels) const {
        const double* const breaks = curve_.breaks().data() + first;
        // The last block is filled up with copies of the last piece.
        const auto take_in = [&](const double* from, Lane& to) {
            double numbers[width];
            for (std::size_t l = 0; l < width; ++l) numbers[l] = from[l < lanes ? l : lanes - 1];
            std::memcpy(&to, lanes == width ? from : numbers, sizeof to);
        };
        Lane lo, h;
        take_in(breaks, lo);
        take_in(breaks + 1, h);
        h -= lo;
        for (int k = 0; k < dim; ++k) {
            Lane c1, c2, c3;
            take_in(curve_.coefficients(1, k).data() + first, c1);
            take_in(curve_.coefficients(2, k).data() + first, c2);
            take_in(curve_.coefficients(3, k).data() + first, c3);
            // h (c1 + 2 c2 u + 3 c3 u^2) with u = h (1 + x) / 2.
            const Lane a = scale_ * c1 * h, b = scale_ * c2 * h * h;
            const Lane c = 0.375 * (scale_ * c3 * h * h * h);
            auto& [p0, p1, p2] = panels.p[static_cast<std::size_t>(k)];
            p0 = a + b + 3 * c;
            p1 = b + 4 * c;
            p2 = c;
        }
    }

    /// Adds the lanes that a rule suits; halves the others.
    template <int dim>
    BATTEN_INLINE void take(const Panels& panels, const std::array<Owner, width>& owners,
                                std::size_t lanes) {
        Lane safe;
        dim == 2 ? judge_plane(panels, rules_, safe) : judge_space(panels, rules_, safe);
        const double count = static_cast<double>(rules_.size());
        double least = count, most = 0;
        for (std::size_t l = 0; l < lanes; ++l) {
            least = std::min(least, safe[l]);
            most = std::max(most, safe[l]);
        }
        // Whole blocks at once where all need much the same rule.
        if (least >= 1 && (most - least <= 1 || owners[0].halvings == 0)) {
            Lane value;
            integrate<dim>(panels, gauss_[rules_.size() - static_cast<std::size_t>(least)], value);
            for (std::size_t l = 0; l < lanes; ++l) values_[owners[l].piece] += value[l];
            return;
        }
        for (std::size_t l = 0; l < lanes; ++l) {
            Panel panel;
            for (int k = 0; k < dim; ++k) {
                for (std::size_t j = 0; j < 3; ++j) panel.p[k][j] = panels.p[k][j][l];
            }
            panel.owner = owners[l];
            if (safe[l] >= 1) {
                const std::size_t rule = rules_.size() - static_cast<std::size_t>(safe[l]);
                ready_[rule].push_back(panel);
                if (ready_[rule].size() == width) integrate_ready<dim>(rule);
            } else if (panel.owner.halvings == most_halvings) {
                is_left_out_[panel.owner.piece] = 1;
            } else if (is_left_out_[panel.owner.piece] == 0) {
                halve<dim>(panel);
            }
        }
    }

    template <int dim>
    BATTEN_INLINE void integrate_ready(std::size_t rule) {
        Panels panels;
        std::vector<Panel>& ready = ready_[rule];
        for (std::size_t l = 0; l < ready.size(); ++l) {
            for (int k = 0; k < dim; ++k) {
                for (std::size_t j = 0; j < 3; ++j) panels.p[k][j][l] = ready[l].p[k][j];
            }
        }
        Lane value;
        integrate<dim>(panels, gauss_[rule], value);
        for (std::size_t l = 0; l < ready.size(); ++l) values_[ready[l].owner.piece] += value[l];
        ready.clear();
    }

    /// Over w in [0, 1/2] and [1/2, 1], each again on [0, 1]: dr/dw halves.
    template <int dim>
    BATTEN_INLINE void halve(const Panel& panel) {
        Panel first = panel, second = panel;
        for (int k = 0; k < dim; ++k) {
            const auto [p0, p1, p2] = panel.p[static_cast<std::size_t>(k)];
            // x = (y -+ 1) / 2: T1 = y / 2 -+ 1/2, T2 = T2(y) / 4 -+ y - 1/4.
            const double middle = p0 - 0.25 * p2;
            first.p[k] = {0.5 * (middle - 0.5 * p1), 0.5 * (0.5 * p1 - p2), 0.125 * p2};
            second.p[k] = {0.5 * (middle + 0.5 * p1), 0.5 * (0.5 * p1 + p2), 0.125 * p2};
        }
        ++first.owner.halvings;
        ++second.owner.halvings;
        waiting_.push_back(first);
        waiting_.push_back(second);
    }

    const PiecewiseCubic& curve_;
    std::array<Rule, rule_nodes.size()> rules_;
    std::array<num::GaussRule, rule_nodes.size()> gauss_;
    double scale_;
    std::vector<double> values_;
    std::vector<char> is_left_out_;
    std::vector<Panel> waiting_;
    std::array<std::vector<Panel>, rule_nodes.size()> ready_;
};

BATTEN_CLONES void run_plane(Work& work) { work.run<2>(); }
BATTEN_CLONES void run_space(Work& work) { work.run<3>(); }

/// The largest |c_j| h^j over all pieces and the extent of the joints.
struct Sizes {
    double move = 0, sum = 0, extent = 0;
};

Sizes sizes_of(const PiecewiseCubic& curve) {
    Sizes sizes;
    const std::size_t count = curve.pieces();
    const double* const breaks = curve.breaks().data();
    for (int k = 0; k < curve.dim(); ++k) {
        const double* const c0 = curve.coefficients(0, k).data();
        const double* const c1 = curve.coefficients(1, k).data();
        const double* const c2 = curve.coefficients(2, k).data();
        const double* const c3 = curve.coefficients(3, k).data();
        Values<width> most{}, sum{}, lo, hi;
        lo.fill(c0[count]);
        hi.fill(c0[count]);
        const auto look_at = [&](std::size_t i, std::size_t l) {
            const double h = breaks[i + 1] - breaks[i];
            const double move =
                h * (std::fabs(c1[i]) + h * (std::fabs(c2[i]) + h * std::fabs(c3[i])));
            most[l] = move > most[l] ? move : most[l];
            sum[l] += move;
            lo[l] = c0[i] < lo[l] ? c0[i] : lo[l];
            hi[l] = c0[i] > hi[l] ? c0[i] : hi[l];
        };
        std::size_t i = 0;
        for (; i + width <= count; i += width) {
            for (std::size_t l = 0; l < width; ++l) look_at(i + l, l);
        }
        for (; i < count; ++i) look_at(i, 0);
        for (std::size_t l = 0; l < width; ++l) {
            sizes.move = std::fmax(sizes.move, most[l]);
            sizes.sum += sum[l];
        }
        sizes.extent = std::fmax(sizes.extent, *std::max_element(hi.begin(), hi.end()) -
                                                   *std::min_element(lo.begin(), lo.end()));
    }
    return sizes;
}

}  // namespace

CubicLengths cubic_lengths(const PiecewiseCubic& curve, Tolerance tolerance) {
    const Sizes sizes = sizes_of(curve);
    int exponent = 0;
    std::frexp(sizes.move, &exponent);
    const bool is_plain = sizes.move > 0 && std::isfinite(sizes.sum) &&
                          std::abs(exponent) <= most_exponent && curve.dim() <= most_dim &&
                          curve.dim() >= 2;
    if (!is_plain) {
        CubicLengths none{std::vector<Measured>(curve.pieces()), {}};
        for (std::size_t i = 0; i < curve.pieces(); ++i) none.left_out.push_back(i);
        return none;
    }
    // No curve is longer than the sum of its moves, and no panel than its share of the errors.
    const double asked = tolerance.in_units(sizes.extent) / sizes.sum;
    const double share = std::clamp(asked, 0.25 * rounding, 0x1p-10);
    Work work(curve, rules_for(share), std::ldexp(1.0, -exponent));
    curve.dim() == 2 ? run_plane(work) : run_space(work);
    return work.result(share + rounding, std::ldexp(1.0, exponent));
}

}  // namespace batten::arc
