#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/shape/log_aesthetic.hpp"

namespace batten {

/// The largest angle between the start tangent and the chord of a log-aesthetic arc that turns by
/// `turn`, 0 < turn < pi: chords at angles phi with turn - largest < phi < largest are drawable.
///
/// For 0 <= alpha <= 1 it is `turn` itself. Accuracy: 1e-15. Cost: 0.3 us.
/// Source: the arc of infinite radii's ratio, int exp(i turn x^p) dx with p = (alpha - 1) / alpha,
/// by its power series [YoshidaSaito2006].
double largest_chord_angle(double alpha, double turn);

/// The one arc of the given alpha over a chord with a start tangent and a turn; nothing where
/// there is none. Angles are signed alike: `chord_angle` from start tangent to chord, `turn` from
/// start to end tangent, 0 < |turn| < pi; the chord is above 0.
///
/// Accuracy: 1e-14 relative. Cost: 10 us. Laws: chord x 2^k gives length x 2^k, exactly.
/// Throws: nothing for finite input.
/// Source: r = ln(rho1 / rho0) from the chord's angle, which rises with r, bracketed from 0.
std::optional<LogAestheticSegment> log_aesthetic_segment(double alpha, double chord,
                                                         double chord_angle, double turn);

/// What is asked of one segment; `visit_fields` says what each member means.
struct LogAestheticOptions {
    std::vector<double> points;
    double alpha = -1;
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, LogAestheticOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("points", o.points, anything,
          "X0,Y0,X1,Y1,X2,Y2: start, the corner of the two end tangents, end");
    visit("alpha", o.alpha, between(-1e3, 1e3),
          "-1 clothoid, 0 Nielsen's spiral, 1 logarithmic spiral, 2 circle involute");
}

/// What came of it.
struct LogAestheticReport {
    bool drawable = false;
    std::optional<double> log_radius_ratio;
    std::optional<double> lambda;
    std::optional<double> length;
    std::optional<std::array<double, 2>> curvatures;
    std::vector<std::string> notes;
    /// not_met: no arc of this alpha has these end tangents.
    Status status = Status::met;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, LogAestheticReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("drawable", r.drawable, "whether an arc of this alpha has these end tangents");
    visit("log_radius_ratio", r.log_radius_ratio, "ln(rho1 / rho0)");
    visit("lambda", r.lambda,
          "the slope of rho^(alpha - 1) over the turned angle, signed, for rho = 1 at the start");
    visit("length", r.length, "arc length");
    visit("curvatures", r.curvatures, "at both ends, left turns positive, in 1 / data units");
    visit("notes", r.notes, "what else there is to say");
}

struct LogAestheticMade {
    std::optional<LogAestheticCurve> curve;
    LogAestheticReport report;
};

/// The log-aesthetic segment with three control points: G1 Hermite data by a triangle.
///
/// Three points in a row make a straight line. Whether there is an arc is decided before any is
/// sought. Throws `log-aesthetic.points` unless there are six numbers, `option.range` for alpha,
/// `points.not-finite`, `points.repeated`.
/// Source: [YoshidaSaito2006], solved in log-radius form.
LogAestheticMade log_aesthetic(const LogAestheticOptions& options);

}  // namespace batten
