#include "make/fit_surface/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "batten/base/error.hpp"
#include "make/fit_surface/compressed.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/finest_strips.hpp"
#include "make/fit_surface/node_space.hpp"

namespace batten::surface_fitting {
namespace {

// Of both directions, for the finest strips; where halving goes on, one more.
constexpr int usual_halvings = 5;
constexpr int least_halvings = 3;
constexpr int stored_halvings = 7;  // of heights whose reading takes longer than a search
constexpr std::size_t held_numbers = std::size_t{1} << 23;  // where nodes are missing: 64 MB
constexpr int local_halvings = 3;   // of the present strips, where not all can be so fine

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

Axis Lattice::axis_over(const std::vector<double>& breaks, Way way) const {
    const bool is_x = way == Way::x;
    return Axis(basis_over(breaks, degree_), is_x ? nodes_->x : nodes_->y,
                is_x ? nodes_->x_weight : nodes_->y_weight, is_x ? used_x_ : used_y_);
}

void Lattice::set(std::vector<double> x_breaks, std::vector<double> y_breaks) {
    if (x_breaks != x_breaks_) x_.reset();
    if (y_breaks != y_breaks_) y_.reset();
    x_breaks_ = std::move(x_breaks);
    y_breaks_ = std::move(y_breaks);
    solution_.reset();
}

bool Lattice::refit() {
    if (cloud_) {
        CloudFit fit = fit_cloud(*cloud_, basis_over(x_breaks_, degree_),
                                 basis_over(y_breaks_, degree_), rule_);
        solution_ = std::move(fit.solution);
        misfit_ = std::move(fit.misfit);
        return true;
    }
    if (nested_ && (nested_->go_to(x_breaks_, y_breaks_) || go_to_finer_strips())) {
        misfit_ = nested_->misfit();
        misfit_.delta2 /= unit_ * unit_;
    } else if (masked_ && go_to_masked()) {
        set_axes();
        solution_ = masked_->solution(*x_, *y_);
        misfit_ = masked_->misfit(*x_, *y_, solution_->coefficients);
        misfit_.delta2 /= unit_ * unit_;
    } else if (nodes_->stored) {
        return false;
    } else {
        nested_.reset();
        set_axes();
        solution_ = solve(*nodes_, *x_, *y_, Corrected::no);
        misfit_ = surface_fitting::misfit(*nodes_, *x_, *y_, solution_->coefficients, rule_);
    }
    require_finite_misfit();
    return true;
}

void Lattice::set_axes() {
    if (!x_) x_ = std::make_unique<Axis>(axis_over(x_breaks_, Way::x));
    if (!y_) y_ = std::make_unique<Axis>(axis_over(y_breaks_, Way::y));
}

void Lattice::expect_splits(Residuals residuals) {
    if (!nodes_) return;
    if (!nodes_->is_full()) {
        if (residuals == Residuals::sums) expect_masked_splits();
        return;
    }
    const bool is_determined_now = is_determined(basis_over(x_breaks_, degree_), used_x_) &&
                                   is_determined(basis_over(y_breaks_, degree_), used_y_);
    if (nodes_->stored && !is_determined_now) {
        throw Error("fit.too-few", "grid", std::to_string(used_x_.size()) + " x " +
                    std::to_string(used_y_.size()) + " lines",
                    "in each direction there must be more than the degree, " +
                    std::to_string(degree_));
    }
    if (!is_determined_now) return;
    if (nodes_->count < worth_compressing) {
        space_ = std::make_unique<NodeSpace>(*nodes_);
    } else if (residuals == Residuals::sums && rule_ == StripRule::projected && degree_ > 0) {
        halvings_ = nodes_->stored ? stored_halvings : usual_halvings;
        while (!(space_ = compressed(halvings_)) && halvings_ > least_halvings) --halvings_;
        if (!space_) space_ = finer_space();
    }
    take_unit();
    if (space_) nested_ = Nested::over(*space_, degree_, rule_);
}

void Lattice::expect_masked_splits() {
    const bool has_space = nodes_->count >= worth_compressing && rule_ == StripRule::projected &&
                           degree_ > 0 && nodes_->is_mask_only();
    if (!has_space) return;
    halvings_ = usual_halvings;
    while (!(masked_ = masked(halvings_)) && halvings_ > least_halvings) --halvings_;
    take_unit();
}

/// Weights have the unit already where it was known before the heights were read.
void Lattice::take_unit() {
    if (nodes_->stored && !nodes_->sigma_known) unit_ = nodes_->stored->unit();
}

std::unique_ptr<MaskedSpace> Lattice::masked(int halvings) const {
    const std::vector<double> x = halved({domain_.x.lo, domain_.x.hi}, halvings);
    const std::vector<double> y = halved({domain_.y.lo, domain_.y.hi}, halvings);
    const std::size_t kept = x.size() * nodes_->y.size() + y.size() * nodes_->x.size();
    const std::size_t numbers = kept * (static_cast<std::size_t>(degree_) + 2);
    const bool is_small = numbers <= nodes_->count || (nodes_->stored && numbers <= held_numbers);
    return is_small ? MaskedSpace::over(*nodes_, degree_, x, y) : nullptr;
}

bool Lattice::go_to_masked() {
    while (!masked_->has_breaks(x_breaks_, y_breaks_)) {
        masked_ = masked(++halvings_);
        if (!masked_) return false;
    }
    return true;
}

bool Lattice::fits(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks) const {
    const std::size_t p = x_breaks.size(), q = y_breaks.size();
    return p * nodes_->y.size() + q * nodes_->x.size() <= nodes_->count;
}

std::unique_ptr<SearchSpace> Lattice::compressed(int halvings) const {
    const std::vector<double> x = halved({domain_.x.lo, domain_.x.hi}, halvings);
    const std::vector<double> y = halved({domain_.y.lo, domain_.y.hi}, halvings);
    return fits(x, y) ? Compressed::over(*nodes_, degree_, x, y) : nullptr;
}

/// Every strip in which the search stands halved, as often as the lines allow.
std::unique_ptr<SearchSpace> Lattice::locally_finer_space() const {
    for (int times = local_halvings; times > 0; --times) {
        const std::vector<double> x =
            halved_where_determined(x_breaks_, times, degree_, used_x_);
        const std::vector<double> y =
            halved_where_determined(y_breaks_, times, degree_, used_y_);
        const bool is_last_way = times == 1 && nodes_->stored;
        if (fits(x, y) || is_last_way) return Compressed::over(*nodes_, degree_, x, y);
    }
    return nullptr;
}

std::unique_ptr<SearchSpace> Lattice::finer_space() {
    if (halvings_ > 0 && space_) {
        if (std::unique_ptr<SearchSpace> even = compressed(++halvings_)) return even;
    }
    halvings_ = 0;
    return locally_finer_space();
}

bool Lattice::go_to_finer_strips() {
    if (space_->is_of_nodes()) return false;
    std::unique_ptr<SearchSpace> finer = finer_space();
    if (!finer) return false;
    nested_ = Nested::over(*finer, degree_, rule_);
    space_ = std::move(finer);
    return nested_ && nested_->go_to(x_breaks_, y_breaks_);
}

std::optional<Lattice::Fit> Lattice::known_fit(const std::vector<double>& x_breaks,
                                               const std::vector<double>& y_breaks) const {
    if (cloud_) return std::nullopt;
    const bool is_present = solution_ && x_breaks == x_breaks_ && y_breaks == y_breaks_;
    if (is_present && (!nodes_->is_full() || is_harmless(*x_, *y_))) {
        return Fit{*x_, *y_, *solution_, misfit_};
    }
    if (masked_ && masked_->has_breaks(x_breaks, y_breaks)) {
        Axis x = axis_over(x_breaks, Way::x), y = axis_over(y_breaks, Way::y);
        Solution solution = masked_->solution(x, y);
        Fit fit{std::move(x), std::move(y), std::move(solution), {}};
        fit.misfit.psi_is_missing = true;
        return fit;
    }
    if (is_present) return std::nullopt;
    const auto has_all = [&](const std::vector<double>& breaks, Way way) {
        return std::all_of(breaks.begin(), breaks.end(),
                           [&](double t) { return space_->has_break(way, t); });
    };
    if (!space_ || !has_all(x_breaks, Way::x) || !has_all(y_breaks, Way::y)) return std::nullopt;
    if (space_->is_of_nodes()) return std::nullopt;
    Axis x = axis_over(x_breaks, Way::x), y = axis_over(y_breaks, Way::y);
    if (!is_harmless(x, y)) return std::nullopt;
    Solution solution = space_->solution(x, y);
    Fit fit{std::move(x), std::move(y), std::move(solution), {}};
    fit.misfit.psi_is_missing = true;
    return fit;
}

void Lattice::require_finite_misfit() const {
    if (std::isfinite(misfit_.delta2)) return;
    require_finite_heights(*nodes_);
    require_finite_solution({}, misfit_.delta2);
}

bool Lattice::can_split(Strip strip) const {
    const std::vector<double>& breaks = strip.is_x ? x_breaks_ : y_breaks_;
    const double left = breaks[strip.index], right = breaks[strip.index + 1];
    const double middle = Interval{left, right}.middle();
    if (!(left < middle && middle < right)) return false;
    if (nested_ && !space_->is_of_nodes() &&
        space_->has_break(strip.is_x ? Way::x : Way::y, middle)) {
        return true;  // the nodes determine all splines with its breaks
    }
    if (masked_ && masked_->has_break(strip.is_x ? Way::x : Way::y, middle)) return true;
    std::vector<double> finer = breaks;
    finer.insert(finer.begin() + static_cast<std::ptrdiff_t>(strip.index) + 1, middle);
    return is_determined(basis_over(finer, degree_), strip.is_x ? used_x_ : used_y_);
}

std::vector<Lattice::Strip> Lattice::strips(std::array<int, 2> most) const {
    std::vector<Strip> strips;
    if (most[0] == 0 || x_strips() < most[0]) {
        for (std::size_t i = 0; i < misfit_.x_strips.size(); ++i) strips.push_back({true, i});
    }
    if (most[1] == 0 || y_strips() < most[1]) {
        for (std::size_t i = 0; i < misfit_.y_strips.size(); ++i) strips.push_back({false, i});
    }
    return strips;
}

std::optional<Lattice::Strip> Lattice::worst(std::array<int, 2> most) const {
    std::vector<Strip> order = strips(most);
    std::stable_sort(order.begin(), order.end(),
                     [&](Strip a, Strip b) { return measure(a) > measure(b); });
    for (const Strip s : order) {
        if (can_split(s)) return s;
    }
    return std::nullopt;
}

bool Lattice::is_tied(Strip worst, std::array<int, 2> most) const {
    constexpr double tie = 1e-9;
    const double largest = measure(worst);
    if (!(misfit_.delta2 > least_delta2())) return false;
    const std::vector<Strip> all = strips(most);
    return std::any_of(all.begin(), all.end(), [&](Strip s) {
        const bool is_same = s.is_x == worst.is_x && s.index == worst.index;
        return !is_same && std::fabs(largest - measure(s)) <= tie * largest && can_split(s);
    });
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
