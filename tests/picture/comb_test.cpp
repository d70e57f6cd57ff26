#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "batten/shape/piecewise_cubic.hpp"
#include "batten/shape/spline_function.hpp"
#include "io/draw/shapes/bend.hpp"
#include "io/draw/shapes/comb.hpp"
#include "pictures.hpp"

namespace batten::testing {
namespace comb_test {

using namespace drawing;

double tooth_length(const Comb& comb, std::size_t tooth) {
    double sum_sq = 0;
    for (int k = 0; k < comb.teeth.dim(); ++k) {
        const double side = comb.teeth(2 * tooth + 1, k) - comb.teeth(2 * tooth, k);
        sum_sq += side * side;
    }
    return std::sqrt(sum_sq);
}

std::size_t teeth_of(const Comb& comb) { return comb.teeth.size() / 2; }

TEST(Comb, OfACircleHasTeethOfOneLength) {
    const double radius = 3, size = 2 * radius, tooth = 0.4;
    const Comb comb = comb_of(exact_circle(radius), tooth, size);
    // The curvature is 1 / radius = 2 / size.
    ASSERT_GT(teeth_of(comb), 100u);
    for (std::size_t i = 0; i < teeth_of(comb); ++i) {
        EXPECT_NEAR(tooth_length(comb, i), 2 * tooth, 1e-14);
        const double out = std::hypot(comb.teeth(2 * i + 1, 0), comb.teeth(2 * i + 1, 1));
        EXPECT_NEAR(out, radius + 2 * tooth, 1e-14);
    }
    ASSERT_EQ(comb.envelope.size(), 1u);
}

TEST(Comb, OfACircleHasTeethEvenlyAllAround) {
    const Comb comb = comb_of(exact_circle(1), 0.1, 2);
    const double step = 2 * std::numbers::pi / static_cast<double>(teeth_of(comb));
    for (std::size_t i = 0; i + 1 < teeth_of(comb); ++i) {
        const double from = std::atan2(comb.teeth(2 * i, 1), comb.teeth(2 * i, 0));
        const double to = std::atan2(comb.teeth(2 * i + 2, 1), comb.teeth(2 * i + 2, 0));
        EXPECT_NEAR(std::remainder(to - from, 2 * std::numbers::pi), step, 0.02 * step);
    }
}

TEST(Comb, PointsToTheOuterSideOfRightTurnsToo) {
    const auto clockwise = [](double t, int order, std::span<double> out) {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            const double angle = t + 0.5 * std::numbers::pi * static_cast<double>(k);
            out[2 * k] = std::cos(angle);
            out[2 * k + 1] = -std::sin(angle);
        }
    };
    const Curve circle = CallableCurve{clockwise, 2, {0, 6}, false};
    EXPECT_NEAR(bend_of(circle, 0, 1, 1).curvature, -1, 1e-14);
    const Comb comb = comb_of(circle, 0.1, 2);
    for (std::size_t i = 0; i < teeth_of(comb); ++i) {
        EXPECT_GT(std::hypot(comb.teeth(2 * i + 1, 0), comb.teeth(2 * i + 1, 1)), 1.1);
    }
}

TEST(Comb, BreaksAtACornerAndWhereTheCurvatureJumps) {
    const double size = 3.6;
    const Comb comb = comb_of(drop(), 0.3, size);
    // Both flanks and the half circle between them, whose two cubics join.
    ASSERT_EQ(comb.envelope.size(), 3u);
    const std::array<double, 2> tip{0, -2.6};
    int at_corner = 0;
    for (std::size_t i = 0; i < teeth_of(comb); ++i) {
        if (comb.teeth(2 * i, 0) == tip[0] && comb.teeth(2 * i, 1) == tip[1]) ++at_corner;
    }
    EXPECT_EQ(at_corner, 2);  // one for each side
    for (const Points& run : comb.envelope) {
        for (std::size_t i = 1; i < run.size(); ++i) {
            EXPECT_LT(std::hypot(run(i, 0) - run(i - 1, 0), run(i, 1) - run(i - 1, 1)), 0.2);
        }
    }
}

TEST(Comb, OfAPolygonHasNoTooth) {
    const Points square({0, 0, 1, 0, 1, 1, 0, 1, 0, 0}, 2);
    const Points sides({1, 0, 0, 1, -1, 0, 0, -1}, 2);
    const Curve polygon = PiecewiseCubic::hermite(square, sides, sides, {0, 1, 2, 3, 4}, true);
    EXPECT_LT(peak_curvature(polygon, 1), 1e-12);
    const Comb comb = comb_of(polygon, 0.1, 1);
    EXPECT_EQ(comb.envelope.size(), 4u);
    for (std::size_t i = 0; i < teeth_of(comb); ++i) EXPECT_LT(tooth_length(comb, i), 1e-12);
}

TEST(Comb, LeavesOutACusp) {
    const auto cusp = [](double t, int order, std::span<double> out) {
        const double jets[4][2] = {{t * t, t * t * t}, {2 * t, 3 * t * t}, {2, 6 * t}, {0, 6}};
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            out[2 * k] = jets[k][0];
            out[2 * k + 1] = jets[k][1];
        }
    };
    const Curve curve = CallableCurve{cusp, 2, {-1, 1}, false};
    EXPECT_FALSE(bend_of(curve, 0, 0, 1).exists);
    const double peak = peak_curvature(curve, 2);
    EXPECT_GT(peak, 10);
    EXPECT_LE(peak, 1e4);
    const Comb comb = comb_of(curve, 0.01, 2);
    for (std::size_t i = 0; i < teeth_of(comb); ++i) EXPECT_LE(tooth_length(comb, i), 2);
}

TEST(Comb, InSpaceIsNormalToTheCurve) {
    const Comb comb = comb_of(helix(), 1, 6);
    const double size = 6;
    for (std::size_t i = 0; i < teeth_of(comb); ++i) {
        const double t = comb.teeth(2 * i, 2) / 0.25;  // the helix rises evenly
        const Bend bend = bend_of(helix(), 0, t, size);
        double along = 0;
        for (int k = 0; k < 3; ++k) {
            along += bend.tangent[static_cast<std::size_t>(k)] *
                     (comb.teeth(2 * i + 1, k) - comb.teeth(2 * i, k));
        }
        EXPECT_NEAR(along, 0, 1e-12);
        EXPECT_NEAR(tooth_length(comb, i), bend.curvature, 1e-9);
    }
}

TEST(CurvaturePeak, IsThatOfTheClosedForm) {
    // The ellipse 3 cos t, 2 sin t has its largest curvature 3 / 4 at its long ends.
    const auto ellipse = [](double t, int order, std::span<double> out) {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            const double angle = t + 0.5 * std::numbers::pi * static_cast<double>(k);
            out[2 * k] = 3 * std::cos(angle);
            out[2 * k + 1] = 2 * std::sin(angle);
        }
    };
    const Curve curve = CallableCurve{ellipse, 2, {0.3, 5.1}, false};
    EXPECT_NEAR(peak_curvature(curve, 6) / 6, 0.75, 1e-3);
}

TEST(CurvaturePlot, OfACircleIsALine) {
    const Panel panel = curvature_plot(exact_circle(2));
    const auto& line = std::get<PolylineLayer>(panel.layers.at(0));
    ASSERT_EQ(line.runs.size(), 1u);
    const Points& run = line.runs[0];
    EXPECT_EQ(run(0, 0), 0);
    EXPECT_NEAR(run(run.size() - 1, 0), 4 * std::numbers::pi, 1e-12);
    for (std::size_t i = 0; i < run.size(); ++i) EXPECT_NEAR(run(i, 1), 0.5, 1e-14);
}

TEST(CurvaturePlot, BreaksWhereTheCurvatureJumps) {
    const Panel panel = curvature_plot(drop());
    EXPECT_EQ(std::get<PolylineLayer>(panel.layers.at(0)).runs.size(), 3u);
}

TEST(Trace, OfAFunctionStaysWithinItsTolerance) {
    const Trace trace = trace_of(exact_circle(5));
    ASSERT_EQ(trace.runs.size(), 1u);
    const Points& run = trace.runs[0];
    for (std::size_t i = 1; i < run.size(); ++i) {
        const double middle = std::hypot(run(i, 0) + run(i - 1, 0), run(i, 1) + run(i - 1, 1)) / 2;
        EXPECT_GT(middle, 5 - 2e-4 * 10);
    }
}

/// The largest distance in y of chords from y = 0.01 (x / 300)^4 (1 - x / 300), over its height.
double coarseness(const Trace& trace) {
    const auto value = [](double x) { return 0.01 * std::pow(x / 300, 4) * (1 - x / 300); };
    double largest = 0;
    for (const Points& run : trace.runs) {
        for (std::size_t i = 1; i < run.size(); ++i) {
            const double x = (run(i, 0) + run(i - 1, 0)) / 2, y = (run(i, 1) + run(i - 1, 1)) / 2;
            largest = std::max(largest, std::fabs(y - value(x)));
        }
    }
    return largest / value(240);
}

TEST(Trace, OfAGraphInAChartIsAsFineAsItsOwnAxes) {
    std::vector<double> knots(6, 0), heights(6, 0);
    knots.resize(12, 300);
    heights[4] = 0.01 / 5;  // the Bernstein polynomial of degree 5 over its factor
    const Curve flat = graph(SplineFunction(knots, heights, 5));
    EXPECT_LT(coarseness(trace_of(flat, AxisUnits::own)), 1e-3);
    EXPECT_GT(coarseness(trace_of(flat)), 1e-3);
}

TEST(Trace, OfCubicsIsExactAndSoIsItsBox) {
    const Trace trace = trace_of(near_circle(1));
    EXPECT_EQ(trace.beziers.size(), 16u);
    EXPECT_NEAR(trace.beziers(1, 1), 4 * (std::numbers::sqrt2 - 1) / 3, 1e-15);
    // One cubic from (0, 0) to (0, 0) by way of (1, 3) and (-1, 3): highest at y = 9/4.
    const Points ends({0, 0, 0, 0}, 2);
    const Curve loop = PiecewiseCubic::hermite(ends, Points({3, 9}, 2), Points({3, -9}, 2), {0, 1},
                                               true);
    const Box box = box_of(trace_of(loop));
    EXPECT_NEAR(box.sides[1].hi, 2.25, 1e-15);
    EXPECT_EQ(box.sides[1].lo, 0);
    EXPECT_NEAR(box.sides[0].hi, std::sqrt(3.0) / 6, 1e-15);
    EXPECT_NEAR(box.sides[0].lo, -std::sqrt(3.0) / 6, 1e-15);
}

}  // namespace comb_test
}  // namespace batten::testing
