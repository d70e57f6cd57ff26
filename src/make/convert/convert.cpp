#include "batten/make/convert.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/arcs.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/transform.hpp"
#include "make/convert/halving.hpp"

namespace batten {
namespace {

using conversion::distance;
using conversion::halved;

constexpr int checks = 16;

/// Distance of `p` from the segment a b.
double segment_distance(std::span<const double> p, std::span<const double> a,
                        std::span<const double> b) {
    double dot = 0, length_sq = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        dot += (p[k] - a[k]) * (b[k] - a[k]);
        length_sq += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double share = length_sq > 0 ? std::clamp(dot / length_sq, 0.0, 1.0) : 0.0;
    double sum_sq = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const double gap = p[k] - (a[k] + share * (b[k] - a[k]));
        sum_sq += gap * gap;
    }
    return std::sqrt(sum_sq);
}

/// One cubic that meets `curve` and its derivative at both ends of `part`.
PiecewiseCubic hermite_piece(const Curve& curve, std::size_t piece, Interval part) {
    const Jet start = curve.jet_on(piece, part.lo, 1), end = curve.jet_on(piece, part.hi, 1);
    Points ends(0, curve.dim()), first(0, curve.dim()), last(0, curve.dim());
    ends.push_back(start[0]);
    ends.push_back(end[0]);
    first.push_back(start[1]);
    last.push_back(end[1]);
    return PiecewiseCubic::hermite(ends, first, last, {part.lo, part.hi}, false);
}

/// The largest distance between two curves over the same domain, parameter by parameter.
double largest_distance(const Curve& a, const Curve& b) {
    std::vector<double> breaks;
    std::set_union(a.breaks().begin(), a.breaks().end(), b.breaks().begin(), b.breaks().end(),
                   std::back_inserter(breaks));
    double largest = 0;
    for (std::size_t j = 0; j + 1 < breaks.size(); ++j) {
        const Interval part{breaks[j], breaks[j + 1]};
        const std::size_t of_a = a.piece_of(part.middle()), of_b = b.piece_of(part.middle());
        for (int i = 0; i <= checks; ++i) {
            const double t = part.lo + part.length() * i / checks;
            largest = std::max(largest, distance(a.jet_on(of_a, t, 0)[0], b.jet_on(of_b, t, 0)[0]));
        }
    }
    return largest;
}

std::vector<double> polyline_breaks(const Curve& curve, double tolerance) {
    return halved(curve, [&](std::size_t piece, Interval part) {
        const Jet a = curve.jet_on(piece, part.lo, 0), b = curve.jet_on(piece, part.hi, 0);
        for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9}) {
            const Jet p = curve.jet_on(piece, part.lo + share * part.length(), 0);
            if (segment_distance(p[0], a[0], b[0]) > tolerance) return false;
        }
        return true;
    });
}

Points points_at(const Curve& curve, std::span<const double> t) {
    Points points(t.size(), curve.dim());
    curve.jets(t, 0, points.coordinates());
    return points;
}

/// The largest distance of `curve` from the polyline through it at `breaks`.
double polyline_error(const Curve& curve, std::span<const double> breaks) {
    double largest = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const Interval part{breaks[i], breaks[i + 1]};
        const std::size_t piece = curve.piece_of(part.middle());
        const Jet a = curve.jet_on(piece, part.lo, 0), b = curve.jet_on(piece, part.hi, 0);
        for (int k = 1; k < checks; ++k) {
            const Jet p = curve.jet_on(piece, part.lo + part.length() * k / checks, 0);
            largest = std::max(largest, segment_distance(p[0], a[0], b[0]));
        }
    }
    return largest;
}

/// The straight pieces between the points of `curve` at `breaks`.
BSplineCurve polyline(const Curve& curve, const std::vector<double>& breaks) {
    if (!curve.is_closed()) {
        return {BSplineBasis::over(breaks, 1), points_at(curve, breaks)};
    }
    // The end of a closed curve is its start: one control point for both.
    const std::span<const double> period(breaks);
    return {BSplineBasis::periodic(period, 1), points_at(curve, period.first(breaks.size() - 1))};
}

/// Trimmed, reversed, scaled: whatever kind of curve it is (a chain of arcs or any other).
template <class AnyCurve>
AnyCurve moved(AnyCurve curve, const ConvertOptions& options) {
    if (options.trim) curve = trimmed(curve, *options.trim);
    if (options.reverse) curve = reversed(curve);
    if (options.scale) curve = scaled(curve, *options.scale);
    return curve;
}

bool changes_knots(const ConvertOptions& options) {
    return !options.insert_knots.empty() || options.elevate > 0 || options.remove_knots;
}

/// Knots and degree as asked for; the report is told.
Curve with_knots(const Curve& curve, const ConvertOptions& options, double tolerance,
                 ConvertReport& report) {
    if (!changes_knots(options)) return curve;
    BSplineCurve spline = to_bspline(curve);
    if (!options.insert_knots.empty()) spline = insert_knots(spline, options.insert_knots);
    if (options.elevate > 0) spline = elevate_degree(spline, options.elevate);
    if (options.remove_knots) {
        const std::size_t before = spline.basis().knots().size();
        spline = remove_knots(spline, tolerance - std::min(tolerance, report.max_error));
        report.removed = before - spline.basis().knots().size();
    }
    report.max_error = std::max(report.max_error, largest_distance(curve, spline));
    return spline;
}

}  // namespace

PiecewiseCubic to_piecewise_cubic(const Curve& curve, double tolerance) {
    if (std::optional<PiecewiseCubic> exact = exact_cubic(curve)) return *exact;
    const std::vector<double> breaks = halved(curve, [&](std::size_t piece, Interval part) {
        const PiecewiseCubic cubic = hermite_piece(curve, piece, part);
        Jet p(curve.dim(), 0);
        for (const double share : {0.5, 0.25, 0.75}) {
            const double t = part.lo + share * part.length();
            cubic.jets_on(0, {&t, 1}, 0, p.values());
            if (distance(p[0], curve.jet_on(piece, t, 0)[0]) > 0.9 * tolerance) return false;
        }
        return true;
    });
    const std::size_t pieces = breaks.size() - 1;
    Points joints = points_at(curve, breaks), start(pieces, curve.dim()), end(pieces, curve.dim());
    for (std::size_t i = 0; i < pieces; ++i) {
        const std::size_t source = curve.piece_of(Interval{breaks[i], breaks[i + 1]}.middle());
        const Jet first = curve.jet_on(source, breaks[i], 1);
        const Jet last = curve.jet_on(source, breaks[i + 1], 1);
        std::copy(first[1].begin(), first[1].end(), start[i].begin());
        std::copy(last[1].begin(), last[1].end(), end[i].begin());
    }
    return PiecewiseCubic::hermite(joints, start, end, breaks, curve.is_closed());
}

Points to_polyline(const Curve& curve, double tolerance) {
    return points_at(curve, polyline_breaks(curve, tolerance));
}

Conversion convert(const Curve& original, const ConvertOptions& options) {
    if (!(options.tolerance.value > 0)) {
        throw Error("option.range", "tolerance", format_number(options.tolerance.value),
                    "must be more than 0");
    }
    const ArcChain* chain = original.shape<ArcChain>();
    Curve curve = chain ? Curve(moved(*chain, options)) : moved(original, options);

    const double tolerance = options.tolerance.in_units(extent(curve));
    ConvertReport report;
    if (options.as == Form::cubic) {
        const Curve cubic = to_piecewise_cubic(curve, tolerance);
        report.max_error = largest_distance(curve, cubic);
        curve = cubic;
    } else if (options.as == Form::quintic) {
        const Curve quintic = to_quintic(curve, tolerance);
        report.max_error = largest_distance(curve, quintic);
        curve = quintic;
    } else if (options.as == Form::arcs && !curve.shape<ArcChain>()) {
        ArcsOptions within;
        within.tolerance = absolute(tolerance);
        const ArcFit fit = arcs(curve, within);
        report.max_error = fit.report.max_error;
        curve = fit.chain;
    } else if (options.as == Form::polyline) {
        const std::vector<double> breaks = polyline_breaks(curve, tolerance);
        report.max_error = polyline_error(curve, breaks);
        curve = polyline(curve, breaks);
    }
    curve = with_knots(curve, options, tolerance, report);
    if (options.as == Form::power) power_form(curve);  // throws where there is none
    report.pieces = curve.pieces();
    // met: max_error <= tolerance
    report.status = report.max_error <= tolerance ? Status::met : Status::not_met;
    return {curve, report};
}

}  // namespace batten
