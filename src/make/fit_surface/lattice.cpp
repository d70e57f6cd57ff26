#include "make/fit_surface/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "make/fit_surface/filled_report.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t worth_compressing = 50000;  // nodes

std::vector<double> equal_strips(Interval range, int strips) {
    return even_places(range, static_cast<std::size_t>(strips) + 1);
}

std::vector<double> distinct(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
}

}  // namespace

Lattice::Lattice(const Nodes& nodes, int degree, StripRule rule)
    : nodes_(&nodes), domain_{{nodes.x.front(), nodes.x.back()}, {nodes.y.front(), nodes.y.back()}},
      degree_(degree), rule_(rule), used_x_(nodes.used_x()), used_y_(nodes.used_y()) {
    set({domain_.x.lo, domain_.x.hi}, {domain_.y.lo, domain_.y.hi});
}

Lattice::Lattice(const Cloud& cloud, int degree, StripRule rule)
    : cloud_(&cloud), domain_(cloud.domain), degree_(degree), rule_(rule),
      used_x_(distinct(cloud.x)), used_y_(distinct(cloud.y)) {
    set({domain_.x.lo, domain_.x.hi}, {domain_.y.lo, domain_.y.hi});
}

void Lattice::set(std::vector<double> x_breaks, std::vector<double> y_breaks) {
    if (cloud_) {
        x_breaks_ = std::move(x_breaks);
        y_breaks_ = std::move(y_breaks);
        return;
    }
    if (x_breaks != x_breaks_) {
        x_breaks_ = std::move(x_breaks);
        x_ = std::make_unique<Axis>(basis_over(x_breaks_, degree_), nodes_->x, nodes_->x_weight,
                                    used_x_);
    }
    if (y_breaks != y_breaks_) {
        y_breaks_ = std::move(y_breaks);
        y_ = std::make_unique<Axis>(basis_over(y_breaks_, degree_), nodes_->y, nodes_->y_weight,
                                    used_y_);
    }
}

void Lattice::refit() {
    if (cloud_) {
        CloudFit fit = fit_cloud(*cloud_, basis_over(x_breaks_, degree_),
                                 basis_over(y_breaks_, degree_), rule_);
        solution_ = std::move(fit.solution);
        misfit_ = std::move(fit.misfit);
        return;
    }
    if (compressed_ && compressed_->holds(x_breaks_, y_breaks_)) {
        compressed_->fit(*x_, *y_, solution_, misfit_);
    } else {
        solution_ = solve(*nodes_, *x_, *y_, Corrected::no);
        misfit_ = surface_fitting::misfit(*nodes_, *x_, *y_, solution_.coefficients, rule_);
    }
    require_finite_misfit();
}

void Lattice::compress() {
    if (!nodes_ || !nodes_->is_full() || nodes_->z.size() < worth_compressing ||
        rule_ != StripRule::projected || degree_ == 0) {
        return;
    }
    for (int strips = 64; strips >= 8 && !compressed_; strips /= 2) {
        compressed_ = Compressed::of(*nodes_, degree_, strips);
    }
}

void Lattice::require_finite_misfit() const {
    if (std::isfinite(misfit_.delta2)) return;
    require_finite_heights(*nodes_);
    require_finite_solution({}, misfit_.delta2);
}

bool Lattice::is_final() const {
    return nodes_ && is_harmless(*x_, *y_);
}

bool Lattice::can_split(const std::vector<double>& breaks, std::size_t strip,
                        const std::vector<double>& used) const {
    const double middle = Interval{breaks[strip], breaks[strip + 1]}.middle();
    if (!(breaks[strip] < middle && middle < breaks[strip + 1])) return false;
    std::vector<double> finer = breaks;
    finer.insert(finer.begin() + static_cast<std::ptrdiff_t>(strip) + 1, middle);
    return is_determined(basis_over(finer, degree_), used);
}

std::optional<Lattice::Strip> Lattice::worst(std::array<int, 2> most) const {
    const auto measure = [&](Strip s) {
        return s.is_x ? misfit_.x_strips[s.index] : misfit_.y_strips[s.index];
    };
    std::vector<Strip> strips;
    if (most[0] == 0 || x_strips() < most[0]) {
        for (std::size_t i = 0; i < misfit_.x_strips.size(); ++i) strips.push_back({true, i});
    }
    if (most[1] == 0 || y_strips() < most[1]) {
        for (std::size_t i = 0; i < misfit_.y_strips.size(); ++i) strips.push_back({false, i});
    }
    std::stable_sort(strips.begin(), strips.end(),
                     [&](Strip a, Strip b) { return measure(a) > measure(b); });
    for (const Strip s : strips) {
        const bool is_free = s.is_x ? can_split(x_breaks_, s.index, used_x_)
                                    : can_split(y_breaks_, s.index, used_y_);
        if (is_free) return s;
    }
    return std::nullopt;
}

void Lattice::split(Strip strip) {
    std::vector<double> x = x_breaks_, y = y_breaks_;
    std::vector<double>& breaks = strip.is_x ? x : y;
    const double middle = Interval{breaks[strip.index], breaks[strip.index + 1]}.middle();
    breaks.insert(breaks.begin() + static_cast<std::ptrdiff_t>(strip.index) + 1, middle);
    set(std::move(x), std::move(y));
}

bool Lattice::set_equal(int x_strips, int y_strips) {
    std::vector<double> x = equal_strips(domain_.x, x_strips);
    std::vector<double> y = equal_strips(domain_.y, y_strips);
    if (!is_determined(basis_over(x, degree_), used_x_) ||
        !is_determined(basis_over(y, degree_), used_y_)) {
        return false;
    }
    set(std::move(x), std::move(y));
    return true;
}

bool Lattice::is_x_worse() const {
    const auto sum = [](const std::vector<double>& strips) {
        return std::accumulate(strips.begin(), strips.end(), 0.0);
    };
    return sum(misfit_.x_strips) >= sum(misfit_.y_strips);
}

}  // namespace batten::surface_fitting
