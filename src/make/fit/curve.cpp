#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_curve.hpp"
#include "make/fit/finish.hpp"
#include "make/fit/knot_choice.hpp"
#include "make/fit/shape_limits.hpp"
#include "make/interpolate/chords.hpp"

namespace batten {
namespace {

using namespace fitting;

constexpr double gain_enough = 1e-4;  // of delta2, to correct the parameters once more

void refuse_unless(bool is_good, const char* option) {
    if (is_good) return;
    throw Error("fit.options", option, "given", "does not go with parametric curves");
}

void require_curve_options(const FitOptions& o) {
    require_options(o);
    refuse_unless(o.robust == Robust::none, "robust");
    refuse_unless(o.stop != StopRule::distribution, "stop");
    refuse_unless(o.knots != KnotPlacement::free && o.knots != KnotPlacement::pruned, "knots");
    refuse_unless(!o.tolerance, "tolerance");
    refuse_unless(o.sigma_model.empty(), "sigma_model");
    refuse_unless(!has_limits(o), "limits");
    refuse_unless(o.suggest == 0, "suggest");
    refuse_unless(o.degree > 0, "degree");
}

/// Points by coordinate, their parameters and errors.
class Problem {
public:
    Problem(PointsView points, std::span<const double> sigma, const FitOptions& options)
        : ends_(ends_of(options)), work_(options.progress) {
        const interpolation::Chords chords =
            interpolation::chords_with_repeats(points, options.closed);
        columns_.resize(static_cast<std::size_t>(points.dim()));
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t s = 0; s < columns_.size(); ++s) {
                columns_[s].push_back(points(i, static_cast<int>(s)));
            }
            t_.push_back(sum);
            if (i < chords.lengths.size()) sum += chords.lengths[i];
        }
        if (!(sum > 0)) {
            throw Error("points.all-equal", "points", std::to_string(points.size()),
                        "a curve needs two different points");
        }
        domain_ = {0, sum};
        choose_sigma(sigma, options);
        double largest = 0;
        for (const double x : points.coordinates()) largest = std::max(largest, std::fabs(x));
        require_units(samples(), largest, options.degree);
        if (source_ == SigmaSource::estimated) {
            Samples some = samples();
            estimate_sigma(some, noise(), largest);
            common_ = some.common_sigma;
            least_delta2_ = some.least_delta2;
        }
    }

    const std::vector<double>& parameters() const { return t_; }
    SigmaSource source() const { return source_; }
    std::optional<double> common_sigma() const {
        return sigma_.empty() ? std::optional(common_) : std::nullopt;
    }

    /// What a fit works on; valid until the parameters change.
    Samples samples() const {
        Samples result;
        result.x = t_;
        for (const auto& column : columns_) result.sides.emplace_back(column);
        result.sigma = sigma_;
        result.common_sigma = common_;
        result.source = source_;
        result.sigma_known = source_ != SigmaSource::estimated;
        result.range = domain_;
        result.least_delta2 = least_delta2_;
        result.work = work_;
        return result;
    }

    void restore(std::vector<double> t) { t_ = std::move(t); }

    /// Moves every parameter one Newton step towards the foot of its point.
    void correct(const std::vector<SplineFunction>& curve) {
        const std::size_t n = t_.size();
        const bool is_open = ends_ == Ends::open;
        for (std::size_t i = is_open ? 1 : 0; i + (is_open ? 1 : 0) < n; ++i) {
            double slope = 0, bend = 0, speed_sq = 0;
            for (std::size_t s = 0; s < curve.size(); ++s) {
                const double off = curve[s](t_[i]) - columns_[s][i], d = curve[s](t_[i], 1);
                slope += off * d;
                speed_sq += d * d;
                bend += d * d + off * curve[s](t_[i], 2);
            }
            if (speed_sq == 0) continue;
            // Where the point lies beyond the centre of curvature, the step of Gauss and Newton.
            const double step = -slope / (bend > 0.5 * speed_sq ? bend : speed_sq);
            t_[i] = domain_.clamp(t_[i] + step);
        }
        for (std::size_t i = 1; i < n; ++i) t_[i] = std::max(t_[i], t_[i - 1]);
    }

private:
    void choose_sigma(std::span<const double> sigma, const FitOptions& options) {
        if (!sigma.empty()) {
            sigma_.assign(sigma.begin(), sigma.end());
            source_ = SigmaSource::column;
        } else if (options.sigma) {
            if (!(*options.sigma > 0 && std::isfinite(*options.sigma))) {
                throw Error("fit.sigma", "sigma", format_number(*options.sigma),
                            "must be above 0 and finite");
            }
            common_ = *options.sigma;
            source_ = SigmaSource::number;
        }
        for (std::size_t i = 0; i < sigma_.size(); ++i) {
            if (sigma_[i] > 0 && std::isfinite(sigma_[i])) continue;
            throw Error("fit.sigma", "row " + std::to_string(i) + ", column sigma",
                        format_number(sigma_[i]), "errors must be above 0 and finite", {i});
        }
    }

    /// Of one coordinate, from differences of neighbours.
    double noise() const {
        double sum = 0;
        for (const auto& column : columns_) {
            const double one = noise_from_differences(t_, column);
            sum += one * one;
        }
        return std::sqrt(sum / static_cast<double>(columns_.size()));
    }

    Ends ends_;
    Interval domain_;
    std::vector<std::vector<double>> columns_;
    std::vector<double> t_, sigma_;
    double common_ = 1, least_delta2_ = 0;
    Work work_;
    SigmaSource source_ = SigmaSource::estimated;
};

std::vector<SplineFunction> coordinates_of(const FixedFit& fixed, std::size_t dim) {
    std::vector<SplineFunction> result;
    for (std::size_t s = 0; s < dim; ++s) result.push_back(spline_of(fixed, static_cast<int>(s)));
    return result;
}

ResidualTally tally_all(const Samples& samples, const std::vector<SplineFunction>& curve) {
    ResidualTally all;
    for (std::size_t s = 0; s < curve.size(); ++s) {
        const ResidualTally one = tally(samples, curve[s], static_cast<int>(s));
        all.delta2 += one.delta2;
        for (std::size_t w = 0; w < all.psi.size(); ++w) {
            all.psi[w] += one.psi[w] / static_cast<double>(curve.size());
        }
        all.max_residual = std::max(all.max_residual, one.max_residual);
        all.runs += one.runs;
        all.positive += one.positive;
    }
    return all;
}

/// The best of the fits met while parameters are corrected, knots as they are.
FixedFit corrected(Problem& problem, FixedFit fixed, const LocalBasis& basis,
                   const FitOptions& options) {
    const std::size_t dim = problem.samples().sides.size();
    double best = tally_all(problem.samples(), coordinates_of(fixed, dim)).delta2;
    for (int round = 0; round < options.corrections && fixed.undetermined.empty(); ++round) {
        std::vector<double> before = problem.parameters();
        problem.correct(coordinates_of(fixed, dim));
        const Samples samples = problem.samples();
        samples.work.step();
        FixedFit next = solve_fixed(samples, fixed.knots, basis, ends_of(options));
        const double delta2 = tally_all(samples, coordinates_of(next, dim)).delta2;
        if (!next.undetermined.empty() || !(delta2 < best)) {
            problem.restore(std::move(before));
            break;
        }
        const bool is_enough = best - delta2 <= gain_enough * best;
        best = delta2;
        fixed = std::move(next);
        if (is_enough) break;
    }
    return fixed;
}

BSplineCurve curve_of(const FixedFit& fixed, const std::vector<SplineFunction>& coordinates) {
    const std::size_t functions = static_cast<std::size_t>(fixed.functions);
    Points control(functions, static_cast<int>(coordinates.size()));
    for (std::size_t j = 0; j < functions; ++j) {
        for (std::size_t s = 0; s < coordinates.size(); ++s) {
            control(j, static_cast<int>(s)) = coordinates[s].coefficients()[j];
        }
    }
    const int degree = coordinates[0].degree();
    return coordinates[0].is_closed()
               ? BSplineCurve(BSplineBasis::periodic(coordinates[0].breaks(), degree),
                              std::move(control))
               : BSplineCurve(BSplineBasis(fixed.knots, degree), std::move(control));
}

}  // namespace

CurveFit fit_curve(PointsView points, std::span<const double> sigma, const FitOptions& options) {
    if (points.dim() != 2 && points.dim() != 3) {
        throw Error("points.dimension", "points", std::to_string(points.dim()) + " coordinates",
                    "a curve is fitted in the plane or in space");
    }
    require_curve_options(options);
    if (!sigma.empty() && sigma.size() != points.size()) {
        throw Error("fit.lengths", "sigma", std::to_string(sigma.size()),
                    "there must be one error a point, " + std::to_string(points.size()));
    }
    Problem problem(points, sigma, options);
    const LocalBasis basis(options.degree + 1);
    KnotChoice choice = choose_knots(problem.samples(), basis, options);
    FixedFit fixed = corrected(
        problem, solve_fixed(problem.samples(), choice.knots, basis, ends_of(options)), basis,
        options);
    if (choice.by_data && options.corrections > 0) {
        choice = choose_knots(problem.samples(), basis, options);
        fixed = corrected(
            problem, solve_fixed(problem.samples(), choice.knots, basis, ends_of(options)), basis,
            options);
    }
    const Samples samples = problem.samples();
    const std::vector<SplineFunction> curve = coordinates_of(fixed, samples.sides.size());
    FitReport report;
    const ResidualTally residuals = tally_all(samples, curve);
    fill_criteria(report, fixed,
                  {residuals.delta2, samples.values(),
                   samples.sigma_known ? SigmaKnowledge::known : SigmaKnowledge::unknown,
                   static_cast<int>(curve.size()), samples.least_delta2});
    fill_tally(report, residuals);
    fill_spline(report, curve[0]);
    for (std::size_t s = 1; s < curve.size(); ++s) {
        report.coefficients.insert(report.coefficients.end(), curve[s].coefficients().begin(),
                                   curve[s].coefficients().end());
    }
    report.sigma_source = problem.source();
    report.sigma = problem.common_sigma();
    report.path = std::move(choice.path);
    report.notes = std::move(choice.notes);
    note_what_sigma_hides(report);
    for (const FitStep& step : report.path) {
        const bool is_same = std::fabs(step.bic - report.bic) <= 1e-9 * std::fabs(report.bic);
        if (step.intervals != report.intervals || is_same) continue;
        report.notes.push_back("path: before the last correction of the parameters, bic " +
                               format_number(step.bic) + " here");
    }
    if (report.status == Status::met && !choice.is_met) report.status = Status::not_met;
    samples.work.finish();
    return {curve_of(fixed, curve), problem.parameters(), std::move(report)};
}

}  // namespace batten
