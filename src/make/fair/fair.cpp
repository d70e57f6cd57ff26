#include "batten/make/fair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "batten/base/text.hpp"
#include "make/fair/alpha.hpp"
#include "make/fair/chain.hpp"
#include "make/fair/filter.hpp"
#include "make/fair/plane_fair.hpp"
#include "make/fair/in_space.hpp"
#include "make/fair/request.hpp"
#include "make/fair/sections.hpp"

namespace batten {
namespace {

using namespace fairing;

constexpr std::size_t fewest_for_alpha = 8;
constexpr double resting_move = 1e-4;  ///< of the mean edge, of the filter's last sweep

/// A fair track and the ends of its sections.
struct Made {
    Track track;
    std::vector<std::size_t> ends;
};

PlaneGoal goal_of(const Request& request) {
    return {request.data, request.sigma, request.bound, request.held_ends};
}

/// Calls work(from, to) for each section.
template <class Work>
void for_sections(const Made& made, Work work) {
    const auto& ends = made.ends;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) work(ends[k], ends[k + 1]);
    if (made.track.closed && ends.size() > 1) work(ends.back(), ends.front());
}

/// The likeliest alpha of each section, and of all together by their errors.
double found_alpha(const Request& request, const Made& made, FairReport& report) {
    double weight = 0, sum = 0;
    for_sections(made, [&](std::size_t from, std::size_t to) {
        const Track part = part_of(request.data, from, to);
        if (part.size() < fewest_for_alpha) return;
        const AlphaEstimate estimate = most_likely_alpha(part);
        if (!std::isfinite(estimate.error) || !(estimate.error > 0)) return;
        report.segments.push_back({from, to, estimate.alpha});
        const double w = 1 / (estimate.error * estimate.error);
        weight += w;
        sum += w * estimate.alpha;
    });
    if (weight > 0) report.alpha_error = 1 / std::sqrt(weight);
    if (weight > 0 && *report.alpha_error <= identifiable_error) return sum / weight;
    report.notes.push_back(
        "alpha is not identifiable from these points: its standard error is above 0.5; "
        "alpha -1 is taken");
    return -1;
}

/// rms displacement over sigma from which the shape itself must have changed.
constexpr double far_beyond_sigma = 2;

Made faired(const Request& request, double alpha, FairReport& report) {
    const PlaneGoal goal = goal_of(request);
    PlaneResult result = fair_plane(goal, {alpha, request.lambda});
    report.sweeps += result.steps;
    report.lambda = in_data_units(result.lambda, request);
    if (!result.converged) {
        report.status = Status::not_converged;
        report.notes.push_back("after " + std::to_string(result.steps) +
                               " steps the last one would still move a point by " +
                               format_fixed(result.last_move / request.sigma, 3) + " sigma");
    }
    if (result.rms > far_beyond_sigma * request.sigma) {
        report.notes.push_back("the points move by " + format_fixed(result.rms / request.sigma, 1) +
                               " sigma (rms), more than noise explains: lambda is large for them");
    }
    std::vector<std::size_t> ends = section_ends(result.track);
    return {std::move(result.track), std::move(ends)};
}

/// Clothoids: what inflections and extrema are found on, whatever is asked.
Made first_look(const Request& request) {
    FairReport unused;
    Request plain = request;
    plain.lambda.reset();
    return faired(plain, -1, unused);
}

Made filtered_by(const Request& request, const FairOptions& options, double alpha,
                 FairReport& report) {
    FilterPlan plan{alpha, options.sweeps, options.window,
                    options.spacing == FairSpacing::equal ? Foot::middle : Foot::kept,
                    request.bound, {}};
    const std::size_t n = request.data.size();
    plan.split.assign(n, 0);
    if (options.split) {
        for (const std::size_t i : first_look(request).ends) plan.split[i] = 1;
    }
    for (std::size_t i = 0; i < request.held_ends; ++i) plan.split[i] = plan.split[n - 1 - i] = 1;
    FilterResult result = filtered(request.data, plan);
    report.sweeps = result.sweeps;
    if (result.last_move > resting_move) {
        report.status = Status::not_converged;
        report.notes.push_back("the last sweep still moved a point by " +
                               format_number(result.last_move) + " of the mean spacing");
    }
    std::vector<std::size_t> ends = section_ends(result.track);
    return {std::move(result.track), std::move(ends)};
}

Points points_from(const Track& track, const Request& request, PointsView original) {
    Points points(original);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t j = i % track.size();
        if (track.x[j] == request.data.x[j] && track.y[j] == request.data.y[j]) continue;
        points(i, 0) = original(0, 0) + track.x[j] * request.unit;
        points(i, 1) = original(0, 1) + track.y[j] * request.unit;
    }
    return points;
}

void add_displacements(const Track& track, const Request& request, FairReport& report) {
    double sum = 0, most = 0;
    for (std::size_t i = 0; i < track.size(); ++i) {
        const double d = std::hypot(track.x[i] - request.data.x[i], track.y[i] - request.data.y[i]);
        sum += d * d;
        most = std::fmax(most, d);
    }
    report.rms_displacement = std::sqrt(sum / static_cast<double>(track.size())) * request.unit;
    report.max_displacement = most * request.unit;
}

/// The chain in working units, moved to where the points are.
LogAestheticCurve to_data_units(const LogAestheticCurve& curve, double unit, PointsView original) {
    Points joints(curve.joints());
    for (std::size_t i = 0; i < joints.size(); ++i) {
        joints(i, 0) = original(0, 0) + joints(i, 0) * unit;
        joints(i, 1) = original(0, 1) + joints(i, 1) * unit;
    }
    std::vector<LogAestheticSegment> segments(curve.segments().begin(), curve.segments().end());
    for (LogAestheticSegment& s : segments) {
        s.length *= unit;
        s.start_curvature /= unit;
        s.end_curvature /= unit;
    }
    return {joints, {curve.angles().begin(), curve.angles().end()}, std::move(segments),
            curve.is_closed()};
}

void add_chain(const Made& made, const Request& request, PointsView original, Fairing& fairing) {
    const double tolerance =
        std::fmax(request.bound > 0 ? 0.1 * request.bound : 0.1 * request.sigma, 1e-9);
    const Chain chain = chain_along(made.track, fairing.report.alpha, made.ends, tolerance);
    fairing.curve = to_data_units(chain.curve, request.unit, original);
    fairing.report.arcs = chain.curve.segments().size();
    fairing.report.arcs_error = chain.error * request.unit;
}

Fairing fair_in_plane(PointsView points, const FairOptions& options) {
    Request request = checked(points, options);
    Fairing fairing{Points(points), std::nullopt, {}};
    FairReport& report = fairing.report;
    report.notes = std::move(request.notes);
    report.sigma = request.sigma * request.unit;
    Made made{request.data, {0, request.data.size() - 1}};
    if (request.is_straight) {
        report.alpha = options.alpha.value.value_or(-1);
        report.notes.push_back("the points lie on a straight line: they are fair as they are");
    } else {
        report.alpha = options.alpha.value ? *options.alpha.value
                                           : found_alpha(request, first_look(request), report);
        made = options.engine == FairEngine::filter
                   ? filtered_by(request, options, report.alpha, report)
                   : faired(request, report.alpha, report);
        report.linearity_residual = linearity_residual(made.track, report.alpha);
        if (report.segments.empty()) {
            for_sections(made, [&](std::size_t from, std::size_t to) {
                report.segments.push_back({from, to, report.alpha});
            });
        }
    }
    fairing.points = points_from(made.track, request, points);
    add_displacements(made.track, request, report);
    if (options.as == FairForm::arcs) add_chain(made, request, points, fairing);
    return fairing;
}

}  // namespace

Fairing fair(PointsView points, const FairOptions& options) {
    return points.dim() == 3 ? fair_in_space(points, options) : fair_in_plane(points, options);
}

}  // namespace batten
