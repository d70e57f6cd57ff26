#include "batten/make/fit_bands.hpp"
#include "batten/make/fit_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "batten/base/error.hpp"
#include "make/fit/covariance.hpp"

/// Errors of values, integrals, crossings and extrema.
namespace batten {
namespace {

/// The variance over the plausible knots: each fit's own, and the square of how far it lies from
/// the fit taken. Source: [BucklandBurnhamAugustin1997], with squares added instead of roots.
template <class Variance, class Value>
double mixed_variance(const FitCovariance::Model& model, Variance&& variance, Value&& value) {
    const double scale_sq = model.width.scale * model.width.scale;
    if (model.alternatives.empty()) return scale_sq * variance(model.own);
    const double here = value(model.own.spline());
    double sum = 0;
    for (const fitting::Alternative& a : model.alternatives) {
        const double off = value(a.law.spline()) - here;
        sum += a.weight * (scale_sq * variance(a.law) + off * off);
    }
    return sum;
}

/// Whether the spline is the same everywhere, to rounding.
bool is_constant(const SplineFunction& s) {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    const auto [lo, hi] = std::minmax_element(s.coefficients().begin(), s.coefficients().end());
    return *hi - *lo <= rounding * std::max(std::fabs(*lo), std::fabs(*hi));
}

/// A fit's covariance beside its graph.
struct Companion final : CurveCompanion {
    explicit Companion(FitCovariance c) : covariance(std::move(c)) {}
    FitCovariance covariance;
};

/// Whether a derivative jumps at `x`: a knot there stands so often.
bool jumps_at(const SplineFunction& s, double x, int derivative) {
    const double near = 1e-12 * s.domain().length();
    if (x - s.domain().lo <= near || s.domain().hi - x <= near) return false;
    int knots = 0;
    for (const double t : s.knots()) knots += std::fabs(t - x) <= near;
    return knots > s.degree() - derivative;
}

/// Corners and jumps have no deviation; where all is flat there is no place.
std::vector<UncertainPlace> places_of(const FitCovariance& covariance,
                                      const std::vector<double>& places, int derivative) {
    const SplineFunction& s = covariance.model().own.spline();
    std::vector<UncertainPlace> result;
    for (const double x : places) {
        const std::optional<double> deviation = covariance.deviation_of_place(x, derivative);
        if (deviation || jumps_at(s, x, derivative)) result.push_back({x, deviation});
    }
    return result;
}

}  // namespace

Curve with_covariance(const Curve& graph, FitCovariance covariance) {
    return graph.with(std::make_shared<Companion>(std::move(covariance)));
}

const FitCovariance* covariance_of(const Curve& curve) {
    const Companion* companion = curve.companion<Companion>();
    return companion ? &companion->covariance : nullptr;
}

const FitCovariance& require_covariance(const FitCovariance* known) {
    if (known) return *known;
    throw Error("curve.no-band", "band", "asked for",
                "the curve does not say how sure it is: take that of a fit y(x), or its file, nothing "
                "made of it");
}

double FitCovariance::scale() const { return model_->width.scale; }
double FitCovariance::factor_95() const { return factor(95); }

double FitCovariance::factor(double percent) const {
    constexpr double normal_95 = 1.959963984540054;
    const double tail = 1 - percent / 100, degrees = model_->width.degrees;
    if (percent == 95 && degrees == 0) return normal_95;
    return degrees > 0 ? student_quantile(tail, degrees) : std::sqrt(chi2_quantile(tail, 1));
}

double FitCovariance::deviation(double x, int derivative) const {
    return std::sqrt(mixed_variance(
        *model_, [&](const fitting::CoefficientLaw& law) { return law.variance(x, derivative); },
        [&](const SplineFunction& s) { return s(x, derivative); }));
}

double FitCovariance::covariance(std::size_t i, std::size_t j) const {
    const fitting::CoefficientLaw& law = model_->own;
    const auto unit = [&](std::size_t c) {
        std::vector<double> a(static_cast<std::size_t>(law.functions()), 0.0);
        a[law.unknown(static_cast<int>(c))] = 1;
        return law.forward(std::move(a));
    };
    const std::vector<double> u = unit(i), v = unit(j);
    double sum = 0;
    for (std::size_t l = 0; l < u.size(); ++l) sum += u[l] * v[l];
    return scale() * scale() * sum;
}

Uncertain FitCovariance::integral(Interval part) const {
    const auto value = [&](const SplineFunction& s) { return batten::integral(s, part); };
    const double variance = mixed_variance(
        *model_,
        [&](const fitting::CoefficientLaw& law) { return law.integral_variance(part); }, value);
    return {value(model_->own.spline()), std::sqrt(variance)};
}

std::optional<double> FitCovariance::deviation_of_place(double x, int derivative) const {
    const SplineFunction& s = model_->own.spline();
    if (jumps_at(s, x, derivative)) return std::nullopt;
    const double slope = std::fabs(s(x, derivative + 1));
    return slope > 0 ? std::optional(deviation(x, derivative) / slope) : std::nullopt;
}

std::vector<UncertainPlace> FitCovariance::roots(double level) const {
    return places_of(*this, batten::roots(model_->own.spline(), level), 0);
}

std::vector<UncertainPlace> FitCovariance::extrema() const {
    if (is_constant(model_->own.spline())) return {};
    return places_of(*this, batten::extrema(model_->own.spline()), 1);
}

}  // namespace batten
