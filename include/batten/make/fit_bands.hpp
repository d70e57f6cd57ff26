#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten {

/// A number and its standard deviation.
struct Uncertain {
    double value = 0;
    double deviation = 0;
};

template <class Visit>
void visit_fields(const Uncertain& r, Visit&& visit) {
    visit("value", r.value, "the number");
    visit("deviation", r.deviation, "its standard deviation");
}

/// A place that follows from a fit. No deviation where it is a knot across which jumps what is 0
/// there (the corner of an extremum, a jump over a level): it is known as the knot is.
struct UncertainPlace {
    double value = 0;
    std::optional<double> deviation;
};

template <class Visit>
void visit_fields(const UncertainPlace& r, Visit&& visit) {
    visit("value", r.value, "the place");
    visit("deviation", r.deviation, "its standard deviation; none at a corner or a jump");
}

/// The covariance of a fit's coefficients: Cov c = scale^2 (A^T W A)^-1, A the B-splines at the
/// samples, W the weights 1 / sigma^2; kept as the triangle of the banded QR.
///
/// Everything follows by linear propagation: exact for values, derivatives and integrals, to first
/// order for crossings and extrema. Immutable, cheap to copy.
class FitCovariance {
public:
    struct Model;
    explicit FitCovariance(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

    /// 1 where the errors are known and the knots were given; see docs/fitting.md for what it is
    /// where sigma was estimated or the knots were chosen by the data.
    double scale() const;
    /// How many standard deviations a two-sided 95 % band is wide on each side.
    double factor_95() const;
    /// The same for another percentage, above 0 and below 100.
    double factor(double percent) const;
    /// Standard deviation of S(x) or of a derivative of it. Cost: O(degree^2); closed O(p degree).
    double deviation(double x, int derivative = 0) const;
    /// Cov(c_i, c_j). Cost: O(p degree).
    double covariance(std::size_t i, std::size_t j) const;
    /// The integral over `part`, inside the domain. Cost: O(p degree).
    Uncertain integral(Interval part) const;
    /// Of the place `x` where the derivative of that order (0: the value) has a given number: its
    /// deviation over the size of the next derivative; none where that is 0, and at a knot where
    /// the derivative itself jumps.
    std::optional<double> deviation_of_place(double x, int derivative) const;
    /// The crossings of `level`, each with the deviation |dS| / |S'| of its place; touchings are
    /// left out.
    std::vector<UncertainPlace> roots(double level = 0) const;
    /// The places of the extrema, each with the deviation |dS'| / |S''|; flat ones are left out.
    std::vector<UncertainPlace> extrema() const;
    /// The `count` abscissae, one after the other, where one more measurement with the error
    /// `sigma` lowers the mean variance of S over the domain most; chosen among 8 a piece.
    /// Cost: O(count pieces p degree).
    std::vector<double> suggest(int count, double sigma) const;

    const Model& model() const { return *model_; }

private:
    std::shared_ptr<const Model> model_;
};

/// The graph of a fit, which knows how sure it is: files keep it, curves made of it do not have it.
Curve with_covariance(const Curve& graph, FitCovariance covariance);
/// What with_covariance said, or null.
const FitCovariance* covariance_of(const Curve& curve);
/// `known` where it is known; throws `curve.no-band` where it is null.
const FitCovariance& require_covariance(const FitCovariance* known);

}  // namespace batten
