#include "make/fair/coarse.hpp"

#include <algorithm>
#include <cmath>

namespace batten::fairing {
namespace {

constexpr std::size_t coarse_points = 400;

/// Unit normals, to the left.
Track normals_of(const Track& t) {
    Track normal;
    const std::size_t n = t.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t b = t.closed || i > 0 ? t.before(i) : i;
        const std::size_t a = t.closed || i + 1 < n ? t.next(i) : i;
        const double dx = t.x[a] - t.x[b], dy = t.y[a] - t.y[b], size = std::hypot(dx, dy);
        normal.x.push_back(-dy / size);
        normal.y.push_back(dx / size);
    }
    return normal;
}

std::vector<double> offsets(const Track& to, const Track& from, const Track& normal) {
    std::vector<double> result(to.size());
    for (std::size_t i = 0; i < to.size(); ++i) {
        result[i] = normal.x[i] * (to.x[i] - from.x[i]) + normal.y[i] * (to.y[i] - from.y[i]);
    }
    return result;
}

/// Every `stride`-th point, and of a row the last one.
std::vector<std::size_t> chosen(const Track& t, std::size_t stride) {
    std::vector<std::size_t> at;
    const std::size_t n = t.size(), last = t.closed ? n - 1 : n - 1 - stride / 2;
    for (std::size_t i = 0; i <= last; i += stride) at.push_back(i);
    if (!t.closed) at.push_back(n - 1);
    return at;
}

double mean_around(const std::vector<double>& value, std::size_t i, std::size_t reach,
                   bool closed) {
    const std::size_t n = value.size();
    // At the ends of a row the window stays symmetric: a mean there has no slope in it.
    const std::size_t room = closed ? reach : std::min({reach, i, n - 1 - i});
    double sum = 0;
    for (std::size_t k = 0; k <= 2 * room; ++k) sum += value[(i + n + k - room) % n];
    return sum / static_cast<double>(2 * room + 1);
}

/// The cubic through four of the values around x between `at`[k] and the next one.
double interpolated(const std::vector<double>& value, const std::vector<double>& at, double x,
                    std::size_t k) {
    const std::size_t n = at.size(), first = std::min(k > 0 ? k - 1 : 0, n - 4);
    double sum = 0;
    for (std::size_t i = first; i < first + 4; ++i) {
        double weight = value[i];
        for (std::size_t j = first; j < first + 4; ++j) {
            if (j != i) weight *= (x - at[j]) / (at[i] - at[j]);
        }
        sum += weight;
    }
    return sum;
}

}  // namespace

PlaneResult faired_coarsely(const PlaneGoal& goal, const PlaneWish& wish, const PlaneResult& fine) {
    const Track& track = fine.track;
    const std::size_t n = track.size(), stride = n / coarse_points;
    const Track normal = normals_of(track);
    const std::vector<double> data = offsets(goal.data, track, normal);
    const std::vector<std::size_t> at = chosen(track, stride);
    PlaneGoal few{{{}, {}, track.closed}, goal.sigma / std::sqrt(static_cast<double>(stride)), 0,
                  goal.held_ends};
    Track places;  // of the few, as the fine track has them
    for (const std::size_t i : at) {
        const double mean = mean_around(data, i, stride / 2, track.closed);
        places.x.push_back(track.x[i]);
        places.y.push_back(track.y[i]);
        few.data.x.push_back(track.x[i] + normal.x[i] * mean);
        few.data.y.push_back(track.y[i] + normal.y[i] * mean);
    }
    const PlaneResult coarse = fair_plane(few, wish);
    std::vector<double> change, index;
    const std::size_t margin = track.closed ? 2 : 0, m = at.size();
    for (std::size_t k = 0; k < m + 2 * margin; ++k) {
        const std::size_t j = (k + m - margin) % m, i = at[j];
        const double turns = k < margin ? -1 : k >= m + margin ? 1 : 0;
        index.push_back(static_cast<double>(i) + turns * static_cast<double>(n));
        change.push_back(normal.x[i] * (coarse.track.x[j] - places.x[j]) +
                         normal.y[i] * (coarse.track.y[j] - places.y[j]));
    }
    PlaneResult result = fine;
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double x = static_cast<double>(i);
        while (k + 2 < index.size() && index[k + 1] <= x) ++k;
        double step = interpolated(change, index, x, k);
        if (goal.bound > 0) step = std::clamp(step, data[i] - goal.bound, data[i] + goal.bound);
        result.track.x[i] += normal.x[i] * step;
        result.track.y[i] += normal.y[i] * step;
    }
    const std::vector<double> left = offsets(goal.data, result.track, normal);
    double sum = 0;
    for (const double d : left) sum += d * d;
    result.rms = std::sqrt(sum / static_cast<double>(n));
    result.lambda = coarse.lambda;
    result.steps += coarse.steps;
    result.converged = coarse.converged;
    result.last_move = coarse.last_move;
    return result;
}

}  // namespace batten::fairing
