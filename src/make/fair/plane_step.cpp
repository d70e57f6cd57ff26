#include "make/fair/plane_step.hpp"

#include <algorithm>
#include <utility>

namespace batten::fairing {
namespace {

constexpr int most_halvings = 12;
constexpr double shortest_share = 0.1;  ///< of a step that is relaxed
constexpr double at_the_bound = 1e-9;
constexpr int most_active_rounds = 25;

/// Curvature and its gradient along the three normals.
Bend bend_of(double ax, double ay, double bx, double by, const double (&n)[6]) {
    const double dx = ax + bx, dy = ay + by;
    const double a_sq = ax * ax + ay * ay, b_sq = bx * bx + by * by, d_sq = dx * dx + dy * dy;
    const double scale = 2 / std::sqrt(a_sq * b_sq * d_sq);
    const double turn = ax * by - ay * bx, kappa = turn * scale;
    const double ka = kappa / a_sq, kb = kappa / b_sq, kd = kappa / d_sq;
    // By a and by b: the turn's share, and those of the three lengths.
    const double gax = scale * by - ka * ax - kd * dx, gay = -scale * bx - ka * ay - kd * dy;
    const double gbx = -scale * ay - kb * bx - kd * dx, gby = scale * ax - kb * by - kd * dy;
    return {kappa, -(gax * n[0] + gay * n[1]), (gax - gbx) * n[2] + (gay - gby) * n[3],
            gbx * n[4] + gby * n[5]};
}

}  // namespace

PlaneFairing::PlaneFairing(const PlaneGoal& goal, Track start)
    : goal_(goal), track_(std::move(start)) {
    const std::size_t n = track_.size();
    for (auto* v : {&nx_, &ny_, &edge_, &kappa_, &offset_, &side_, &change_}) v->resize(n);
    bends_.resize(n);
    rows_.resize(n);
    active_.assign(n, 0);
}

bool PlaneFairing::is_held(std::size_t i) const {
    return !track_.closed && (i < goal_.held_ends || i + goal_.held_ends >= track_.size());
}

double PlaneFairing::typical_curvature() const {
    double sum = 0;
    for (const double k : kappa_) sum += k * k;
    return std::sqrt(sum / static_cast<double>(kappa_.size()));
}

void PlaneFairing::linearise(const Stage& stage) {
    const std::size_t n = track_.size();
    const bool ring = track_.closed;
    const auto &x = track_.x, &y = track_.y;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t b = i == 0 ? (ring ? n - 1 : 0) : i - 1;
        const std::size_t a = i + 1 == n ? (ring ? 0 : n - 1) : i + 1;
        const double dx = x[a] - x[b], dy = y[a] - y[b];
        const double scale = 1 / std::sqrt(dx * dx + dy * dy);
        nx_[i] = -dy * scale;
        ny_[i] = dx * scale;
        edge_[i] = a == i ? 0 : std::sqrt((x[a] - x[i]) * (x[a] - x[i]) +
                                          (y[a] - y[i]) * (y[a] - y[i]));
        const double ox = x[i] - goal_.data.x[i], oy = y[i] - goal_.data.y[i];
        offset_[i] = nx_[i] * ox + ny_[i] * oy;
        side_[i] = ny_[i] * ox - nx_[i] * oy;
    }
    const std::size_t first = ring ? 0 : 1, last = ring ? n : n - 1;
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t b = i == 0 ? n - 1 : i - 1, a = i + 1 == n ? 0 : i + 1;
        bends_[i] = bend_of(x[i] - x[b], y[i] - y[b], x[a] - x[i], y[a] - y[i],
                            {nx_[b], ny_[b], nx_[i], ny_[i], nx_[a], ny_[a]});
        kappa_[i] = bends_[i].kappa;
    }
    const double root = std::sqrt(0.5 * stage.lambda), extra = 1 + stage.alpha;
    for (std::size_t i = first + !ring; i < last - !ring; ++i) {
        const std::size_t b = i == 0 ? n - 1 : i - 1, a = i + 1 == n ? 0 : i + 1;
        const double h0 = edge_[b], h1 = edge_[i], h = h0 + h1;
        const double i0 = 1 / (h0 * h), i1 = 1 / (h1 * h);
        const double k = kappa_[i], before = k - kappa_[b], after = kappa_[a] - k;
        const double slope = h1 * i0 * before + h0 * i1 * after;
        double rest = 2 * (i1 * after - i0 * before);
        double cb = 2 * i0, ca = 2 * i1, c = 0;
        if (extra != 0) {
            const double soft = k * k + stage_eps_sq_;
            const double phi = soft > 0 ? k / soft : 0;
            const double bow = soft > 0 ? (stage_eps_sq_ - k * k) / (soft * soft) : 0;
            rest -= extra * slope * slope * phi;
            const double by_slope = 2 * extra * slope * phi;
            cb += by_slope * h1 * i0;
            ca -= by_slope * h0 * i1;
            c = -by_slope * (h1 * i0 - h0 * i1) - extra * slope * slope * bow;
            c -= 2 * i0 + 2 * i1;
        } else {
            c = -cb - ca;
        }
        const double w = root * std::sqrt(h);
        const Bend &p = bends_[b], &q = bends_[i], &r = bends_[a];
        rows_[i] = {{w * cb * p.before, w * (cb * p.here + c * q.before),
                     w * (cb * p.after + c * q.here + ca * r.before),
                     w * (c * q.after + ca * r.here), w * ca * r.after},
                    w * rest};
    }
}

double PlaneFairing::objective() const {
    double near = 0, fair = 0;
    for (const double d : offset_) near += d * d;
    for (const FairRow& row : rows_) fair += row.rest * row.rest;
    return near / (goal_.sigma * goal_.sigma) + fair;
}

double PlaneFairing::rms() const {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < offset_.size(); ++i) {
        if (is_held(i)) continue;
        sum += offset_[i] * offset_[i];
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

/// Unknowns that stay where they are told leave the rows; the others are found.
template <std::size_t Border>
void PlaneFairing::solve(num::BandGivens<Border, 1>& system) {
    const std::size_t n = track_.size();
    const bool ring = Border > 0;
    system.restart(n);
    const double weight = 1 / goal_.sigma;
    const auto is_set = [&](std::size_t i) { return active_[i] != 0 || is_held(i); };
    for (std::size_t i = 0; i < n; ++i) {
        if (is_set(i)) {
            system.set_weight(i, 1, {change_[i]});
        } else {
            system.set_weight(i, weight, {-offset_[i]});
        }
    }
    const auto add = [&](std::size_t i, std::size_t first) {
        typename num::BandGivens<Border, 1>::Row row{};
        double rest = -rows_[i].rest;
        for (std::size_t k = 0; k < 5; ++k) {
            const std::size_t j = (i + n + k - 2) % n;
            if (is_set(j)) {
                rest -= rows_[i].c[k] * change_[j];
            } else if (j < system.columns()) {
                row[j - first] = rows_[i].c[k];
            } else {
                row[5 + (j - system.columns())] = rows_[i].c[k];
            }
        }
        row[5 + Border] = rest;
        system.add(first, row);
    };
    if (ring) {
        for (const std::size_t i : {n - 2, n - 1, std::size_t{0}, std::size_t{1}}) add(i, 0);
    }
    for (std::size_t i = 2; i + 2 < n; ++i) add(i, i - 2);
    std::vector<double>& change = change_;
    system.solve(0, change.data());
}

/// Half of the objective's slope by each displacement, after the change.
std::vector<double> PlaneFairing::pulls() const {
    const std::size_t n = track_.size();
    const double weight = 1 / (goal_.sigma * goal_.sigma);
    std::vector<double> pull(n);
    for (std::size_t i = 0; i < n; ++i) pull[i] = weight * (offset_[i] + change_[i]);
    for (std::size_t i = track_.closed ? 0 : 2; i + (track_.closed ? 0 : 2) < n; ++i) {
        double rest = rows_[i].rest;
        for (std::size_t k = 0; k < 5; ++k) rest += rows_[i].c[k] * change_[(i + n + k - 2) % n];
        for (std::size_t k = 0; k < 5; ++k) pull[(i + n + k - 2) % n] += rows_[i].c[k] * rest;
    }
    return pull;
}

/// How far along its normal a point may be from its datum.
double PlaneFairing::room(std::size_t i) const {
    const double room_sq = goal_.bound * goal_.bound - side_[i] * side_[i];
    return room_sq > 0 ? std::sqrt(room_sq) : 0;
}

/// Primal-dual active set [HintermuellerItoKunisch2003]: whether the set has changed.
bool PlaneFairing::update_active() {
    const std::vector<double> pull = pulls();
    bool any = false;
    for (std::size_t i = 0; i < track_.size(); ++i) {
        if (is_held(i)) continue;
        const double most = room(i), wanted = offset_[i] + change_[i];
        signed char now = 0;
        if (active_[i] == 0) {
            now = wanted > most ? 1 : wanted < -most ? -1 : 0;
        } else if (active_[i] * pull[i] < 0) {
            now = active_[i];
        }
        if (now != 0) change_[i] = now * most - offset_[i];
        any |= now != active_[i];
        active_[i] = now;
    }
    return any;
}

void PlaneFairing::solve_change() {
    for (std::size_t i = 0; i < track_.size(); ++i) {
        if (is_held(i)) change_[i] = 0;
    }
    track_.closed ? solve<4>(ring_) : solve<0>(open_);
}

/// Where the active set goes round in circles: those stay that are at their bound and want out; the
/// step ends where the first of the others meets its own.
void PlaneFairing::find_feasible_change() {
    std::fill(change_.begin(), change_.end(), 0.0);
    const std::vector<double> pull = pulls();
    for (std::size_t i = 0; i < track_.size(); ++i) {
        const double most = room(i);
        const bool at_bound = std::fabs(offset_[i]) >= most * (1 - at_the_bound);
        const signed char side = offset_[i] < 0 ? -1 : 1;
        active_[i] = !is_held(i) && at_bound && side * pull[i] < 0 ? side : 0;
        if (active_[i] != 0) change_[i] = side * most - offset_[i];
    }
    solve_change();
    double share = 1;
    for (std::size_t i = 0; i < track_.size(); ++i) {
        if (active_[i] != 0 || is_held(i) || change_[i] == 0) continue;
        const double way = std::copysign(room(i), change_[i]) - offset_[i];
        share = std::fmin(share, std::fmax(0, way / change_[i]));
    }
    for (double& u : change_) u *= share;
    is_cut_ = share < 1;
}

void PlaneFairing::find_change() {
    is_cut_ = false;
    for (std::size_t i = 0; goal_.bound > 0 && i < track_.size(); ++i) {
        if (active_[i] != 0) change_[i] = active_[i] * room(i) - offset_[i];
    }
    solve_change();
    if (goal_.bound == 0) return;
    int round = 0;
    while (round < most_active_rounds && update_active()) {
        solve_change();
        ++round;
    }
    if (round == most_active_rounds) find_feasible_change();
    for (std::size_t i = 0; i < track_.size(); ++i) {  // nobody gets out, by rounding either
        if (is_held(i)) continue;
        change_[i] = std::clamp(offset_[i] + change_[i], -room(i), room(i)) - offset_[i];
    }
}

void PlaneFairing::move(double share, const Track& from) {
    for (std::size_t i = 0; i < track_.size(); ++i) {
        track_.x[i] = from.x[i] + share * change_[i] * nx_[i];
        track_.y[i] = from.y[i] + share * change_[i] * ny_[i];
    }
}

/// The share of the present step to take, from how the last one, taken by `share`, has changed it:
/// Gauss-Newton steps that go to and fro grow shorter. Source: [KuettlerWall2008].
double PlaneFairing::relaxed(double share) const {
    double dot = 0, size_sq = 0;
    for (std::size_t i = 0; i < change_.size(); ++i) {
        const double turned = change_[i] - last_change_[i];
        dot += last_change_[i] * turned;
        size_sq += turned * turned;
    }
    return size_sq > 0 ? std::clamp(-share * dot / size_sq, shortest_share, 1.0) : 1;
}

bool PlaneFairing::run(const Stage& stage, double least_move, int most_steps) {
    stage_eps_sq_ = 0;
    linearise(stage);
    const double eps = stage.softness * typical_curvature();
    stage_eps_sq_ = eps * eps;
    linearise(stage);
    double value = objective(), share = 1;
    for (int i = 0; i < most_steps; ++i) {
        ++steps_;
        last_change_ = change_;
        const bool was_cut = is_cut_;
        find_change();
        share = i == 0 || was_cut || is_cut_ ? 1 : relaxed(share);
        double most = 0;
        for (const double u : change_) most = std::fmax(most, std::fabs(u));
        const Track from = track_;
        const std::vector<double> nx = nx_, ny = ny_;
        double fresh = value;
        for (int half = 0;; ++half) {
            move(share, from);
            linearise(stage);
            fresh = objective();
            // Normals and edges are held inside a step: near the end the value may creep up.
            if (fresh <= value * (1 + 1e-6) || half == most_halvings) break;
            nx_ = nx, ny_ = ny;
            share *= 0.5;
        }
        if (!(fresh <= value * (1 + 1e-6))) {
            track_ = from;
            linearise(stage);
            last_move_ = most;
            return !is_cut_ && most < 10 * least_move;
        }
        value = fresh;
        last_move_ = share * most;
        if (!is_cut_ && last_move_ < least_move) return true;
    }
    return false;
}

}  // namespace batten::fairing
