#pragma once

#include <optional>
#include <span>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"
#include "make/fit/knot_system.hpp"
#include "make/fit/samples.hpp"

namespace batten::fitting {

/// Where the points of a curve stand on it.
struct Places {
    std::vector<double> t;
    bool are_feet = false;  ///< they have been corrected
};

/// Points by coordinate, their errors, and their parameters, which move.
class CurveProblem {
public:
    /// Parameters are chord lengths. Throws what `fit_curve` says about points and errors.
    CurveProblem(PointsView points, std::span<const double> sigma, const FitOptions& options);

    const Places& places() const { return places_; }
    SigmaSource source() const { return source_; }
    std::optional<double> common_sigma() const {
        return sigma_.empty() ? std::optional(common_) : std::nullopt;
    }

    /// What a fit works on; valid until the parameters change.
    Samples samples() const;

    void restore(Places places) { places_ = std::move(places); }

    /// Chord lengths again, now between points with weight only: factors of sigma, inf where there
    /// is none. Those without come to stand half-way.
    void measure_chords(std::span<const double> factors);

    /// Moves every parameter one Newton step towards the foot of its point: the ends of an open
    /// curve held; points with weight half-way to their neighbours at most, so that order is kept
    /// and no gap opens at once; the others between them. `factors` as above, or empty.
    void correct(std::span<const SplineFunction> curve, std::span<const double> factors);
    /// Moves the parameters of points with weight on to where the curve is nearest, whatever their
    /// order; those that were never corrected stay.
    void settle(const Curve& curve, std::span<const double> factors);

private:
    void choose_sigma(std::span<const double> sigma, const FitOptions& options);
    double noise() const;
    Points rows(std::span<const std::size_t> picked) const;
    std::vector<double> point(std::size_t i) const;

    Ends ends_;
    Interval domain_;
    std::vector<std::vector<double>> columns_;
    Places places_;
    std::vector<double> sigma_;
    double common_ = 1, least_delta2_ = 0;
    Work work_;
    SigmaSource source_ = SigmaSource::estimated;
};

/// One Newton step from t towards the foot of `point` on a curve.
double nearer(std::span<const SplineFunction> curve, std::span<const double> point, double t);

}  // namespace batten::fitting
