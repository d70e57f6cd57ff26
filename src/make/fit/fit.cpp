#include "batten/make/fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "batten/base/error.hpp"
#include "make/fit/curve_ends.hpp"
#include "make/fit/finish.hpp"
#include "make/fit/held.hpp"
#include "make/fit/isolated.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/residuals.hpp"
#include "make/fit/shape_limits.hpp"

namespace batten {
namespace {

using namespace fitting;

/// Rejection may go to and fro; weights that change smoothly settle.
constexpr int most_rejections = 20;
constexpr int most_final_reweightings = 200;
/// Redescending weights start from the fit of weights that drop nothing [Huber1981].
constexpr int rounds_of_huber = 5;

/// The fit over the chosen knots, weights decided by its own residuals where that is asked.
struct FinalFit {
    std::unique_ptr<Samples> weighted;  ///< null: the samples as they are
    FixedFit fixed;
    std::vector<std::size_t> rejected;
    bool is_within = true;  ///< the limits asked for could be kept
    bool is_settled = true; ///< more reweightings would change nothing to speak of
};

/// Keeps the limits asked for and what the choice holds, if any; whether that could be done.
bool limit(FixedFit& fixed, const FitOptions& options,
           std::span<const HeldDerivative> held = {}) {
    hold_smooth(fixed, held);
    return !has_limits(options) ||
           (fixed.undetermined.empty() && keep_within_limits(fixed, options));
}

FinalFit final_fit(const Samples& samples, const LocalBasis& basis, KnotChoice& choice,
                   const FitOptions& options) {
    const Ends ends = ends_of(options);
    const bool is_solved = choice.solved && options.robust == Robust::none;
    FinalFit result{nullptr,
                    is_solved ? *std::move(choice.solved)
                              : solve_fixed(samples, choice.knots, basis, ends), {}};
    result.is_within = limit(result.fixed, options, choice.held);
    if (options.robust == Robust::none) return result;
    std::vector<double> before;
    const bool is_rejection = options.robust == Robust::reject;
    const int most = is_rejection ? most_rejections : most_final_reweightings;
    result.is_settled = is_rejection;
    for (int round = 0; round < most; ++round) {
        const bool is_start = options.robust == Robust::tukey && round < rounds_of_huber;
        std::vector<double> factors =
            robust_factors(is_start ? Robust::huber : options.robust, samples,
                           residuals_of(samples, splines_of(result.fixed, 1)));
        if (!is_start && are_alike(factors, before)) {
            result.is_settled = true;
            break;
        }
        before = std::move(factors);
        auto weighted = std::make_unique<Samples>(reweighted(samples, before));
        FixedFit fixed = solve_fixed(*weighted, choice.knots, basis, ends);
        if (!fixed.undetermined.empty()) break;
        result.is_within = limit(fixed, options, choice.held);
        result.fixed = std::move(fixed);
        result.weighted = std::move(weighted);
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (std::isinf(before[i])) result.rejected.push_back(samples.row(i));
    }
    std::sort(result.rejected.begin(), result.rejected.end());
    return result;
}

/// Optimised knots widen the bands by the parameters they are; for inserted ones there are the
/// alternatives.
Width width_of(const FitReport& report) {
    Width width;
    const double degrees = static_cast<double>(report.samples) - report.parameters;
    if (report.sigma_source == SigmaSource::estimated && degrees > 0) {
        width.scale = std::sqrt(report.sigma2.value_or(1));
        width.degrees = degrees;
    }
    if (report.parameters > 0) {
        width.scale *= std::sqrt(static_cast<double>(report.parameters_charged) /
                                 report.parameters);
    }
    return width;
}

Status status_of(const FitReport& report, const KnotChoice& choice, bool is_within) {
    if (report.status != Status::met) return report.status;
    if (!is_within) return Status::not_met;
    if (!choice.is_converged) return Status::not_converged;
    return choice.is_met ? Status::met : Status::not_met;
}

/// The alternatives, each with the limits asked for; those that cannot keep them are left out.
std::vector<Alternative> limited(std::vector<Alternative> alternatives, const Samples& samples,
                                 const LocalBasis& basis, const FitOptions& options) {
    if (!has_limits(options)) return alternatives;
    std::vector<Alternative> kept;
    double sum = 0;
    for (const Alternative& a : alternatives) {
        const std::span<const double> knots = a.law.spline().knots();
        FixedFit fixed = solve_fixed(samples, {knots.begin(), knots.end()}, basis, Ends::open);
        if (!limit(fixed, options)) continue;
        kept.push_back({a.weight, CoefficientLaw(spline_of(fixed), fixed.system, fixed.held)});
        sum += a.weight;
    }
    for (Alternative& a : kept) a.weight /= sum;
    return kept;
}

/// The samples without those that stand alone, where outliers are to have no weight; `dropped`
/// says which.
struct Sieved {
    Samples samples;
    std::vector<std::size_t> dropped;
};

Sieved without_isolated(Samples samples, const FitOptions& options) {
    if (options.robust != Robust::reject && options.robust != Robust::tukey) {
        return {std::move(samples), {}};
    }
    const std::vector<double> factors = isolated_factors(samples);
    if (factors.empty()) return {std::move(samples), {}};
    std::vector<std::size_t> dropped;
    double largest = 0;
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (std::isinf(factors[i])) dropped.push_back(samples.row(i));
        else largest = std::max(largest, std::fabs(samples.sides[0][i]));
    }
    Samples rest = reweighted(samples, factors);
    if (!rest.sigma_known) {
        estimate_sigma(rest, noise_from_differences(rest.x, rest.sides[0]), largest);
    }
    if (samples.sigma.empty()) rest.sigma = {};
    return {std::move(rest), std::move(dropped)};
}

/// Knots that are chosen without a look at the samples, who are many: they can be looked at while
/// they are reduced.
bool may_believe(const FitSamples& given, const FitOptions& options) {
    constexpr std::size_t many = 4096;  // fewer are in the cache anyway
    const KnotPlacement placement = placement_of(options);
    const bool is_fixed = placement == KnotPlacement::given ||
                          (placement == KnotPlacement::equal && options.intervals);
    return is_fixed && given.x.size() >= many && options.robust == Robust::none &&
           !has_limits(options);
}

/// A fit and what it is of.
struct Solved {
    Samples samples;
    std::vector<std::size_t> dropped;
    KnotChoice choice;
    FinalFit last;
};

std::optional<Solved> solved_looking(const FitSamples& given, const LocalBasis& basis,
                                     const FitOptions& options) {
    std::optional<Samples> samples;
    if (may_believe(given, options)) samples = believed(given, options);
    if (!samples) return std::nullopt;
    KnotChoice choice = choose_knots(*samples, basis, options);
    std::optional<FixedFit> fixed = solve_looking(*samples, choice.knots, basis, ends_of(options));
    if (!fixed) return std::nullopt;
    return Solved{std::move(*samples), {}, std::move(choice), {nullptr, std::move(*fixed), {}}};
}

Solved solved(const FitSamples& given, const LocalBasis& basis, const FitOptions& options) {
    Sieved sieved = without_isolated(prepared(given, options), options);
    KnotChoice choice = choose_knots(sieved.samples, basis, options);
    FinalFit last = final_fit(sieved.samples, basis, choice, options);
    return {std::move(sieved.samples), std::move(sieved.dropped), std::move(choice),
            std::move(last)};
}

/// The report of everything but the bands.
FitReport report_of(Solved& solved, const SplineFunction& spline) {
    const Samples& samples = solved.samples;
    const Samples& used = solved.last.weighted ? *solved.last.weighted : samples;
    FitReport report;
    const ResidualTally residuals = tally(used, spline);
    fill_criteria(report, solved.last.fixed,
                  {residuals.delta2, used.size(),
                   samples.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown, 1,
                   samples.least_delta2});
    fill_tally(report, residuals);
    fill_spline(report, spline);
    report.parameters_charged += solved.choice.moved;
    report.rejected = std::move(solved.last.rejected);
    report.rejected.insert(report.rejected.end(), solved.dropped.begin(), solved.dropped.end());
    std::sort(report.rejected.begin(), report.rejected.end());
    report.sigma_source = samples.source;
    if (samples.sigma.empty()) report.sigma = samples.common_sigma;
    report.path = std::move(solved.choice.path);
    report.notes = std::move(solved.choice.notes);
    note_open_coefficients(report);
    if (solved.choice.by_data && solved.choice.is_met) note_many_coefficients(report);
    note_what_sigma_hides(report);
    note_large_residuals(report);
    report.status = status_of(report, solved.choice, solved.last.is_within);
    if (!solved.last.is_settled) {
        report.notes.push_back("robust: weights still change after " +
                               std::to_string(most_final_reweightings) + " reweightings");
    }
    if (!solved.last.is_within) {
        report.notes.push_back("limits: no spline over these knots keeps them");
    }
    return report;
}

/// The error of one more measurement: as stated, or as the residuals say.
double next_error(const Samples& samples, const FitReport& report) {
    const double sigma = samples.sigma_at(samples.size() / 2);
    const bool is_estimated = report.sigma_source == SigmaSource::estimated;
    return is_estimated ? sigma * std::sqrt(report.sigma2.value_or(1)) : sigma;
}

}  // namespace

Fit fit(const FitSamples& given, const FitOptions& options) {
    require_options(options);
    if (has_curve_ends(options)) {
        throw Error("fit.options", "fix_ends, start_tangent, end_tangent", "given",
                    "are for parametric curves: take start_value, start_slope and their like");
    }
    const LocalBasis basis(options.degree + 1);
    std::optional<Solved> early = solved_looking(given, basis, options);
    Solved all = early ? std::move(*early) : solved(given, basis, options);
    const Samples& used = all.last.weighted ? *all.last.weighted : all.samples;
    SplineFunction spline = spline_of(all.last.fixed);
    FitReport report = report_of(all, spline);
    const FitCovariance covariance(std::make_shared<FitCovariance::Model>(FitCovariance::Model{
        CoefficientLaw(spline, all.last.fixed.system, all.last.fixed.held),
        limited(std::move(all.choice.alternatives), used, basis, options), width_of(report)}));
    if (report.undetermined.empty()) fill_band(report, spline, covariance);
    if (options.knots == KnotPlacement::free && all.choice.moved > 0) {
        report.notes.push_back("extrema: deviations are those over these knots; where knots were "
                               "moved they are too small");
    }
    if (options.suggest > 0) {
        report.suggestions = covariance.suggest(options.suggest, next_error(all.samples, report));
    }
    all.samples.work.finish();
    return {std::move(spline), covariance, std::move(report)};
}

}  // namespace batten
