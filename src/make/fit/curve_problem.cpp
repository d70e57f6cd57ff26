#include "make/fit/curve_problem.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/measure/nearest.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/interpolate/chords.hpp"

namespace batten::fitting {
namespace {

bool has_weight(std::span<const double> factors, std::size_t i) {
    return factors.empty() || !std::isinf(factors[i]);
}

/// The rows that have weight.
std::vector<std::size_t> weighted_rows(std::span<const double> factors, std::size_t count) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < count; ++i) {
        if (has_weight(factors, i)) result.push_back(i);
    }
    return result;
}

}  // namespace

double nearer(std::span<const SplineFunction> curve, std::span<const double> point, double t) {
    double slope = 0, bend = 0, speed_sq = 0;
    for (std::size_t s = 0; s < curve.size(); ++s) {
        const double off = curve[s](t) - point[s], d = curve[s](t, 1);
        slope += off * d;
        speed_sq += d * d;
        bend += d * d + off * curve[s](t, 2);
    }
    if (speed_sq == 0) return t;
    // Where the point lies beyond the centre of curvature, the step of Gauss and Newton.
    return t - slope / (bend > 0.5 * speed_sq ? bend : speed_sq);
}

CurveProblem::CurveProblem(PointsView points, std::span<const double> sigma,
                           const FitOptions& options)
    : ends_(ends_of(options)), places_{std::vector<double>(points.size())}, work_(options.progress) {
    columns_.resize(static_cast<std::size_t>(points.dim()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t s = 0; s < columns_.size(); ++s) columns_[s].push_back(points[i][s]);
    }
    measure_chords({});
    choose_sigma(sigma, options);
    double largest = 0;
    for (const double x : points.coordinates()) largest = std::max(largest, std::fabs(x));
    require_units(samples(), largest, options.degree);
    if (source_ == SigmaSource::estimated) {
        Samples some = samples();
        estimate_sigma(some, noise(), largest);
        common_ = some.common_sigma;
        least_delta2_ = some.least_delta2;
    }
}

Samples CurveProblem::samples() const {
    Samples result;
    result.x = places_.t;
    result.are_feet = places_.are_feet;
    for (const auto& column : columns_) result.sides.emplace_back(column);
    result.sigma = sigma_;
    result.common_sigma = common_;
    result.source = source_;
    result.sigma_known = source_ != SigmaSource::estimated;
    result.range = domain_;
    result.least_delta2 = least_delta2_;
    result.work = work_;
    return result;
}

Points CurveProblem::rows(std::span<const std::size_t> picked) const {
    Points points(picked.size(), static_cast<int>(columns_.size()));
    for (std::size_t r = 0; r < picked.size(); ++r) {
        for (std::size_t s = 0; s < columns_.size(); ++s) points[r][s] = columns_[s][picked[r]];
    }
    return points;
}

void CurveProblem::measure_chords(std::span<const double> factors) {
    const std::vector<std::size_t> kept = weighted_rows(factors, places_.t.size());
    const interpolation::Chords chords =
        interpolation::chords_with_repeats(rows(kept), ends_ == Ends::closed);
    std::vector<double>& t = places_.t;
    double sum = 0;
    for (std::size_t r = 0; r < kept.size(); ++r) {
        t[kept[r]] = sum;
        const std::size_t next = r + 1 < kept.size() ? kept[r + 1] : t.size();
        const double chord = r < chords.lengths.size() ? chords.lengths[r] : 0;
        for (std::size_t i = kept[r] + 1; i < next; ++i) t[i] = sum + 0.5 * chord;
        sum += chord;
    }
    for (std::size_t i = 0; i < kept.front(); ++i) t[i] = 0;
    if (!(sum > 0)) {
        throw Error("points.all-equal", "points", std::to_string(t.size()),
                    "a curve needs two different points");
    }
    domain_ = {0, sum};
    places_.are_feet = false;
}

void CurveProblem::correct(std::span<const SplineFunction> curve,
                           std::span<const double> factors) {
    std::vector<double>& t = places_.t;
    const std::vector<std::size_t> kept = weighted_rows(factors, t.size());
    const std::vector<double> old = t;
    places_.are_feet = true;
    const bool is_open = ends_ == Ends::open;
    for (std::size_t r = 0; r < kept.size(); ++r) {
        const std::size_t i = kept[r];
        const bool is_first = r == 0, is_last = r + 1 == kept.size();
        if (is_open && (is_first || is_last)) continue;
        const double before = is_first ? domain_.lo : 0.5 * (old[kept[r - 1]] + old[i]);
        const double after = is_last ? domain_.hi : 0.5 * (old[i] + old[kept[r + 1]]);
        t[i] = std::clamp(nearer(curve, point(i), old[i]), before, after);
    }
    std::size_t r = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (r < kept.size() && kept[r] == i) {
            ++r;
            continue;
        }
        const double before = r == 0 ? domain_.lo : t[kept[r - 1]];
        const double after = r == kept.size() ? domain_.hi : t[kept[r]];
        const double room = i > 0 ? std::max(before, t[i - 1]) : before;
        t[i] = std::clamp(nearer(curve, point(i), old[i]), room, after);
    }
}

void CurveProblem::settle(const Curve& curve, std::span<const double> factors) {
    if (!places_.are_feet) return;
    const std::vector<std::size_t> kept = weighted_rows(factors, places_.t.size());
    const std::vector<Nearest> feet = nearest(curve, rows(kept));
    for (std::size_t r = 0; r < kept.size(); ++r) places_.t[kept[r]] = feet[r].t;
}

std::vector<double> CurveProblem::point(std::size_t i) const {
    std::vector<double> result;
    for (const auto& column : columns_) result.push_back(column[i]);
    return result;
}

void CurveProblem::choose_sigma(std::span<const double> sigma, const FitOptions& options) {
    if (!sigma.empty()) {
        sigma_.assign(sigma.begin(), sigma.end());
        source_ = SigmaSource::column;
    } else if (options.sigma) {
        common_ = *options.sigma;
        source_ = SigmaSource::number;
    }
}

/// Of one coordinate, from differences of neighbours.
double CurveProblem::noise() const {
    double sum = 0;
    for (const auto& column : columns_) {
        const double one = noise_from_differences(places_.t, column);
        sum += one * one;
    }
    return std::sqrt(sum / static_cast<double>(columns_.size()));
}

}  // namespace batten::fitting
