#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/make/fair_options.hpp"
#include "batten/shape/log_aesthetic.hpp"

namespace batten {

/// A stretch of the faired points whose curvature neither changes its sign nor turns round.
struct FairSegment {
    std::size_t from = 0;
    std::size_t to = 0;
    double alpha = -1;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, FairSegment>
void visit_fields(Report& r, Visit&& visit) {
    visit("from", r.from, "first point, from 0");
    visit("to", r.to, "last point");
    visit("alpha", r.alpha, "kind of the arc: as asked, or the most likely one for these points");
}

/// What came of it, in data units.
struct FairReport {
    double alpha = -1;
    std::optional<double> alpha_error;
    double sigma = 0;
    std::optional<double> lambda;
    int sweeps = 0;
    double rms_displacement = 0;
    double max_displacement = 0;
    double linearity_residual = 0;
    std::vector<FairSegment> segments;
    std::optional<std::size_t> arcs;
    std::optional<double> arcs_error;
    std::vector<std::string> notes;
    /// not_converged: the last step or sweep still moved the points.
    Status status = Status::met;
};

template <class Report, class Visit>
requires std::same_as<std::remove_const_t<Report>, FairReport>
void visit_fields(Report& r, Visit&& visit) {
    visit("alpha", r.alpha, "the kind of curve the points were drawn to");
    visit("alpha_error", r.alpha_error, "its standard error, where it was found from the points");
    visit("sigma", r.sigma, "the noise assumed in each coordinate");
    visit("lambda", r.lambda, "the weight of fairness (engine gauss-newton)");
    visit("sweeps", r.sweeps, "steps or sweeps made");
    visit("rms_displacement", r.rms_displacement, "root of the mean squared displacement");
    visit("max_displacement", r.max_displacement, "largest displacement");
    visit("linearity_residual", r.linearity_residual,
          "distance of rho^alpha from one line in arc length, rms over mean");
    visit("segments", r.segments, "stretches between inflections and extrema of curvature");
    visit("arcs", r.arcs, "log-aesthetic arcs of the chain, where one was asked for");
    visit("arcs_error", r.arcs_error, "largest distance of a faired point from the chain");
    visit("notes", r.notes, "what else there is to say");
}

/// The faired points, and a chain of arcs through them where one was asked for.
struct Fairing {
    Points points;
    std::optional<LogAestheticCurve> curve;
    FairReport report;
};

/// Noisy points made fair: moved so that their curvature follows log-aesthetic curves.
///
/// `points` n rows, 2 or 3 columns, along the curve. Engine gauss-newton minimises
///     sum (n_i (X_i - D_i))^2 / sigma^2 + lambda sum h_i R_i^2,
///     R = kappa'' - (1 + alpha) kappa'^2 kappa / (kappa^2 + eps^2),
/// over displacements along the normals, lambda growing from small as long as the error that is to
/// be expected falls [Mallows1973]; engine filter is the paper's [MiuraYoshidaSaito]. Points in
/// a straight line come back unchanged, with a note. See docs/fairing.md.
///
/// In space the points move along two normals, and torsion is made as fair as curvature, by beta;
/// rings, arcs, the filter and the search for alpha are for the plane.
///
/// Laws:   points x 2^k (sigma, tolerance x 2^k, lambda x 2^5k) give points x 2^k, exactly
/// Cost:   gauss-newton 0.2 us a point and step, some 10 steps where lambda is given and 40 where
///         it is found; filter 0.08 us a point and sweep at window 5.
/// Throws: `points.dimension`, `points.too-few` below 5 (7 in space), `points.not-finite`, `points.repeated`,
///         `points.all-equal`, `option.range`, `fair.tolerance-below-sigma`,
///         `fair.closed-has-no-ends`, `fair.not-in-space`, `fair.options`, `fair.folds` where
///         sigma is so large against the spacing that the points turn back even when smoothed.
Fairing fair(PointsView points, const FairOptions& options);

}  // namespace batten
