#include "make/arcs/along_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "make/arcs/curve_distance.hpp"
#include "num/roots.hpp"

namespace batten::arc_spline {
namespace {

using plane::Vector;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// What a part of the curve becomes.
struct Stretch {
    double end = 0;  ///< the parameter where it ends
    Moves moves;
    std::array<double, 2> errors{};

    double error() const { return std::max(errors[0], errors[1]); }
    void append_to(Row& row) const {
        row.arcs.insert(row.arcs.end(), moves.begin(), moves.end());
        row.errors.insert(row.errors.end(), errors.begin(), errors.begin() + moves.count);
    }
};

enum class Kind { biarc, line };

/// Whether the part is nothing but that point.
bool stays(const Curve& curve, Interval part, Vector point) {
    for (const Place& place : places(curve, part)) {
        const Jet jet = curve.jet_on(place.piece, place.t, 0);
        if (!(Vector{jet[0][0], jet[0][1]} == point)) return false;
    }
    return true;
}

/// The part as one biarc or one line, or as nothing if it stays at a point; none where there is
/// no such biarc or line.
std::optional<Stretch> stretch(const CurveTask& task, Interval part, Kind kind) {
    const Station from = station(task.curve, part.lo, Side::after);
    const Station to = station(task.curve, part.hi, Side::before);
    if (from.point == to.point) {
        return stays(task.curve, part, from.point) ? std::optional(Stretch{part.hi, {}, {}})
                                             : std::nullopt;
    }
    Moves moves{{Arc{{from.point.x, from.point.y}, {to.point.x, to.point.y}, 0}}, 1};
    if (kind == Kind::biarc) {
        const std::optional<Moves> pair = biarc(from, to);
        if (!pair) return std::nullopt;
        moves = *pair;
        for (Arc& arc : moves.arcs) arc = straightened(arc, task.max_radius);
    }
    const auto errors = CurveDistance(task.curve, moves).largest(part, task.tolerance);
    if (!errors) return std::nullopt;
    return Stretch{part.hi, moves, *errors};
}

/// The longest stretch from `rest.lo` within the tolerance; `guess`: a first length to try.
std::optional<Stretch> longest(const CurveTask& task, Interval rest, double guess, Kind kind) {
    constexpr double aim = 0.997, good_enough = 0.994;  // of the tolerance
    constexpr int trials = 48;
    std::optional<Stretch> best;
    double hi = infinite;  // the shortest end known to miss
    double end = std::min(rest.hi, rest.lo + guess);
    for (int trial = 0; trial < trials; ++trial) {
        std::optional<Stretch> tried = stretch(task, {rest.lo, end}, kind);
        const double error = tried ? tried->error() : infinite;
        // The distance of a biarc grows like the cube of its length.
        const double factor = std::cbrt(aim * task.tolerance / error);
        double next = rest.lo + std::clamp(factor, 0.25, 2.0) * (end - rest.lo);
        if (error <= task.tolerance) {
            best = std::move(tried);
            if (end == rest.hi || error >= good_enough * task.tolerance) break;
            next = std::min(next, rest.hi);
        } else {
            hi = end;
        }
        const double lo = best ? best->end : rest.lo;
        if (hi - lo <= 0.004 * (lo - rest.lo)) break;
        if (!(next > lo && next < hi)) next = lo + 0.5 * (std::min(hi, rest.hi) - lo);
        if (!(next > lo)) break;
        end = next;
    }
    return best;
}

/// The stretch from `rest.lo` on; `guess`: a first length to try.
Stretch next_stretch(const CurveTask& task, Interval rest, double guess) {
    std::optional<Stretch> made = longest(task, rest, guess, Kind::biarc);
    // Short beside the step before: a cusp or a hairpin, which a line may pass.
    if (!made || made->end - rest.lo < 1e-4 * guess) {
        std::optional<Stretch> line = longest(task, rest, guess, Kind::line);
        if (line && (!made || line->end > made->end)) made = std::move(line);
    }
    if (made) return *made;
    const double shortest = std::max(rest.lo + 0x1p-40 * task.curve.domain().length(),
                                     std::nextafter(rest.lo, rest.hi));
    const double end = std::min(rest.hi, shortest);
    CurveTask unlimited = task;
    unlimited.tolerance = infinite;
    return stretch(unlimited, {rest.lo, end}, Kind::line).value_or(Stretch{end, {}, {}});
}

}  // namespace

std::vector<double> corners(const Curve& curve) {
    constexpr double smooth_angle = 1e-6;
    std::vector<double> result{curve.domain().lo};
    for (const double t : curve.breaks().subspan(1, curve.pieces() - 1)) {
        const Vector in = station(curve, t, Side::before).tangent;
        const Vector out = station(curve, t, Side::after).tangent;
        if (std::fabs(plane::angle_between(in, out)) > smooth_angle) result.push_back(t);
    }
    result.push_back(curve.domain().hi);
    return result;
}

std::vector<double> curvature_extrema(const Curve& curve) {
    constexpr int steps = 16;
    std::vector<double> result;
    for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
        const Interval part = curve.piece(piece);
        const auto curvature = [&](double t) {
            const Jet jet = curve.jet_on(piece, t, 2);
            const Vector d1{jet[1][0], jet[1][1]}, d2{jet[2][0], jet[2][1]};
            const double speed = plane::norm(d1);
            return speed == 0 ? 0 : plane::cross(d1, d2) / speed / speed / speed;
        };
        const double width = part.length() / steps;
        std::array<double, steps + 1> values;
        for (int i = 0; i <= steps; ++i) {
            values[static_cast<std::size_t>(i)] = curvature(part.lo + i * width);
        }
        for (std::size_t i = 1; i < steps; ++i) {
            const double in = values[i] - values[i - 1], out = values[i + 1] - values[i];
            if (in * out >= 0) continue;
            const double sign = in > 0 ? -1 : 1;
            const double t = part.lo + static_cast<double>(i) * width;
            const auto depth = [&](double u) { return sign * curvature(u); };
            result.push_back(num::find_minimum(depth, {t - width, t + width}, t, 1e-3 * width).at);
        }
    }
    std::sort(result.begin(), result.end());
    return result;
}

Row biarcs_between(const CurveTask& task, const std::vector<double>& joints) {
    CurveTask unlimited = task;
    unlimited.tolerance = infinite;
    Row row;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const Interval part{joints[i], joints[i + 1]};
        // A part that ends where it starts takes two.
        for (const Interval half : {part, Interval{part.lo, part.middle()},
                                    Interval{part.middle(), part.hi}}) {
            std::optional<Stretch> made = stretch(unlimited, half, Kind::biarc);
            if (!made) made = stretch(unlimited, half, Kind::line);
            if (made) made->append_to(row);
            if (made && half == part) break;
        }
    }
    return row;
}

Row longest_biarcs(const CurveTask& task, const std::vector<double>& stops) {
    Row row;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        Interval rest{stops[i], stops[i + 1]};
        double guess = rest.length();
        while (rest.lo < rest.hi) {
            const Stretch made = next_stretch(task, rest, guess);
            made.append_to(row);
            guess = 1.2 * (made.end - rest.lo);
            rest.lo = made.end;
        }
    }
    return row;
}

Row fewest_biarcs(const CurveTask& task) {
    const std::vector<double> least = corners(task.curve);
    const std::vector<double> extrema = curvature_extrema(task.curve);
    const auto breaks = task.curve.breaks();
    const auto with = [](std::vector<double> stops, std::span<const double> more) {
        stops.insert(stops.end(), more.begin(), more.end());
        std::sort(stops.begin(), stops.end());
        stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
        return stops;
    };
    const auto misses = [&](const Row& row) {
        return std::any_of(row.errors.begin(), row.errors.end(),
                           [&](double error) { return error > task.tolerance; });
    };
    Row best = longest_biarcs(task, least);
    for (const std::vector<double>& stops :
         {with(least, extrema), with(least, breaks), with(with(least, extrema), breaks)}) {
        if (stops.size() == least.size()) continue;
        Row row = longest_biarcs(task, stops);
        const bool is_fewer = row.arcs.size() < best.arcs.size();
        if (misses(row) == misses(best) ? is_fewer : misses(best)) best = std::move(row);
    }
    return best;
}

std::vector<double> arc_errors(const Curve& curve, const std::vector<Arc>& arcs,
                               const std::vector<double>& joints) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        const CurveDistance distance(curve, {{arcs[i]}, 1});
        errors.push_back((*distance.largest({joints[i], joints[i + 1]}, infinite))[0]);
    }
    return errors;
}

}  // namespace batten::arc_spline
