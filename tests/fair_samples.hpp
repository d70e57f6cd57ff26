#pragma once

#include <cmath>
#include <numbers>

#include "batten/make/log_aesthetic.hpp"
#include "batten/measure/nearest.hpp"
#include "batten/shape/curve.hpp"
#include "numpy_random.hpp"

namespace batten::testing {

/// The arc over the chord from (0, 0) to (1, 0) with this turn and ratio of radii.
inline LogAestheticCurve arc_over_chord(double alpha, double turn, double ratio) {
    const double r = std::log(ratio);
    // End curvatures of an arc of any size, then the size that fits the chord.
    LogAestheticSegment arc{alpha, 1, 1, std::exp(-r)};
    const double scale = turn / arc.turn();
    arc.start_curvature *= scale;
    arc.end_curvature *= scale;
    const LogAestheticCurve unit(std::vector<double>{0, 0}, 0, arc);
    const double x = unit.joints()(1, 0), y = unit.joints()(1, 1), chord = std::hypot(x, y);
    return {std::vector<double>{0, 0}, -std::atan2(y, x),
            {alpha, 1 / chord, arc.start_curvature * chord, arc.end_curvature * chord}};
}

/// `count` points at equal steps of the parameter.
inline Points points_on(const Curve& curve, std::size_t count) {
    Points points(0, curve.dim());
    const Interval domain = curve.domain();
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        points.push_back(curve(domain.lo + domain.length() * share));
    }
    return points;
}

/// Normal noise on all coordinates; with `clean_ends` not on the first and last point.
inline Points with_noise(const Points& points, double sigma, unsigned seed, bool clean_ends) {
    Points noisy(points);
    NumpyRandom random(seed);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_clean = clean_ends && (i == 0 || i + 1 == points.size());
        for (int k = 0; k < points.dim(); ++k) {
            const double step = random.normal();
            if (!is_clean) noisy(i, k) += sigma * step;
        }
    }
    return noisy;
}

/// The root of the mean squared distance of points from a curve.
inline double distance_from(const Curve& curve, const Points& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double d = nearest(curve, points[i]).distance;
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace batten::testing
