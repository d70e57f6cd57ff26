#include <algorithm>
#include <cmath>
#include <iterator>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_curve.hpp"
#include "make/fit/curve_search.hpp"
#include "make/fit/curve_tally.hpp"
#include "make/fit/finish.hpp"
#include "make/fit/fixed_curve.hpp"
#include "make/fit/isolated.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/shape_limits.hpp"

namespace batten {
namespace {

using namespace fitting;

void refuse_unless(bool is_good, const char* option, const char* rule) {
    if (is_good) return;
    throw Error("fit.options", option, "given", std::string("with parametric curves ") + rule);
}

void require_curve_options(const FitOptions& o) {
    require_options(o);
    refuse_unless(o.stop != StopRule::distribution, "stop",
                  "a distance is not distributed as an error is: take bic or chi2");
    refuse_unless(o.sigma_model.empty(), "sigma_model",
                  "errors are those of both coordinates: take a number or a column for sigma");
    const bool has_direction = o.monotone != Direction::free || o.convex != Direction::free;
    refuse_unless(!has_direction, "monotone, convex", "there is no up or down: fit y(x)");
    refuse_unless(!has_limits(o), "start_value, start_slope, end_value, end_slope",
                  "take fix_ends, start_tangent and end_tangent");
    refuse_unless(o.suggest == 0, "suggest", "there is no band to narrow: fit y(x)");
    refuse_unless(o.degree > 0, "degree", "there are no jumps: take degree 1 or more");
}

bool is_dropped(double factor) { return std::isinf(factor); }

/// Feet pass one another where points lie closer along the curve than they are exact.
Samples in_order(Samples samples) {
    if (std::is_sorted(samples.x.begin(), samples.x.end())) return samples;
    return reweighted(samples, std::vector<double>(samples.size(), 1.0));
}

FitReport report_of(CurveSearch& search) {
    const Samples used = in_order(search.used());
    const std::vector<SplineFunction> curve = search.curve();
    FitReport report;
    const ResidualTally residuals = curve_tally(used, curve);
    fill_criteria(report, search.result().fixed,
                  {residuals.delta2, used.values(),
                   used.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown,
                   static_cast<int>(used.directions()), used.least_delta2});
    report.parameters_charged += search.choice().moved;
    fill_tally(report, residuals);
    fill_spline(report, curve[0]);
    for (std::size_t s = 1; s < curve.size(); ++s) {
        report.coefficients.insert(report.coefficients.end(), curve[s].coefficients().begin(),
                                   curve[s].coefficients().end());
    }
    report.sigma_source = search.problem().source();
    report.sigma = search.problem().common_sigma();
    const std::vector<double>& factors = search.result().factors;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (is_dropped(factors[i])) report.rejected.push_back(i);
    }
    report.path = std::move(search.choice().path);
    report.notes = std::move(search.choice().notes);
    note_open_coefficients(report);
    note_what_sigma_hides(report);
    note_large_residuals(report);
    const auto before = std::find_if(
        report.path.rbegin(), report.path.rend(),
        [&](const FitStep& step) { return step.intervals == report.intervals; });
    if (before != report.path.rend() &&
        std::fabs(before->bic - report.bic) > 1e-9 * std::fabs(report.bic)) {
        report.notes.push_back("path: before the last correction of the parameters, bic " +
                               format_brief(before->bic, 4) + " here");
    }
    if (report.status == Status::met && !search.choice().is_met) report.status = Status::not_met;
    if (!search.keeps_ends() && report.undetermined.empty()) {
        report.notes.push_back(
            "ends: the curve does not keep them: too few coefficients, or a tangent against the "
            "way the points go");
        if (report.status == Status::met) report.status = Status::not_met;
    }
    if (report.status == Status::met && !search.choice().is_converged) {
        report.status = Status::not_converged;
    }
    return report;
}

void require_curve_points(PointsView points, std::span<const double> sigma,
                          const FitOptions& options) {
    if (points.dim() != 2 && points.dim() != 3) {
        throw Error("points.dimension", "points", std::to_string(points.dim()) + " coordinates",
                    "a curve is fitted in the plane or in space");
    }
    if (!sigma.empty() && sigma.size() != points.size()) {
        throw Error("fit.lengths", "sigma", std::to_string(sigma.size()),
                    "there must be one error a point, " + std::to_string(points.size()));
    }
    require_finite(points);
    if (options.sigma && sigma.empty() && !(*options.sigma > 0 && std::isfinite(*options.sigma))) {
        throw Error("fit.sigma", "sigma", format_number(*options.sigma),
                    "must be above 0 and finite");
    }
    for (std::size_t i = 0; i < sigma.size(); ++i) {
        if (sigma[i] > 0) continue;
        throw Error("fit.sigma", "row " + std::to_string(i) + ", column sigma",
                    format_number(sigma[i]), "errors must be above 0 (inf: no weight)", {i});
    }
}

/// Some of the points.
struct Part {
    std::vector<std::size_t> rows;
    Points points;
    std::vector<double> sigma;  ///< one a point, or empty
};

Part part_of(PointsView all, std::span<const double> sigma, std::vector<std::size_t> rows) {
    Part part{std::move(rows), Points(0, all.dim()), {}};
    for (const std::size_t i : part.rows) {
        part.points.push_back(all[i]);
        if (!sigma.empty()) part.sigma.push_back(sigma[i]);
    }
    return part;
}

/// The rows that stand alone, where outliers are to have no weight.
std::vector<std::size_t> isolated_rows(const Part& part, const FitOptions& options) {
    std::vector<std::size_t> result;
    if (options.robust != Robust::reject && options.robust != Robust::tukey) return result;
    std::vector<double> known = part.sigma;
    if (known.empty() && options.sigma) known.assign(part.points.size(), *options.sigma);
    const std::vector<double> factors = isolated_factors(part.points, ends_of(options), known);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (is_dropped(factors[i])) result.push_back(part.rows[i]);
    }
    return result;
}

std::vector<std::size_t> without(const std::vector<std::size_t>& rows,
                                 const std::vector<std::size_t>& dropped) {
    std::vector<std::size_t> result;
    std::set_difference(rows.begin(), rows.end(), dropped.begin(), dropped.end(),
                        std::back_inserter(result));
    return result;
}

/// The parameters of all points: those that took no part where the curve is nearest between
/// their neighbours.
std::vector<double> spread(const std::vector<double>& t, const std::vector<std::size_t>& rows,
                           PointsView points, std::span<const SplineFunction> curve) {
    constexpr int most_steps = 20;
    const Interval domain = curve[0].domain();
    std::vector<double> all(points.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (next < rows.size() && rows[next] == i) {
            all[i] = t[next++];
            continue;
        }
        const auto [lo, hi] = std::minmax(next == 0 ? domain.lo : t[next - 1],
                                          next == rows.size() ? domain.hi : t[next]);
        const Interval room{lo, hi};
        all[i] = room.middle();
        for (int step = 0; step < most_steps; ++step) {
            all[i] = room.clamp(nearer(curve, points[i], all[i]));
        }
    }
    return all;
}

}  // namespace

CurveFit fit_curve(PointsView points, std::span<const double> sigma, const FitOptions& options) {
    require_curve_points(points, sigma, options);
    require_curve_options(options);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (sigma.empty() || !std::isinf(sigma[i])) rows.push_back(i);
    }
    Part part = part_of(points, sigma, std::move(rows));
    const std::vector<std::size_t> isolated = isolated_rows(part, options);
    if (!isolated.empty()) part = part_of(points, sigma, without(part.rows, isolated));
    if (part.points.size() < 2) {
        throw Error("fit.too-few", "samples", std::to_string(part.points.size()),
                    "there must be at least two with weight");
    }
    CurveSearch search(part.points, part.sigma, options);
    search.run();
    const std::vector<SplineFunction> curve = search.curve();
    FitReport report = report_of(search);
    for (std::size_t& row : report.rejected) row = part.rows[row];
    report.rejected.insert(report.rejected.end(), isolated.begin(), isolated.end());
    std::sort(report.rejected.begin(), report.rejected.end());
    search.problem().samples().work.finish();
    return {curve_of(search.result().fixed),
            spread(search.problem().places().t, part.rows, points, curve), std::move(report)};
}

}  // namespace batten
