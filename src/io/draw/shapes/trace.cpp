#include "io/draw/shapes/trace.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "num/roots.hpp"

namespace batten::drawing {
namespace {

constexpr double chord_tolerance = 2e-4;  ///< of the extent: a seventh of a pixel in most pictures
constexpr int most_halvings = 10;
constexpr double short_chord_sq = 16;  ///< in tolerances

struct Refinement {
    const std::function<Sample(double)>& spot;
    double tolerance;
    std::vector<Sample> samples;

    /// Adds what lies after `a`, up to `b`.
    void add(const Sample& a, const Sample& b, int halvings) {
        const double t = a.t + 0.5 * (b.t - a.t);
        if (halvings > 0 && a.t < t && t < b.t) {
            const Sample middle = spot(t);
            if (!is_straight(a, middle, b)) {
                add(a, middle, halvings - 1);
                add(middle, b, halvings - 1);
                return;
            }
        }
        samples.push_back(b);
    }

    bool is_straight(const Sample& a, const Sample& middle, const Sample& b) const {
        if (a.exists != middle.exists || middle.exists != b.exists) return false;
        if (!middle.exists) return true;
        Spot chord{}, leg{};
        double chord_sq = 0, along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            chord[k] = (b.at[k] - a.at[k]) / tolerance;
            leg[k] = (middle.at[k] - a.at[k]) / tolerance;
            chord_sq += chord[k] * chord[k];
            along += chord[k] * leg[k];
        }
        const double share = chord_sq > 0 ? std::clamp(along / chord_sq, 0.0, 1.0) : 0;
        // Where t runs unevenly along the chord, the middle says little about what lies beside it.
        const bool is_even = std::fabs(share - 0.5) <= 0.25 || chord_sq < short_chord_sq;
        Spot foot{};
        for (std::size_t k = 0; k < 3; ++k) foot[k] = share * chord[k];
        return is_even && distance(foot, leg) <= 1;
    }
};

Points bezier_points(const Curve& curve) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    Points result(4 * curve.pieces(), curve.dim());
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        std::array<double, 12> jets{};
        curve.jets_on(i, std::array{piece.lo, piece.hi}, 1, {jets.data(), 4 * dim});
        const double third = piece.length() / 3;
        for (std::size_t k = 0; k < dim; ++k) {
            const double start = jets[k], end = jets[2 * dim + k];
            const std::array<double, 4> column{start, start + third * jets[dim + k],
                                               end - third * jets[3 * dim + k], end};
            for (std::size_t j = 0; j < 4; ++j) {
                if (!std::isfinite(column[j])) {
                    throw Error("number.overflow", "piece " + std::to_string(i), "beyond a double",
                                "control points must be finite");
                }
                result(4 * i + j, static_cast<int>(k)) = column[j];
            }
        }
    }
    return result;
}

Sample point_on(const Curve& curve, std::size_t piece, double t) {
    Sample sample{t};
    curve.jets_on(piece, {&t, 1}, 0, {sample.at.data(), static_cast<std::size_t>(curve.dim())});
    for (const double x : sample.at) {
        if (!std::isfinite(x)) {
            throw Error("drawing.not-finite", "curve at t = " + format_number(t), format_number(x),
                        "a curve must be finite to be drawn");
        }
    }
    return sample;
}

Box coarse_box(const Curve& curve, int chords) {
    Box box;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        for (int j = 0; j <= chords; ++j) {
            const double t = j == chords ? piece.hi : piece.lo + piece.length() * j / chords;
            const Spot at = point_on(curve, i, t).at;
            box.add({at.data(), static_cast<std::size_t>(curve.dim())});
        }
    }
    return box;
}

/// What one unit of each axis is worth: in charts half the extent of the curve along it.
Spot units_of(const Box& box, AxisUnits units) {
    Spot one{1, 1, 1};
    for (std::size_t k = 0; k < 3 && units == AxisUnits::own; ++k) {
        const double half = 0.5 * box.sides[k].hi - 0.5 * box.sides[k].lo;
        if (half > 0) one[k] = half;
    }
    return one;
}

std::vector<Points> runs_of(const Curve& curve, AxisUnits units) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    const int least = least_chords(curve);
    const Box box = coarse_box(curve, least);
    const Spot unit = units_of(box, units);
    const double reach = units == AxisUnits::own ? 1 : box.reach();
    const double tolerance = 2 * chord_tolerance * reach;
    std::vector<Points> runs;
    Spot last{};
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const auto spot = [&](double t) {
            Sample sample = point_on(curve, i, t);
            for (std::size_t k = 0; k < 3; ++k) sample.at[k] /= unit[k];
            return sample;
        };
        const std::vector<Sample> samples = refined(spot, curve.piece(i), least, tolerance);
        const bool joined = i > 0 && distance(last, samples.front().at) <= tolerance;
        if (!joined) runs.emplace_back(0, curve.dim());
        for (std::size_t j = joined ? 1 : 0; j < samples.size(); ++j) {
            Spot at = samples[j].at;
            for (std::size_t k = 0; k < 3; ++k) at[k] *= unit[k];
            runs.back().push_back({at.data(), dim});
        }
        last = samples.back().at;
    }
    return runs;
}

/// Adds where the cubic through rows first .. first + 3 turns in coordinate k.
void add_turns(Box& box, const Points& beziers, std::size_t first) {
    for (int k = 0; k < beziers.dim(); ++k) {
        std::array<double, 4> b{};
        double size = 0;
        for (std::size_t j = 0; j < 4; ++j) b[j] = beziers(first + j, k);
        std::array<double, 3> leg{};
        for (std::size_t j = 0; j < 3; ++j) {
            leg[j] = 0.5 * b[j + 1] - 0.5 * b[j];
            size = std::max(size, std::fabs(leg[j]));
        }
        if (size == 0) continue;
        for (double& x : leg) x /= size;
        const std::array<double, 3> slope{leg[0], 2 * (leg[1] - leg[0]),
                                          leg[0] - 2 * leg[1] + leg[2]};
        for (const double u : num::real_roots(slope)) {
            if (u <= 0 || u >= 1) continue;
            const double v = 1 - u;
            const double x = v * v * v * b[0] + 3 * u * v * v * b[1] + 3 * u * u * v * b[2] +
                             u * u * u * b[3];
            Interval& side = box.sides[static_cast<std::size_t>(k)];
            side = {std::min(side.lo, x), std::max(side.hi, x)};
        }
    }
}

}  // namespace

int least_chords(const Curve& curve) { return curve.pieces() < 100 ? 16 : 4; }

bool is_cubic(const Curve& curve) { return curve.degree().value_or(4) <= 3; }

Spot spot_on(const Curve& curve, double t) { return point_on(curve, curve.piece_of(t), t).at; }

Trace trace_of(const Curve& curve, AxisUnits units) {
    if (is_cubic(curve)) return {bezier_points(curve), {}};
    return {Points(0, curve.dim()), runs_of(curve, units)};
}

Box box_of(const Trace& trace) {
    Box box;
    for (const Points& run : trace.runs) box.add(run);
    for (std::size_t i = 0; i < trace.beziers.size(); i += 4) {
        box.add(trace.beziers[i]);
        box.add(trace.beziers[i + 3]);
        add_turns(box, trace.beziers, i);
    }
    return box;
}

std::vector<Sample> refined(const std::function<Sample(double)>& spot, Interval part, int least,
                            double tolerance) {
    Refinement refinement{spot, tolerance, {spot(part.lo)}};
    for (int i = 1; i <= least; ++i) {
        const double t = i == least ? part.hi : part.lo + part.length() * i / least;
        const Sample before = refinement.samples.back();
        refinement.add(before, spot(t), most_halvings);
    }
    return refinement.samples;
}

}  // namespace batten::drawing
