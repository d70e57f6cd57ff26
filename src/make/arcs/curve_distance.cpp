#include "make/arcs/curve_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "num/roots.hpp"

namespace batten::arc_spline {
namespace {

using plane::Vector;

Vector vector_of(std::span<const double> a) { return {a[0], a[1]}; }

Vector tangent_on(const Curve& curve, std::size_t piece, double t, Side side) {
    const Jet jet = curve.jet_on(piece, t, 3);
    std::array<Vector, 3> steps;  // what each derivative alone does over the piece
    double scale = 1, largest = 0;
    for (int k = 1; k <= 3; ++k) {
        scale *= curve.piece(piece).length() / k;
        Vector& step = steps[static_cast<std::size_t>(k - 1)];
        step = scale * vector_of(jet[k]);
        largest = std::max(largest, plane::norm(step));
    }
    constexpr double vanishing = 1e-7;
    for (std::size_t k = 0; k < 3; ++k) {
        if (plane::norm(steps[k]) <= vanishing * largest) continue;
        const Vector tangent = plane::unit(steps[k]);
        return k == 1 && side == Side::before ? -tangent : tangent;
    }
    return {1, 0};
}

}  // namespace

Station station(const Curve& curve, double t, Side side) {
    std::size_t piece = curve.piece_of(t);
    if (side == Side::before && t == curve.piece(piece).lo && piece > 0) --piece;
    return {vector_of(curve.jet_on(piece, t, 0)[0]), tangent_on(curve, piece, t, side)};
}

std::vector<Place> places(const Curve& curve, Interval part) {
    const std::size_t first = curve.piece_of(part.lo);
    std::size_t last = curve.piece_of(part.hi);
    if (last > first && curve.piece(last).lo == part.hi) --last;
    const std::size_t steps = std::max<std::size_t>(3, 24 / (last - first + 1));
    std::vector<Place> result;
    for (std::size_t piece = first; piece <= last; ++piece) {
        const double lo = std::max(part.lo, curve.piece(piece).lo);
        const double hi = std::min(part.hi, curve.piece(piece).hi);
        for (std::size_t i = 0; i <= steps; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(steps);
            result.push_back({piece, i == steps ? hi : lo + share * (hi - lo)});
        }
    }
    return result;
}

CurveDistance::Sample CurveDistance::sample(Place place) const {
    const Vector p = vector_of(curve_.jet_on(place.piece, place.t, 0)[0]);
    return {place, p, ruler_.foot(p)};
}

bool CurveDistance::is_in_order(const std::vector<Sample>& all, double tolerance) const {
    constexpr double longest_arc = 0.5 * std::numbers::pi * (1 + 1e-9);  // half a circle: its chord
    for (std::size_t i = 1; i < all.size(); ++i) {
        const double ahead = all[i].nearest.foot.along - all[i - 1].nearest.foot.along;
        const double step = plane::norm(all[i].point - all[i - 1].point);
        if (ahead < -4 * tolerance || ahead > longest_arc * step + 4 * tolerance) return false;
    }
    return true;
}

double CurveDistance::refined(const Sample& before, const Sample& here,
                              const Sample& after) const {
    const auto closeness = [&](double t) { return -sample({here.place.piece, t}).distance(); };
    constexpr double placed = 1e-4;  // of the bracket: the distance is then good to about 1e-8
    return -num::find_minimum(closeness, {before.place.t, after.place.t}, here.place.t,
                              placed * (after.place.t - before.place.t))
                .value;
}

std::optional<std::array<double, 2>> CurveDistance::largest(Interval part,
                                                            double tolerance) const {
    std::vector<Sample> all;
    for (const Place& place : places(curve_, part)) all.push_back(sample(place));
    if (!is_in_order(all, tolerance)) return std::nullopt;
    std::array<double, 2> errors{};
    for (const Sample& s : all) {
        errors[s.nearest.arc] = std::max(errors[s.nearest.arc], s.distance());
    }
    const std::array<double, 2> coarse = errors;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        const Sample &before = all[i - 1], &here = all[i], &after = all[i + 1];
        const bool is_peak = here.distance() >= std::max(before.distance(), after.distance());
        const std::size_t piece = here.place.piece;
        const bool is_smooth = before.place.piece == piece && after.place.piece == piece;
        // A parabola through three samples cannot rise far above the highest of them.
        if (!is_peak || !is_smooth || here.distance() < 0.7 * coarse[here.nearest.arc]) continue;
        double& error = errors[here.nearest.arc];
        error = std::max(error, refined(before, here, after));
    }
    return errors;
}

}  // namespace batten::arc_spline
