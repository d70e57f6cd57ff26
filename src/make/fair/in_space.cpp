#include "make/fair/in_space.hpp"

#include <cmath>
#include <utility>

#include "batten/base/error.hpp"
#include "make/fair/filter.hpp"
#include "make/fair/request.hpp"
#include "make/fair/space_fair.hpp"

namespace batten::fairing {
namespace {

void require_for_space(const FairOptions& options) {
    const auto refuse = [](const char* what) {
        throw Error("fair.not-in-space", what, "points in space", "this is for the plane only");
    };
    if (options.closed) refuse("closed");
    if (options.engine == FairEngine::filter) refuse("engine");
    if (options.as == FairForm::arcs) refuse("as");
    if (!options.alpha.value) refuse("alpha");
}

SpaceGoal goal_of(const Request& request, const FairOptions& options) {
    SpaceGoal goal;
    for (std::size_t i = 0; i < request.z.size(); ++i) {
        goal.data.push_back({request.data.x[i], request.data.y[i], request.z[i]});
    }
    goal.sigma = request.sigma;
    goal.bound = request.bound;
    goal.held_ends = request.held_ends;
    goal.alpha = *options.alpha.value;
    goal.beta = options.beta;
    goal.lambda = request.lambda;
    return goal;
}

double distance(const SpacePoint& a, const SpacePoint& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double residual(const SpaceTrack& t, double alpha) {
    std::vector<double> s, kappa;
    double length = 0;
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
        length += distance(t[i - 1], t[i]);
        s.push_back(length);
        kappa.push_back(curvature(t[i - 1], t[i], t[i + 1]));
    }
    return linearity_residual(s, kappa, alpha);
}

}  // namespace

Fairing fair_in_space(PointsView points, const FairOptions& options) {
    require_for_space(options);
    Request request = checked(points, options);
    require_count(points, fewest_space_points);
    Fairing fairing{Points(points), std::nullopt, {}};
    FairReport& report = fairing.report;
    report.alpha = *options.alpha.value;
    report.sigma = request.sigma * request.unit;
    report.notes = std::move(request.notes);
    if (request.is_straight) {
        report.notes.push_back("the points lie on a straight line: they are fair as they are");
        return fairing;
    }
    const SpaceGoal goal = goal_of(request, options);
    const SpaceResult result = fair_space(goal);
    double sum = 0;
    for (std::size_t i = 0; i < result.track.size(); ++i) {
        const double d = distance(result.track[i], goal.data[i]);
        sum += d * d;
        report.max_displacement = std::fmax(report.max_displacement, d * request.unit);
        if (d == 0) continue;
        for (int k = 0; k < 3; ++k) {
            fairing.points(i, k) =
                points(0, k) + result.track[i][static_cast<std::size_t>(k)] * request.unit;
        }
    }
    report.rms_displacement =
        std::sqrt(sum / static_cast<double>(result.track.size())) * request.unit;
    report.lambda = in_data_units(result.lambda, request);
    report.sweeps = result.steps;
    report.status = result.converged ? Status::met : Status::not_converged;
    if (!result.converged) {
        report.notes.push_back("after " + std::to_string(result.steps) +
                               " steps the last one still moved the points");
    }
    report.linearity_residual = residual(result.track, report.alpha);
    return fairing;
}

}  // namespace batten::fairing
