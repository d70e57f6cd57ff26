#include "make/fair/thin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::fairing {
namespace {

constexpr std::size_t fewest_kept = 5;
constexpr double crowded = 0.1, least_gap = 0.2;  ///< of the median edge

std::vector<double> edges_of(const Track& t) {
    std::vector<double> edges;
    for (std::size_t i = 0; i < t.edges(); ++i) edges.push_back(t.edge(i));
    return edges;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// The points to keep, rising; both ends of a row and those that are held among them.
std::vector<std::size_t> kept_points(const Track& t, std::size_t held) {
    const double gap = least_gap * median(edges_of(t));
    const auto distance = [&](std::size_t i, std::size_t j) {
        return std::hypot(t.x[i] - t.x[j], t.y[i] - t.y[j]);
    };
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < t.size(); ++i) {
        const bool is_held = !t.closed && (i < std::max<std::size_t>(held, 1) ||
                                           i + std::max<std::size_t>(held, 1) >= t.size());
        const bool is_clear = kept.empty() || distance(i, kept.back()) >= gap;
        const bool meets_start = t.closed && i > 0 && distance(i, 0) < gap &&
                                 i + 10 > t.size();
        if (is_held || (is_clear && !meets_start)) kept.push_back(i);
    }
    return kept;
}

struct Tangent {
    double x = 0, y = 0;
};

/// The direction at a point of the circle through it and its neighbours; at an end, of the chord.
Tangent tangent_at(const Track& t, std::size_t i) {
    const bool has_before = t.closed || i > 0, has_after = t.closed || i + 1 < t.size();
    const std::size_t b = has_before ? t.before(i) : i, a = has_after ? t.next(i) : i;
    double ax = t.x[i] - t.x[b], ay = t.y[i] - t.y[b], bx = t.x[a] - t.x[i], by = t.y[a] - t.y[i];
    const double a_sq = ax * ax + ay * ay, b_sq = bx * bx + by * by;
    // Each chord weighted by the other one's square over its own length.
    const double x = ax * b_sq + bx * a_sq, y = ay * b_sq + by * a_sq, size = std::hypot(x, y);
    if (size > 0) return {x / size, y / size};
    const double dx = ax + bx, dy = ay + by, length = std::hypot(dx, dy);
    return {dx / length, dy / length};
}

struct Spot {
    double x = 0, y = 0;
};

/// On the cubic from point j to the next one, at the share t of it.
Spot spot_on(const Track& few, std::size_t j, double t) {
    const std::size_t k = few.next(j);
    const double cx = few.x[k] - few.x[j], cy = few.y[k] - few.y[j];
    const double u = 1 - t, chord = std::sqrt(cx * cx + cy * cy);
    const Tangent p = tangent_at(few, j), q = tangent_at(few, k);
    const double first = t * u * u * chord, second = -t * t * u * chord, step = t * t * (3 - 2 * t);
    return {few.x[j] + step * cx + first * p.x + second * q.x,
            few.y[j] + step * cy + first * p.y + second * q.y};
}

/// What is kept of a wave that two edges of the kept points span.
double kept_share(const Track& few, std::size_t j, const PlaneResult& result, double sigma) {
    const double edge = few.edge(j);
    const double resisted = result.lambda * edge * sigma * sigma *
                            std::pow(std::numbers::pi / edge, 8);
    return 1 / (1 + resisted);
}

/// A place of the whole between two of the few.
struct Between {
    std::size_t i = 0;  ///< of the whole
    std::size_t j = 0;  ///< of the few, before it
    double t = 0;       ///< share of the way to the next one
    double keeps = 0;   ///< of its own distance from the data's cubic
};

/// Puts a point on the cubic of the fair few, and as far from it as `keeps` says.
void place(Track& whole, const Between& at, const Track& fair, const PlaneGoal& few,
           const PlaneGoal& goal) {
    const double dx = goal.data.x[at.i], dy = goal.data.y[at.i];
    const Spot now = spot_on(fair, at.j, at.t), was = spot_on(few.data, at.j, at.t);
    double ox = (now.x - was.x) + (1 - at.keeps) * (was.x - dx);
    double oy = (now.y - was.y) + (1 - at.keeps) * (was.y - dy);
    const double off = std::hypot(ox, oy);
    if (goal.bound > 0 && off > goal.bound) {
        ox *= goal.bound / off;
        oy *= goal.bound / off;
    }
    whole.x[at.i] = dx + ox;
    whole.y[at.i] = dy + oy;
}

}  // namespace

bool is_crowded(const Track& track) {
    const std::vector<double> edges = edges_of(track);
    return *std::min_element(edges.begin(), edges.end()) < crowded * median(edges);
}

PlaneResult faired_thinly(const PlaneGoal& goal, const PlaneWish& wish) {
    const std::vector<std::size_t> kept = kept_points(goal.data, goal.held_ends);
    if (kept.size() < fewest_kept) return fair_kept(goal, wish);
    PlaneGoal few{{{}, {}, goal.data.closed}, goal.sigma, goal.bound, goal.held_ends};
    for (const std::size_t i : kept) {
        few.data.x.push_back(goal.data.x[i]);
        few.data.y.push_back(goal.data.y[i]);
    }
    PlaneResult result = fair_kept(few, wish);
    const Track fair = std::move(result.track);
    result.track = goal.data;
    const std::size_t n = goal.data.size();
    for (std::size_t k = 0; k < kept.size(); ++k) {
        result.track.x[kept[k]] = fair.x[k];
        result.track.y[kept[k]] = fair.y[k];
        const bool is_last = k + 1 == kept.size();
        if (is_last && !goal.data.closed) break;
        const std::size_t end = is_last ? n + kept.front() : kept[k + 1];
        double total = 0, s = 0;
        const double keeps = kept_share(few.data, k, result, goal.sigma);
        for (std::size_t i = kept[k]; i < end; ++i) total += goal.data.edge(i % n);
        for (std::size_t i = kept[k] + 1; i < end; ++i) {
            s += goal.data.edge((i - 1) % n);
            place(result.track, {i % n, k, s / total, keeps}, fair, few, goal);
        }
    }
    return result;
}

}  // namespace batten::fairing
