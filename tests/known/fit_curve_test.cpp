#include "batten/make/fit_curve.hpp"
#include "batten/measure/area.hpp"
#include "batten/measure/length.hpp"
#include "batten/measure/nearest.hpp"
#include "fit_samples.hpp"

#include <gtest/gtest.h>

#include <limits>

/// Parametric least squares: known shapes.
namespace batten {
namespace fit_curve_test {

using testing::Noise;

constexpr double two_pi = 2 * std::numbers::pi;

Points circle(int count, double noise_level, std::uint64_t seed) {
    Noise noise(seed);
    Points points(0, 2);
    for (int i = 0; i < count; ++i) {
        const double a = two_pi * i / count;
        const double radius = 10 + noise_level * noise.normal();
        points.push_back(std::vector<double>{radius * std::cos(a), radius * std::sin(a)});
    }
    return points;
}

TEST(FitCurve, GivesAClosedCurveNearNoisyPointsOfACircle) {
    FitOptions options;
    options.closed = true;
    options.sigma = 0.1;
    const CurveFit made = fit_curve(circle(200, 0.1, 1), {}, options);
    EXPECT_EQ(made.report.status, Status::met);
    EXPECT_TRUE(made.curve.is_closed());
    EXPECT_NEAR(length(Curve(made.curve)).value, 10 * two_pi, 0.3);
    EXPECT_NEAR(area(Curve(made.curve)).value, 100 * std::numbers::pi, 2);
    // Half the coordinates' noise is along the curve, where the parameters take it up.
    EXPECT_LT(made.report.delta2, 260);
    EXPECT_GT(made.report.delta2, 140);
    EXPECT_LE(made.report.intervals, 14);
}

TEST(FitCurve, ComesNearerByCorrectingParameters) {
    // A cubic is no cubic in its chord lengths.
    Points points(0, 3);
    for (int i = 0; i <= 60; ++i) {
        const double t = i / 60.0;
        points.push_back(std::vector<double>{t, t * t, t * t * t});
    }
    FitOptions options;
    options.sigma = 1e-3;
    options.knots = KnotPlacement::equal;
    options.intervals = 4;
    options.corrections = 0;
    const double before = fit_curve(points, {}, options).report.max_residual.value();
    options.corrections = 200;
    const CurveFit made = fit_curve(points, {}, options);
    EXPECT_LT(made.report.max_residual.value(), 0.6 * before);
}

TEST(FitCurve, PutsParametersWhereTheCurveIsNearest) {
    FitOptions options;
    options.closed = true;
    options.sigma = 0.1;
    options.corrections = 50;
    const Points points = circle(100, 0.1, 3);
    const CurveFit made = fit_curve(points, {}, options);
    const Curve curve(made.curve);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Jet jet = curve.jet(made.parameters[i], 1);
        const double dx = points(i, 0) - jet[0][0], dy = points(i, 1) - jet[0][1];
        const double speed = std::hypot(jet[1][0], jet[1][1]);
        EXPECT_LT(std::fabs(dx * jet[1][0] + dy * jet[1][1]) / speed, 0.02) << i;
    }
}

TEST(FitCurve, GivesResidualsThatAreDistancesAlsoWhereTheCurveIsCoarse) {
    // Polygons of few corners round a trefoil: the nearest side is often another one.
    for (const int intervals : {3, 4, 5, 7}) {
        Noise noise(static_cast<std::uint64_t>(intervals));
        Points points(0, 2);
        for (int i = 0; i < 60; ++i) {
            const double a = two_pi * i / 60, r = 2 + std::cos(3 * a) + 0.05 * noise.normal();
            points.push_back(std::vector<double>{r * std::cos(a), r * std::sin(a)});
        }
        FitOptions options;
        options.degree = 1;
        options.closed = true;
        options.sigma = 0.05;
        options.knots = KnotPlacement::equal;
        options.intervals = intervals;
        const CurveFit made = fit_curve(points, {}, options);
        const Curve curve(made.curve);
        double delta2 = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Jet jet = curve.jet(made.parameters[i], 0);
            const double off = std::hypot(points(i, 0) - jet[0][0], points(i, 1) - jet[0][1]);
            EXPECT_NEAR(off, nearest(curve, points[i]).distance, 1e-12) << intervals << " " << i;
            delta2 += off * off / (0.05 * 0.05);
        }
        EXPECT_NEAR(made.report.delta2 / delta2, 1, 1e-12);
    }
}

TEST(FitCurve, ScalesExactlyWithThePoints) {
    const Points points = circle(80, 0.1, 4);
    Points large = points;
    for (double& x : large.coordinates()) x *= 0x1p10;
    FitOptions options;
    const CurveFit one = fit_curve(points, {}, options), other = fit_curve(large, {}, options);
    ASSERT_EQ(one.report.coefficients.size(), other.report.coefficients.size());
    for (std::size_t j = 0; j < one.report.coefficients.size(); ++j) {
        EXPECT_EQ(other.report.coefficients[j], one.report.coefficients[j] * 0x1p10);
    }
}

TEST(FitCurve, CountsSamplesAndCoefficientsAcrossTheCurve) {
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 5;
    const CurveFit made = fit_curve(circle(50, 0.1, 5), {}, options);
    EXPECT_EQ(made.report.samples, 50u);
    EXPECT_EQ(made.report.parameters, 8);
    EXPECT_EQ(made.report.coefficients.size(), 16u);
    EXPECT_EQ(made.report.sigma_source, SigmaSource::estimated);
}

TEST(FitCurve, CountsEveryCoordinateWhereParametersAreNotCorrected) {
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 5;
    options.corrections = 0;
    const CurveFit made = fit_curve(circle(50, 0.1, 5), {}, options);
    EXPECT_EQ(made.report.samples, 100u);
    EXPECT_EQ(made.report.parameters, 16);
}

TEST(FitCurve, GivesDelta2AsTheSumOfSquaredDistances) {
    // Points closer along the curve than they are exact: their feet pass one another.
    const Points points = circle(600, 0.2, 7);
    FitOptions options;
    options.closed = true;
    options.sigma = 0.2;
    const CurveFit made = fit_curve(points, {}, options);
    const Curve curve(made.curve);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double e = nearest(curve, points[i]).distance / 0.2;
        sum += e * e;
        const Jet jet = curve.jet(made.parameters[i], 0);
        EXPECT_NEAR(std::hypot(jet[0][0] - points(i, 0), jet[0][1] - points(i, 1)), 0.2 * e, 1e-4);
    }
    EXPECT_NEAR(made.report.delta2, sum, 1e-5 * sum);
}

/// A noisy turn of a helix, or of its circle.
Points turn(int dim, std::uint64_t seed) {
    Noise noise(seed);
    Points points(0, dim);
    for (int i = 0; i < 150; ++i) {
        const double a = 5.0 * i / 149;
        std::vector<double> p{10 * std::cos(a), 10 * std::sin(a)};
        if (dim == 3) p.push_back(4 * a);
        for (double& x : p) x += 0.1 * noise.normal();
        points.push_back(p);
    }
    return points;
}

TEST(FitCurve, GivesStatisticsThatAreThoseOfTheNoise) {
    for (const int dim : {2, 3}) {
        double sigma2 = 0, within = 0;
        std::vector<double> p;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            FitOptions options;
            options.sigma = 0.1;
            const FitReport report = fit_curve(turn(dim, seed), {}, options).report;
            sigma2 += report.sigma2.value() / 40;
            within += report.psi[0] / 40;
            p.push_back(report.chi2_p.value());
        }
        std::sort(p.begin(), p.end());
        EXPECT_NEAR(sigma2, 1, 0.06) << dim;
        EXPECT_NEAR(within, 0.683, 0.03) << dim;
        EXPECT_GT(p[20], 0.25) << dim;
        EXPECT_LT(p[20], 0.75) << dim;
    }
}

TEST(FitCurve, SaysThatTheSearchEndedWhileTheCriterionStillFell) {
    Points star(0, 2);
    for (int i = 0; i < 101; ++i) {
        const double a = two_pi * i / 101, radius = 2 + 0.5 * std::sin(5 * a);
        star.push_back(std::vector<double>{radius * std::cos(a), radius * std::sin(a)});
    }
    FitOptions options;
    options.closed = true;
    const FitReport report = fit_curve(star, {}, options).report;
    ASSERT_EQ(report.intervals, 50);
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes[0], "intervals: the criterion was still falling at 50, where "
                               "coefficients are half as many as samples");
}

/// `points` with some of them moved away from the centre.
Points with_outliers(Points points, const std::vector<std::size_t>& rows, double by) {
    for (const std::size_t i : rows) {
        const double radius = std::hypot(points(i, 0), points(i, 1));
        for (int k = 0; k < 2; ++k) points(i, k) *= 1 + by / radius;
    }
    return points;
}

/// The largest distance of one curve from the other.
double largest_distance(const CurveFit& one, const CurveFit& other) {
    const Curve curve(one.curve);
    double largest = 0;
    for (int i = 0; i <= 200; ++i) {
        const Jet jet = curve.jet(curve.domain().lo + curve.domain().length() * (i / 200.0), 0);
        const std::vector<double> point{jet[0][0], jet[0][1]};
        largest = std::max(largest, nearest(Curve(other.curve), point).distance);
    }
    return largest;
}

Points without(PointsView points, const std::vector<std::size_t>& rows) {
    Points rest(0, points.dim());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::find(rows.begin(), rows.end(), i) == rows.end()) rest.push_back(points[i]);
    }
    return rest;
}

TEST(RobustFitCurve, IsThatOfThePointsWithoutOutliersFarOrNear) {
    const std::vector<std::size_t> rows{40, 100, 171};
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Points clean = circle(200, 0.1, seed);
        FitOptions options;
        options.closed = true;
        options.sigma = 0.1;
        const CurveFit wanted = fit_curve(without(clean, rows), {}, options);
        options.robust = Robust::reject;
        for (const double by : {0.7, 3.0}) {
            const CurveFit made = fit_curve(with_outliers(clean, rows, by), {}, options);
            EXPECT_EQ(made.report.rejected, rows) << by;
            EXPECT_EQ(made.report.samples, 197u);
            EXPECT_EQ(made.report.intervals, wanted.report.intervals);
            EXPECT_LT(largest_distance(made, wanted), 0.05 * 0.1) << by;
            EXPECT_EQ(made.parameters.size(), clean.size());
        }
    }
}

TEST(RobustFitCurve, WeighsByDistance) {
    const std::vector<std::size_t> rows{40, 100, 171};
    const Points clean = circle(200, 0.1, 1);
    FitOptions options;
    options.closed = true;
    options.sigma = 0.1;
    const CurveFit wanted = fit_curve(without(clean, rows), {}, options);
    const Points points = with_outliers(clean, rows, 0.7);
    const auto off = [&](Robust robust) {
        options.robust = robust;
        return largest_distance(fit_curve(points, {}, options), wanted) / 0.1;
    };
    EXPECT_GT(off(Robust::none), 2);
    EXPECT_LT(off(Robust::huber), 1);
    EXPECT_LT(off(Robust::tukey), 1);
}

TEST(RobustFitCurve, PutsRejectedPointsBetweenTheirNeighbours) {
    const Points points = with_outliers(circle(60, 0.01, 2), {0, 20, 45}, 2);
    FitOptions options;
    options.closed = true;
    options.robust = Robust::reject;
    const CurveFit made = fit_curve(points, {}, options);
    EXPECT_EQ(made.report.rejected, (std::vector<std::size_t>{0, 20, 45}));
    const Jet foot = Curve(made.curve).jet(made.parameters[20], 1);
    const double dx = points(20, 0) - foot[0][0], dy = points(20, 1) - foot[0][1];
    EXPECT_NEAR(std::hypot(dx, dy), 2, 0.05);
    EXPECT_LT(std::fabs(dx * foot[1][0] + dy * foot[1][1]), 0.05);
}

TEST(FitCurve, LeavesOutWhatHasNoWeight) {
    const std::vector<std::size_t> rows{7, 30};
    const Points clean = circle(60, 0.1, 2);
    std::vector<double> sigma(60, 0.1);
    for (const std::size_t i : rows) sigma[i] = std::numeric_limits<double>::infinity();
    FitOptions options;
    const CurveFit made = fit_curve(with_outliers(clean, rows, 5), sigma, options);
    options.sigma = 0.1;
    const CurveFit wanted = fit_curve(without(clean, rows), {}, options);
    EXPECT_EQ(made.report.coefficients, wanted.report.coefficients);
    EXPECT_TRUE(made.report.rejected.empty());
}

}  // namespace fit_curve_test
}  // namespace batten
