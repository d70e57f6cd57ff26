#include "batten/make/thin.hpp"

#include <cmath>
#include <numbers>

#include "shared.hpp"

namespace batten {
namespace thin_test {

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

/// Whether every fourth sample of `a` is within `enough` of the samples of `b`, and the other way
/// round.
bool within(const std::vector<std::array<double, 2>>& a,
            const std::vector<std::array<double, 2>>& b, double enough) {
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        const std::array<double, 2>* const first = to->data();
        const std::size_t chords = to->size() - 1;
        std::size_t k = 0;  // the nearest chord is looked for from that of the sample before
        for (std::size_t i = 0; i < from->size(); i += 4) {
            const double x = (*from)[i][0], y = (*from)[i][1];
            bool is_near = false;
            for (std::size_t tried = 0; tried < chords && !is_near; ++tried) {
                const std::size_t at = (k + tried) % chords;
                const double ax = first[at][0], ay = first[at][1];
                const double dx = first[at + 1][0] - ax, dy = first[at + 1][1] - ay;
                const double share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
                const double s = share < 0 ? 0 : share > 1 ? 1 : share;
                const double gx = ax + s * dx - x, gy = ay + s * dy - y;
                is_near = gx * gx + gy * gy <= enough * enough;
                if (is_near) k = at;
            }
            if (!is_near) return false;
        }
    }
    return true;
}

/// Whether some choice of `count` points, both ends among them, gives the curve within the
/// tolerance.
bool any_choice(const Points& points, std::size_t count, int degree, double tolerance) {
    if (count <= static_cast<std::size_t>(degree)) return false;
    const auto whole = samples(points, degree);
    const std::size_t inner = points.size() - 2;
    for (unsigned choice = 0; choice < (1u << inner); ++choice) {
        Points kept(0, 2);
        kept.push_back(points.view()[0]);
        for (std::size_t i = 0; i < inner; ++i) {
            if (choice >> i & 1u) kept.push_back(points.view()[i + 1]);
        }
        kept.push_back(points.view()[inner + 1]);
        if (kept.size() != count) continue;
        if (within(samples(kept, degree), whole, tolerance)) return true;
    }
    return false;
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
            for (std::size_t fewer = 4; fewer + 1 < result.points.size(); ++fewer) {
                EXPECT_FALSE(any_choice(points, fewer, 3, tolerance))
                    << shape << ' ' << tolerance << ": " << fewer << " points are enough";
            }
            EXPECT_TRUE(within(samples(result.points, 3), samples(points, 3), tolerance));
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
    std::size_t near = 0;  // both run along the same curve: the next is not far from the last
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest_sq = 1e300;
        const std::size_t from = near > 500 ? near - 500 : 0;
        for (std::size_t k = from; k < std::min(from + 1500, again.size()); ++k) {
            const double dx = points(i, 0) - again(k, 0), dy = points(i, 1) - again(k, 1);
            const double dz = points(i, 2) - again(k, 2), sq = dx * dx + dy * dy + dz * dz;
            if (sq < nearest_sq) near = k;
            nearest_sq = std::min(nearest_sq, sq);
        }
        EXPECT_LE(std::sqrt(nearest_sq), 1e-2 + 1e-3);  // the samples are 2e-3 apart
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

}  // namespace thin_test
}  // namespace batten
