#include "batten/make/thin.hpp"

#include <cmath>
#include <numbers>

#include "shared.hpp"

namespace batten {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<std::array<double, 2>> samples(const Points& points, int degree) {
    DensifyOptions options;
    options.degree = degree;
    options.between = 40;
    const Points dense = densify(points, options).points;
    std::vector<std::array<double, 2>> result;
    for (std::size_t i = 0; i < dense.size(); ++i) result.push_back({dense(i, 0), dense(i, 1)});
    return result;
}

/// The Hausdorff distance of two densely sampled curves, within a fraction of their spacing.
double hausdorff(const std::vector<std::array<double, 2>>& a,
                 const std::vector<std::array<double, 2>>& b, double enough) {
    double largest = 0;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        for (std::size_t i = 0; i < from->size(); i += 4) {
            double nearest = 1e300;
            const auto [x, y] = (*from)[i];
            for (std::size_t k = 0; k + 1 < to->size(); ++k) {
                const auto [ax, ay] = (*to)[k];
                const double dx = (*to)[k + 1][0] - ax, dy = (*to)[k + 1][1] - ay;
                const double s =
                    std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
                nearest = std::min(nearest, std::hypot(ax + s * dx - x, ay + s * dy - y));
            }
            largest = std::max(largest, nearest);
            if (largest > enough) return largest;
        }
    }
    return largest;
}

/// The fewest kept points over all choices.
std::size_t optimum(const Points& points, int degree, double tolerance) {
    const auto whole = samples(points, degree);
    const std::size_t inner = points.size() - 2;
    std::size_t best = points.size();
    for (unsigned choice = 0; choice < (1u << inner); ++choice) {
        Points kept(0, 2);
        kept.push_back(points.view()[0]);
        for (std::size_t i = 0; i < inner; ++i) {
            if (choice >> i & 1u) kept.push_back(points.view()[i + 1]);
        }
        kept.push_back(points.view()[inner + 1]);
        if (kept.size() >= best || kept.size() <= static_cast<std::size_t>(degree)) continue;
        if (hausdorff(samples(kept, degree), whole, tolerance) <= tolerance) best = kept.size();
    }
    return best;
}

TEST(Thin, KeepsAtMostOnePointMoreThanTheBestOfAllChoices) {
    for (const int shape : {0, 1, 2}) {
        Points points(2);
        for (int i = 0; i < 11; ++i) {
            const double t = i / 10.0;
            if (shape == 0) points.push_back(std::vector{2 * std::cos(pi * t), std::sin(pi * t)});
            if (shape == 1) points.push_back(std::vector{4 * t, std::sin(2 * pi * t)});
            if (shape == 2) points.push_back(std::vector{t, std::exp(-8 * t)});
        }
        for (const double tolerance : {0.1, 0.02, 0.005}) {
            ThinOptions options;
            options.tolerance = absolute(tolerance);
            options.degree = 3;
            const Thinned result = thin(points, options);
            EXPECT_LE(result.points.size(), optimum(points, 3, tolerance) + 1)
                << shape << ' ' << tolerance;
            const double gap =
                hausdorff(samples(result.points, 3), samples(points, 3), tolerance);
            EXPECT_LE(gap, tolerance);
            EXPECT_LE(result.report.max_error, tolerance);
        }
    }
}

TEST(Thin, KeepsTheEndsOfAStraightLineAndWhatTheDegreeNeeds) {
    Points points(2);
    for (int i = 0; i <= 50; ++i) points.push_back(std::vector{1.0 * i, 2.0 * i});
    ThinOptions options;
    options.tolerance = absolute(1e-9);
    options.degree = 1;
    const Thinned two = thin(points, options);
    EXPECT_EQ(two.kept, (std::vector<std::size_t>{0, 50}));
    EXPECT_EQ(two.report.points_in, 51u);
    EXPECT_EQ(two.report.points_out, 2u);
    options.degree = 3;
    EXPECT_EQ(thin(points, options).points.size(), 4u);
}

TEST(Thin, ThenDensifyGivesTheCurveBack) {
    Points points(3);  // a helix that widens
    for (int i = 0; i <= 400; ++i) {
        const double t = i / 40.0;
        points.push_back(std::vector{(1 + t) * std::cos(t), (1 + t) * std::sin(t), t});
    }
    ThinOptions options;
    options.tolerance = absolute(1e-2);
    const Thinned result = thin(points, options);
    EXPECT_LE(result.points.size(), 30u);
    EXPECT_LE(result.report.max_error, 1e-2);
    DensifyOptions dense;
    dense.between = 1000;
    const Points again = densify(result.points, dense).points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = 1e300;
        for (std::size_t k = 0; k < again.size(); ++k) {
            double sum = 0;
            for (int c = 0; c < 3; ++c) sum += std::pow(points(i, c) - again(k, c), 2);
            nearest = std::min(nearest, sum);
        }
        EXPECT_LE(std::sqrt(nearest), 1e-2 + 1e-3);  // the samples are 2e-3 apart
    }
}

TEST(Thin, AdvisesShorterCellsWhereThePointsAreTooFewForTheTolerance) {
    // A straight run, half a circle in 4 chords, a straight run.
    Points points(2);
    for (int i = 0; i < 8; ++i) points.push_back(std::vector{0.5 * i - 4, 1.0});
    for (int i = 0; i <= 4; ++i) {
        points.push_back(std::vector{std::sin(pi * i / 4), std::cos(pi * i / 4)});
    }
    for (int i = 1; i <= 8; ++i) points.push_back(std::vector{-0.5 * i, -1.0});
    ThinOptions options;
    options.tolerance = absolute(2e-3);
    const ThinReport report = thin(points, options).report;
    ASSERT_EQ(report.shorter_cells.size(), 1u);
    EXPECT_GE(report.shorter_cells[0].from, 5u);
    EXPECT_LE(report.shorter_cells[0].to, 15u);
    EXPECT_GE(report.shorter_cells[0].times, 2);
    EXPECT_EQ(report.notes.size(), 1u);
    options.tolerance = absolute(0.2);
    EXPECT_TRUE(thin(points, options).report.shorter_cells.empty());
}

TEST(Thin, OfARingKeepsItClosed) {
    Points points(2);
    for (int i = 0; i < 240; ++i) {
        const double t = 2 * pi * i / 240;
        points.push_back(std::vector{3 * std::cos(t), std::sin(t)});
    }
    ThinOptions options;
    options.tolerance = absolute(1e-3);
    options.closed = true;
    const Thinned result = thin(points, options);
    EXPECT_EQ(result.kept[0], 0u);
    EXPECT_LE(result.report.max_error, 1e-3);
    EXPECT_LE(result.points.size(), 32u);
}

}  // namespace
}  // namespace batten
