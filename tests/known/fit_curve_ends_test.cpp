#include "batten/make/fit_curve.hpp"
#include "fit_samples.hpp"

#include <gtest/gtest.h>

/// Parametric least squares that keep their ends.
namespace batten {
namespace fit_curve_ends_test {

using testing::Noise;

/// A turn of a helix (in the plane: of its circle), with noise.
Points helix(int dim, double noise_level) {
    Noise noise(9);
    Points points(0, dim);
    for (int i = 0; i <= 120; ++i) {
        const double a = 4.0 * i / 120;
        std::vector<double> p{10 * std::cos(a), 10 * std::sin(a)};
        if (dim == 3) p.push_back(3 * a);
        for (double& x : p) x += noise_level * noise.normal();
        points.push_back(p);
    }
    return points;
}

FitOptions equal(int intervals) {
    FitOptions options;
    options.sigma = 0.1;
    options.knots = KnotPlacement::equal;
    options.intervals = intervals;
    return options;
}

double sine_between(std::span<const double> a, std::span<const double> b) {
    double aa = 0, ab = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += a[i] * a[i];
        ab += a[i] * b[i];
        bb += b[i] * b[i];
    }
    return std::sqrt(std::max(0.0, 1 - ab * ab / (aa * bb)));
}

TEST(FitCurveEnds, PassThroughTheFirstAndTheLastPoint) {
    for (const int dim : {2, 3}) {
        const Points points = helix(dim, 0.1);
        FitOptions options = equal(6);
        options.fix_ends = true;
        const CurveFit made = fit_curve(points, {}, options);
        const Curve curve(made.curve);
        for (int c = 0; c < dim; ++c) {
            EXPECT_EQ(curve.jet(curve.domain().lo, 0)[0][c], points(0, c));
            EXPECT_EQ(curve.jet(curve.domain().hi, 0)[0][c], points(points.size() - 1, c));
        }
        EXPECT_EQ(made.report.parameters, (dim - 1) * (9 - 2));
        EXPECT_EQ(made.report.status, Status::met);
    }
}

TEST(FitCurveEnds, LeaveAndArriveAlongTheTangentsAskedFor) {
    for (const int dim : {2, 3}) {
        FitOptions options = equal(6);
        options.start_tangent = {0, 50};
        options.end_tangent = {1, -1};
        if (dim == 3) {
            options.start_tangent = {1, 10, 3};
            options.end_tangent = {10, -5, 3};
        }
        const CurveFit made = fit_curve(helix(dim, 0.1), {}, options);
        const Curve curve(made.curve);
        const Jet first = curve.jet(curve.domain().lo, 1), last = curve.jet(curve.domain().hi, 1);
        const std::size_t n = static_cast<std::size_t>(dim);
        EXPECT_LT(sine_between({first[1].data(), n}, options.start_tangent), 1e-7);
        EXPECT_LT(sine_between({last[1].data(), n}, options.end_tangent), 1e-7);
        EXPECT_EQ(made.report.parameters, (dim - 1) * (9 - 2));
        EXPECT_EQ(made.report.status, Status::met);
    }
}

/// The sum of squares of a curve's distances at given parameters.
double delta2_of(const BSplineCurve& shape, const Points& points, std::span<const double> t) {
    const Curve curve(shape);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Jet jet = curve.jet(t[i], 0);
        for (int c = 0; c < points.dim(); ++c) {
            const double e = (points(i, c) - jet[0][c]) / 0.1;
            sum += e * e;
        }
    }
    return sum;
}

TEST(FitCurveEnds, CostAsLittleAsTheyCan) {
    const Points points = helix(2, 0.1);
    FitOptions options = equal(6);
    options.corrections = 0;
    options.fix_ends = true;
    options.start_tangent = {0.3, 1};
    const CurveFit made = fit_curve(points, {}, options);
    const double least = delta2_of(made.curve, points, made.parameters);
    EXPECT_NEAR(made.report.delta2, least, 1e-9 * least);
    Noise noise(3);
    for (int trial = 0; trial < 20; ++trial) {
        Points control(made.curve.control_points());
        const double along = 1e-3 * noise.normal();  // the second point moves with its tangent
        control(1, 0) += 0.3 * along;
        control(1, 1) += along;
        for (std::size_t j = 2; j + 1 < control.size(); ++j) {
            for (int c = 0; c < 2; ++c) control(j, c) += 1e-3 * noise.normal();
        }
        const BSplineCurve other(made.curve.basis(), std::move(control));
        EXPECT_GT(delta2_of(other, points, made.parameters), least);
    }
}

TEST(FitCurveEnds, ChangeNothingThatTheDataSayAnyway) {
    const Points points = helix(2, 0);
    FitOptions options = equal(12);
    options.degree = 5;
    options.corrections = 0;
    const CurveFit freely = fit_curve(points, {}, options);
    options.fix_ends = true;
    options.start_tangent = {0, 1};
    const CurveFit held = fit_curve(points, {}, options);
    for (std::size_t j = 0; j < freely.report.coefficients.size(); ++j) {
        EXPECT_NEAR(held.report.coefficients[j], freely.report.coefficients[j], 1e-5) << j;
    }
}

TEST(FitCurveEnds, AreKeptWithinATolerance) {
    const Points points = helix(2, 0.1);
    FitOptions options;
    options.tolerance = Tolerance{0.35};
    options.fix_ends = true;
    options.start_tangent = {0, 1};
    const CurveFit made = fit_curve(points, {}, options);
    EXPECT_EQ(made.report.status, Status::met);
    EXPECT_LE(made.report.max_residual.value(), 0.35);
    const Curve curve(made.curve);
    EXPECT_EQ(curve.jet(curve.domain().lo, 0)[0][0], points(0, 0));
    EXPECT_NEAR(curve.jet(curve.domain().lo, 1)[1][0], 0, 1e-9);
    EXPECT_LE(made.report.intervals, 12);
}

TEST(FitCurveEnds, SayWhereTheTangentIsAgainstTheWay) {
    FitOptions options = equal(6);
    options.start_tangent = {0, -1};
    const FitReport report = fit_curve(helix(2, 0.1), {}, options).report;
    EXPECT_EQ(report.status, Status::not_met);
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes.back().substr(0, 5), "ends:");
}

}  // namespace fit_curve_ends_test
}  // namespace batten
