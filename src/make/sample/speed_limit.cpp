#include "make/sample/speed_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "num/gauss.hpp"
#include "num/roots.hpp"

namespace batten::sampling {
namespace {

/// Steps in a cell between which at most one change of each kind is looked for.
constexpr int steps_a_cell = 32;
constexpr int time_nodes = 24;

}  // namespace

SpeedLimit::SpeedLimit(const Curve& curve, const ArcLengthMap& map, const MotionLimits& limits)
    : curve_(curve), map_(map), limits_(limits) {}

SpeedLimit::Bend SpeedLimit::bend_at(double t, double inside) const {
    const std::size_t piece = curve_.piece_of(inside);
    Jet jet = curve_.jet_on(piece, t, 3);
    const auto dot = [&](int a, int b) {
        double sum = 0;
        for (int k = 0; k < curve_.dim(); ++k) sum += jet[a][k] * jet[b][k];
        return sum;
    };
    if (!(dot(1, 1) > 0)) jet = curve_.jet_on(piece, t + 0x1p-20 * (inside - t), 3);
    const double speed_sq = dot(1, 1);
    if (!(speed_sq > 0)) return {};
    double area_sq = 0, area_slope = 0;  // of r' x r'', and half the derivative of the square
    for (int i = 0; i < curve_.dim(); ++i) {
        for (int j = i + 1; j < curve_.dim(); ++j) {
            const double minor = jet[1][i] * jet[2][j] - jet[1][j] * jet[2][i];
            area_sq += minor * minor;
            area_slope += minor * (jet[1][i] * jet[3][j] - jet[1][j] * jet[3][i]);
        }
    }
    const double area = std::sqrt(area_sq), speed = std::sqrt(speed_sq);
    const double kappa = area / (speed_sq * speed);
    const double bent = area > 0 ? area_slope / area / (speed_sq * speed_sq) : 0;
    return {kappa, bent - 3 * kappa * dot(1, 2) / (speed_sq * speed)};
}

double SpeedLimit::at_parameter(double t, double inside) const {
    const double fastest = limits_.speed * limits_.speed;
    const double kappa = bend_at(t, inside).kappa;
    return kappa * fastest > limits_.lateral ? limits_.lateral / kappa : fastest;
}

void SpeedLimit::add_changes(Interval cell, std::vector<double>& out) const {
    const double steepest = 2 * limits_.tangential, lateral = limits_.lateral;
    const double fastest = limits_.speed * limits_.speed;
    using Signs = std::array<double, 4>;
    const auto signs = [&](double t) -> Signs {
        const Bend bend = bend_at(t, cell.middle());
        const double square = steepest * bend.kappa * bend.kappa;
        return {bend.kappa * fastest - lateral, bend.slope, lateral * bend.slope - square,
                lateral * bend.slope + square};
    };
    Signs before = signs(cell.lo);
    for (int i = 1; i <= steps_a_cell; ++i) {
        const double lo = cell.lo + cell.length() * (i - 1) / steps_a_cell;
        const double hi = cell.lo + cell.length() * i / steps_a_cell;
        const Interval step{lo, i == steps_a_cell ? cell.hi : hi};
        const Signs after = signs(step.hi);
        for (std::size_t kind = 0; kind < before.size(); ++kind) {
            if (!(before[kind] * after[kind] < 0)) continue;
            const auto f = [&](double t) { return signs(t)[kind]; };
            out.push_back(num::find_root(f, step).at);
        }
        before = after;
    }
}

std::vector<SpeedLimit::Place> SpeedLimit::places() const {
    const std::span<const double> joints = map_.joints();
    std::vector<double> t(joints.begin(), joints.end());
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        add_changes({joints[i], joints[i + 1]}, t);
    }
    std::sort(t.begin(), t.end());
    t.erase(std::unique(t.begin(), t.end()), t.end());
    std::vector<Place> result;
    for (std::size_t i = 0; i < t.size(); ++i) {
        double q = limits_.speed * limits_.speed;
        if (i > 0) q = std::fmin(q, at_parameter(t[i], 0.5 * (t[i - 1] + t[i])));
        if (i + 1 < t.size()) q = std::fmin(q, at_parameter(t[i], 0.5 * (t[i] + t[i + 1])));
        const bool is_inner = i > 0 && i + 1 < t.size();
        if (is_inner && is_corner(t[i], 0.5 * (t[i - 1] + t[i]), 0.5 * (t[i] + t[i + 1]))) q = 0;
        const double s = map_.s_of(t[i]);
        if (!result.empty() && s <= result.back().s) {
            result.back().q = std::fmin(result.back().q, q);
            continue;
        }
        result.push_back({t[i], s, q});
    }
    return result;
}

bool SpeedLimit::is_corner(double t, double before, double after) const {
    const auto along = [&](double inside) {
        const std::size_t piece = curve_.piece_of(inside);
        Jet jet = curve_.jet_on(piece, t, 1);
        const auto is_still = [&] {
            return std::all_of(jet[1].begin(), jet[1].end(), [](double x) { return x == 0; });
        };
        if (is_still()) jet = curve_.jet_on(piece, t + 0x1p-20 * (inside - t), 1);
        std::vector<double> unit(jet[1].begin(), jet[1].end());
        double size = 0;
        for (const double x : unit) size = std::hypot(size, x);
        for (double& x : unit) x = size > 0 ? x / size : 0;
        return unit;
    };
    if (curve_.piece_of(before) == curve_.piece_of(after)) return false;
    const std::vector<double> in = along(before), out = along(after);
    double chord = 0;
    for (std::size_t k = 0; k < in.size(); ++k) chord = std::hypot(chord, out[k] - in[k]);
    return chord > sharp;
}

std::size_t SpeedLimit::corners() const {
    std::size_t count = 0;
    for (std::size_t i = 1; i < curve_.pieces(); ++i) {
        const Interval before = curve_.piece(i - 1), after = curve_.piece(i);
        count += is_corner(after.lo, before.middle(), after.middle()) ? 1 : 0;
    }
    return count;
}

double SpeedLimit::time(double from, double to, double inside) const {
    if (!(from < to)) return 0;
    return num::integrate([&](double s) { return 1 / std::sqrt(at(s, inside)); }, {from, to},
                          num::gauss_legendre(time_nodes));
}

}  // namespace batten::sampling
