#include "make/fit/spare_knots.hpp"

#include <algorithm>
#include <functional>

namespace batten::fitting {
namespace {

constexpr double share_for_many = 0.5;  // of what is allowed
constexpr int few = 10;  // intervals: then one knot is worth trying all places for another

/// The knots to take out at once, from the right.
std::vector<int> spare_knots(const Growth& growth, double allowed, std::size_t most) {
    const std::vector<double> losses = growth.losses();
    const auto loss = [&](int i) { return losses[static_cast<std::size_t>(i - 1)]; };
    std::vector<int> order, taken;
    for (int i = 1; i < growth.intervals(); ++i) {
        if (loss(i) < allowed) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return loss(a) < loss(b); });
    double sum = 0;
    for (const int i : order) {
        if (taken.size() == most) break;
        const bool is_far = std::all_of(taken.begin(), taken.end(), [&](int other) {
            return std::abs(other - i) > growth.system().order();
        });
        if (!is_far) continue;
        sum += loss(i);
        if (!taken.empty() && sum > share_for_many * allowed) break;
        taken.push_back(i);
    }
    std::sort(taken.begin(), taken.end(), std::greater<>());
    return taken;
}

bool take_out(Growth& growth, double target) {
    bool is_changed = false;
    Growth::State before = growth.state();
    for (std::size_t most = growth.knots().size();;) {
        const std::vector<int> spare = spare_knots(growth, target - growth.delta2(), most);
        if (spare.empty()) return is_changed;
        before = growth.state();
        for (const int i : spare) growth.join(i);
        growth.refit();
        if (growth.delta2() <= target) {
            is_changed = true;
            continue;
        }
        // What one is missed by is exact but for rounding; of several it is nearly the sum.
        growth.restore(before);
        if (spare.size() == 1) return is_changed;
        most = spare.size() / 2;
    }
}

/// Whether two knots might go: each alone is missed by no more than both together.
bool may_spare_two(const Growth& growth, double target) {
    const std::vector<double> losses = growth.losses();
    const double allowed = target - growth.delta2();
    return std::count_if(losses.begin(), losses.end(),
                         [&](double loss) { return loss < allowed; }) >= 2;
}

/// Halves one interval and takes out what is spare then; whether that left fewer knots.
bool exchange_one(Growth& growth, double target) {
    const Growth::State before = growth.state();
    for (const int i : growth.worst(few)) {
        growth.split(i);
        growth.refit();
        if (may_spare_two(growth, target)) take_out(growth, target);
        if (growth.intervals() < static_cast<int>(before.pieces.size())) return true;
        growth.restore(before);
    }
    return false;
}

}  // namespace

bool take_out_spare(Growth& growth, double target) {
    bool is_changed = take_out(growth, target);
    while (growth.intervals() > 1 && growth.intervals() <= few && exchange_one(growth, target)) {
        is_changed = true;
    }
    return is_changed;
}

}  // namespace batten::fitting
