#include "make/interpolate/pseudo_spline.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "batten/base/text.hpp"
#include "batten/make/pseudo_segment.hpp"
#include "make/interpolate/pseudo_pass.hpp"
#include "make/interpolate/space_pseudo.hpp"
#include "make/pseudo/global/angles.hpp"
#include "make/pseudo/local_angles.hpp"
#include "make/pseudo/tables/segments.hpp"
#include "num/plane_angles.hpp"

namespace batten::interpolation {
namespace {

pseudo::Source source_of(const InterpolateOptions& options) {
    return options.exact ? pseudo::Source::minimiser : pseudo::Source::tables;
}

pseudo::AngleRules rules_of(const Outline& outline, const InterpolateOptions& options) {
    return {outline.closed, options.weight_exponent, options.tangent, outline.corners,
            options.progress, source_of(options)};
}

/// The points at a scale where no square leaves the range of a double: angles stay the same bits.
Points of_middling_size(const Outline& outline) {
    Points points(outline.points);
    const int exponent = std::ilogb(outline.chords.longest);
    for (double& x : points.coordinates()) x = std::scalbn(x, -exponent);
    return points;
}

/// `factor` x the chord turned left by `angle`; the chord itself where these are 1 and 0.
void set_turned(const Vector& chord, double factor, double angle, std::span<double> out) {
    const num::Direction turned = num::direction_of(angle);
    const double along = factor * turned.cosine, aside = factor * turned.sine;
    out[0] = along * chord[0] - aside * chord[1];
    out[1] = along * chord[1] + aside * chord[0];
}

/// Each segment on its chord.
PiecewiseCubic planar_curve(const Outline& outline, const std::vector<PseudoSegment>& segments) {
    SpanDerivatives derivatives{Points(segments.size(), 2), Points(segments.size(), 2)};
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Vector chord = chord_of(outline, i);
        set_turned(chord, segments[i].r0, segments[i].theta0, derivatives.start[i]);
        set_turned(chord, segments[i].r1, segments[i].theta1, derivatives.end[i]);
    }
    return hermite_curve(outline, derivatives);
}

PiecewiseCubic space_curve(const Outline& outline, const InterpolateOptions& options) {
    const SpaceRule rule{options.weight_exponent, source_of(options), options.progress};
    const Tangents tangents = space_tangents(outline, rule);
    return hermite_curve(outline,
                         derivatives_of(outline, tangents,
                                        space_magnitudes(outline, tangents, rule)));
}

}  // namespace

Built pseudo_spline(const Outline& outline, const InterpolateOptions& options) {
    if (outline.points.dim() == 3)
        return {space_curve(outline, options), Status::met, {}};
    const bool is_plain = options.tangent.empty() && outline.corners.empty() && !options.exact;
    if (is_plain && has_safe_chords(outline)) {
        const PseudoSplineOptions plain{outline.closed, options.weight_exponent, options.progress};
        return {pseudo_pass(outline, plain).curve, Status::met, {}};
    }
    pseudo::AngleRules rules = rules_of(outline, options);
    rules.progress = options.progress.stage(0, 0.75);
    const Progress rest = options.progress.stage(0.75, 1);
    const std::vector<pseudo::SpanAngles> spans =
        pseudo::local_angles(of_middling_size(outline), rules);
    std::vector<PseudoSegment> segments;
    for (const pseudo::SpanAngles& span : spans) {
        segments.push_back(pseudo::least_segment(span.theta0, span.theta1, rules.source));
        rest.at(segments.size(), spans.size());
    }
    return {planar_curve(outline, segments), Status::met, {}};
}

Built pseudo_spline_global(const Outline& outline, const InterpolateOptions& options) {
    const pseudo::GlobalSpline best =
        pseudo::global_angles(of_middling_size(outline), rules_of(outline, options));
    std::vector<PseudoSegment> segments;
    for (const pseudo::Minimum& minimum : best.minima) segments.push_back(minimum.segment);
    Built result{planar_curve(outline, segments), Status::met, {}};
    if (best.status != pseudo::GlobalStatus::converged) {
        result.status = Status::not_converged;
        result.notes.push_back("after " + std::to_string(best.steps) +
                               " steps the energy still falls with the tangent angles by up to " +
                               format_number(best.gradient / best.energy) +
                               " of itself per radian");
    }
    return result;
}

}  // namespace batten::interpolation
