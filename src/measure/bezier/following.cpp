#include "measure/bezier/following.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "measure/bezier/end_form.hpp"

namespace batten::bezier {
namespace {

/// A part is accepted when it is this close to the curve, relative to the extent ...
constexpr double follow_tolerance = 0x1p-46;
/// ... or to its coordinates, of which that is a few ulps,
constexpr double rounding = 0x1p-50;
/// ... or when halving no longer helps, because the curve itself is not computed better.
constexpr double follow_floor = 0x1p-30;
constexpr int least_halvings = 2, most_halvings = 14;
/// Where the two are compared: the error of Hermite's interpolant is largest in the middle.
constexpr std::array<double, 3> probes{0.5, 0.2113, 0.7549};

/// The distance between curve and interpolant, largest coordinate over the probes, in data units.
double gap(const Curve& curve, std::size_t source, Interval t) {
    constexpr int order = followed_degree / 2;
    const Jet start = curve.jet_on(source, t.lo, order), end = curve.jet_on(source, t.hi, order);
    require_finite_jet(start.values(), source, t.lo);
    require_finite_jet(end.values(), source, t.hi);
    const EndForm form(followed_degree);
    bernstein::Coefficients from(form.rows()), to(form.rows()), c(followed_degree + 1);
    double widest = 0;
    for (const double u : probes) {
        const double at = t.lo + u * t.length();
        const Jet jet = curve.jet_on(source, at, 0);
        require_finite_jet(jet.values(), source, at);
        for (std::size_t k = 0; k < jet[0].size(); ++k) {
            form.take(start.values(), k, t.length(), from);
            form.take(end.values(), k, -t.length(), to);
            form.write_position(from, to, {c.data(), c.size()});
            widest = std::fmax(widest, std::fabs(bernstein::value(c, u) - jet[0][k]));
        }
    }
    return widest;
}

/// How close is close enough for one piece: by nine of its points.
double tolerance_of(const Curve& curve, std::size_t source) {
    const Interval piece = curve.piece(source);
    const Jet first = curve.jet_on(source, piece.lo, 0);
    double spread = 0, largest = 0;
    for (int i = 0; i <= 8; ++i) {
        const Jet jet = curve.jet_on(source, piece.lo + i / 8.0 * piece.length(), 0);
        for (std::size_t k = 0; k < jet[0].size(); ++k) {
            spread = std::fmax(spread, std::fabs(0.5 * jet[0][k] - 0.5 * first[0][k]));
            largest = std::fmax(largest, std::fabs(jet[0][k]));
        }
    }
    return 2 * follow_tolerance * spread + rounding * largest;
}

}  // namespace

std::vector<Part> followed(const Curve& curve, std::size_t source) {
    struct Open {
        Interval t;
        int halvings;
        double gap_before;
    };
    const double tolerance = tolerance_of(curve, source);
    const double floor = follow_floor / follow_tolerance * tolerance;
    std::vector<Part> parts;
    std::vector<Open> open{{curve.piece(source), 0, std::numeric_limits<double>::infinity()}};
    while (!open.empty()) {
        const Open now = open.back();
        open.pop_back();
        const double wide = gap(curve, source, now.t);
        const bool is_stuck = wide <= floor && wide > 0.25 * now.gap_before;
        const bool is_close = now.halvings >= least_halvings && (wide <= tolerance || is_stuck);
        if (is_close || now.halvings == most_halvings) {
            parts.push_back({source, now.t, 2 * wide});
            continue;
        }
        open.push_back({{now.t.middle(), now.t.hi}, now.halvings + 1, wide});
        open.push_back({{now.t.lo, now.t.middle()}, now.halvings + 1, wide});
    }
    return parts;
}

void require_finite_jet(std::span<const double> jet, std::size_t piece, double t) {
    for (const double x : jet) {
        if (!std::isfinite(x)) {
            throw Error("curve.not-finite",
                        "piece " + std::to_string(piece) + " at t = " + format_number(t),
                        format_number(x), "value and derivatives must be finite");
        }
    }
}

}  // namespace batten::bezier
