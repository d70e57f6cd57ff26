#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/make/sample_options.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// How good the samples are, in data units.
struct SampleReport {
    double length = 0;
    double max_spacing_error = 0;
    double duration = 1;
    std::size_t samples = 0;
    std::optional<double> max_position_error;
    std::optional<double> walked_length, overrun, correction;
    std::optional<int> steps_without_root, steep_steps;
    std::vector<std::string> notes;
    /// not_converged: chords could not be made equal to 1e-9 of the length; not_met: a step of the
    /// paper's method found no root within its segment where the curve was still to be walked on.
    Status status = Status::met;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, SampleReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("length", r.length, "arc length of the curve");
    visit("max_spacing_error", r.max_spacing_error,
          "largest difference of a step, measured along the curve, from what it should be (law "
          "chord: of the chords)");
    visit("duration", r.duration, "the time the whole walk takes");
    visit("samples", r.samples, "how many points there are");
    if (r.max_position_error) {
        visit("max_position_error", r.max_position_error,
              "largest distance along the curve from the exact place");
        visit("walked_length", r.walked_length, "the length that was divided among the steps");
        visit("overrun", r.overrun,
              "how far the last step ended beyond the curve, before correction");
        visit("correction", r.correction, "the factor on the parameters that takes it back");
        visit("steps_without_root", r.steps_without_root, "steps that ended at a joint instead");
        visit("steep_steps", r.steep_steps,
              "steps with curvature times length above sqrt 2 - 1, where a root may not exist");
    }
    visit("notes", r.notes, "what else there is to say");
}

/// Samples as rows `i,time,s,t,x,y[,z],tx,ty[,tz],kappa,speed` (with frames also
/// `nx,ny,nz,bx,by,bz`), and how good they are.
struct Sampling {
    std::vector<std::string> names;
    Points rows;
    SampleReport report;
    /// The speed between samples: rows (time, speed), close enough for a picture. Empty where only
    /// the samples are known.
    Points speeds = Points(2);
};

/// Points on a curve by a law of motion; see docs/sampling.md.
///
/// Aim:    |s(t_k) - s_k| <= 1e-12 length. The count is exact; the first and the last sample are
///         the curve's ends, bit for bit, unless positions or keys say otherwise.
/// Laws:   points (and arc lengths given) times 2^k give exactly 2^k times the places for the laws
///         that know only tau.
/// Curvature where it does not exist is that just beside the place.
/// Cost:   some 3 us a piece and 0.3 us a sample; laws along the curve 20 us a piece.
/// Throws: `option.missing` without a count or what the law needs; `sample.options` for options
///         that contradict one another; `motion.speeds`, `motion.weights`, `motion.positions`,
///         `motion.keys`, `motion.no-weight`; `option.range`; `curve.dimension` for frames in the
///         plane; `curve.no-length`; `curve.not-finite`; `number.overflow`.
Sampling sample(const Curve& curve, const SampleOptions& options);

/// The mean speed on each piece of the curve, its length by the time that the law spends on it.
///
/// The duration is `duration`, or the law's own, or 1; options that say how many points are not
/// looked at. Accuracy: 1e-12 of the whole time. Cost: 50 looks at the law a piece.
/// Throws: what `sample` throws; `motion.no-time` where the law jumps over a piece.
std::vector<double> piece_speeds(const Curve& curve, const SampleOptions& options);

/// Points on the natural spline through `points` (two coordinates), placed as in [HaradaNakamae,
/// section 3] with its formulas put right: the spline by chord lengths with a point more beyond the
/// end, a step along the tangent in the coordinate that moves faster, from joint to joint, and a
/// linear correction of the parameters at last. First order: errors of about a sixth of a step.
/// Speeds are those of the two steps around a sample.
/// Throws: as above; `points.dimension`; what `interpolate` throws.
Sampling sample_harada_nakamae(PointsView points, const SampleOptions& options);

/// The curve that it walks: the spline through the points and 2 P_n - P_(n-1), without its last
/// piece.
Curve harada_nakamae_curve(PointsView points);

}  // namespace batten
