#pragma once

#include <optional>
#include <vector>

#include "batten/make/motion.hpp"
#include "batten/make/sample.hpp"

/// The steps from options to samples.
namespace batten::sampling {

/// Throws `option.range` for a number outside the range that `visit_fields` gives it.
void require_ranges(const SampleOptions& options);

/// A law with the duration that it brings along, if any, and when it starts.
struct ChosenLaw {
    MotionLaw law;
    std::optional<double> duration;
    double start = 0;
    std::optional<std::size_t> samples;  ///< where the law itself says how many
    std::size_t corners = 0;             ///< where it stops on its way
};

/// Throws `option.missing` and `sample.options` where options are missing or in each other's way,
/// and what the law throws.
ChosenLaw choose_law(const Curve& curve, const ArcLengthMap& map, const SampleOptions& options);

/// The instants of the samples as shares of the duration, from 0 to 1.
struct Timing {
    std::vector<double> tau;
    double duration = 1;
    double start = 0;

    double time(std::size_t i) const {
        return start + (tau[i] >= 1 ? duration : tau[i] * duration);
    }
};

/// Throws `option.missing` where no count is given, `sample.options` where two are.
Timing timing_of(const ChosenLaw& chosen, double length, const SampleOptions& options);

/// The samples, one after the other.
struct Places {
    std::vector<double> time, s, t, speed;

    std::size_t size() const { return s.size(); }
};

/// Where the law is at the instants.
Places places_of(const ArcLengthMap& map, const MotionLaw& law, const Timing& timing);

/// Rows (time, speed) at some 400 instants, those of the samples not among them.
Points speeds_of(const ArcLengthMap& map, const MotionLaw& law, const Timing& timing);

/// Arc lengths, rising from 0 to the length, whose points are equally far apart in space.
struct EqualChords {
    std::vector<double> s;
    double error = 0;  ///< the largest difference of a chord from their mean
};

/// From equal arcs, by Newton's method. Cost: 3 to 6 steps of 0.3 us a sample.
EqualChords equal_chords(const Curve& curve, const ArcLengthMap& map, std::size_t count);

/// The table of samples. Throws `curve.dimension` for frames anywhere but in space.
Sampling table_of(const Curve& curve, const Places& places, const SampleOptions& options);

/// The largest |(s(t_k+1) - s(t_k)) - (s_k+1 - s_k)|.
double spacing_error(const ArcLengthMap& map, const Places& places);

/// A normal a sample that turns about the curve as little as it can, starting upwards (z), or
/// forwards (x) where the curve does. Unit length, perpendicular to the tangents.
///
/// Accuracy: about 1e-8 radians a radian of turning: between samples the frame is carried over
/// steps that turn by 0.02 at most. Source: double reflection [WangJuttlerZhengLiu2008, table I].
Points rotation_minimising_normals(const Curve& curve, std::span<const double> t);

}  // namespace batten::sampling
