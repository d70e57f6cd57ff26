#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "batten/measure/level_lines.hpp"
#include "batten/shape/spline_surface.hpp"
#include "errors.hpp"

namespace batten::testing {
namespace level_lines_test {

/// Distances from (0, 0) on an even grid of [-1, 1] x [-1, 1].
struct Cone {
    std::vector<double> x = even_places({-1, 1}, 41), y = even_places({-1, 1}, 31);
    Grid z{41, 31};

    Cone() {
        for (std::size_t i = 0; i < x.size(); ++i) {
            for (std::size_t j = 0; j < y.size(); ++j) z(i, j) = std::hypot(x[i], y[j]);
        }
    }
};

TEST(LevelLines, OfAConeAreCirclesToTheGrid) {
    const Cone cone;
    const std::vector<Points> lines = level_lines(cone.x, cone.y, cone.z, 0.62);
    ASSERT_EQ(lines.size(), 1u);
    const Points& circle = lines.front();
    EXPECT_EQ(circle(0, 0), circle(circle.size() - 1, 0));
    EXPECT_EQ(circle(0, 1), circle(circle.size() - 1, 1));
    for (std::size_t i = 0; i < circle.size(); ++i) {
        EXPECT_NEAR(std::hypot(circle(i, 0), circle(i, 1)), 0.62, 1e-3);
    }
}

TEST(LevelLines, OfAPlaneAreExact) {
    const std::vector<double> x{0, 1, 4}, y{0, 2, 3};
    Grid z(3, 3);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) z(i, j) = x[i] + 2 * y[j];
    }
    for (const Points& line : level_lines(x, y, z, 3.5)) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            EXPECT_DOUBLE_EQ(line(i, 0) + 2 * line(i, 1), 3.5);
        }
    }
}

TEST(LevelLines, EndWhereNodesAreMissing) {
    Cone cone;
    for (std::size_t j = 0; j < 31; ++j) cone.z.drop(20, j);
    const std::vector<Points> lines = level_lines(cone.x, cone.y, cone.z, 0.62);
    ASSERT_EQ(lines.size(), 2u);
    for (const Points& line : lines) {
        for (std::size_t i = 0; i < line.size(); ++i) EXPECT_GE(std::fabs(line(i, 0)), 0.05 - 1e-12);
    }
}

TEST(LevelLines, NeedAPlaceForEveryLineOfTheGrid) {
    const std::vector<double> two{0, 1};
    EXPECT_EQ(code_of([&] { level_lines(two, two, Grid(2, 3), 0.5); }), "grid.places");
    EXPECT_EQ(code_of([&] { level_lines(two, {}, Grid(2, 0), 0.5); }), "grid.places");
}

}  // namespace level_lines_test
}  // namespace batten::testing
