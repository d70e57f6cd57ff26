#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "batten/io/surface_file.hpp"
#include "batten/measure/contours.hpp"
#include "batten/measure/surface_measures.hpp"
#include "batten/shape/surface.hpp"
#include "errors.hpp"

/// What is asked of surfaces with curved knot lines beyond their heights.
namespace batten {
namespace front_surface_test {

constexpr Rectangle square{{0, 1}, {0, 1}};

/// 0.4 + 0.2 t^2 + offset
double front(double t) { return 0.4 + 0.2 * t * t; }
SplineFunction front_line(double offset) {
    return {{0, 0, 0, 1, 1, 1}, {0.4 + offset, 0.4 + offset, 0.6 + offset}, 2};
}
SplineFunction constant(double at) { return {{0, 1}, {at}, 0}; }

/// A function of x - front(y) alone: 0 before a bundle of four lines, 1 behind it, 1/2 in its
/// middle; a jump where `half_width` is 0.
CurvedKnotSurface step(double half_width) {
    std::vector<SplineFunction> lines;
    for (const double share : {-1.0, -0.4, 0.4, 1.0}) {
        lines.push_back(front_line(share * half_width));
    }
    std::vector<double> c(8 * 5);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = i < 4 * 5 ? 0 : 1;
    return {3, square, lines, {constant(0.5)}, c};
}

/// Lines of both kinds, those of y curved too or not, and no pattern in the coefficients.
CurvedKnotSurface rough(bool both_curved) {
    const std::vector<SplineFunction> across =
        both_curved ? std::vector{SplineFunction({0, 0, 0, 1, 1, 1}, {0.3, 0.5, 0.35}, 2),
                                  SplineFunction({0, 0, 0, 1, 1, 1}, {0.8, 0.6, 0.7}, 2)}
                    : std::vector{constant(0.3), constant(0.7)};
    std::vector<double> c(7 * 6);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::sin(static_cast<double>(i * i));
    return {3, square, {front_line(-0.2), front_line(0), front_line(0.1)}, across, c};
}

TEST(CurvedKnotSurface, HasTheDerivativesThatDifferencesOfLowerOnesShow) {
    const double h = 1e-6;
    for (const bool both : {false, true}) {
        const CurvedKnotSurface s = rough(both);
        for (const auto [x, y] : {std::array{0.05, 0.1}, {0.33, 0.2}, {0.5, 0.9}, {0.93, 0.55}}) {
            for (int nx = 0; nx <= 3; ++nx) {
                for (int ny = 0; nx + ny <= 4; ++ny) {
                    const double by_x = s(x, y, {nx + 1, ny}), by_y = s(x, y, {nx, ny + 1});
                    const double size = 1 + std::fabs(by_x) + std::fabs(by_y);
                    EXPECT_NEAR((s(x + h, y, {nx, ny}) - s(x - h, y, {nx, ny})) / (2 * h), by_x,
                                1e-5 * size * (1 + nx + ny));
                    EXPECT_NEAR((s(x, y + h, {nx, ny}) - s(x, y - h, {nx, ny})) / (2 * h), by_y,
                                1e-5 * size * (1 + nx + ny));
                }
            }
            const HeightJet jet = s.jet(x, y);
            EXPECT_NEAR(jet.xy, s(x, y, {1, 1}), 1e-12 * (1 + std::fabs(jet.xy)));
            EXPECT_NEAR(jet.yy, s(x, y, {0, 2}), 1e-12 * (1 + std::fabs(jet.yy)));
        }
    }
    EXPECT_EQ(testing::code_of([] { rough(true)(0.5, 0.5, {5, 5}); }), "surface.derivative");
}

TEST(CurvedKnotSurface, HasTheDerivativesOfATensorProductWhereLinesAreStraight) {
    const BSplineBasis basis = BSplineBasis::over(std::vector<double>{0, 0.3, 0.7, 1}, 3);
    std::vector<double> c(36);
    for (std::size_t k = 0; k < 36; ++k) c[k] = std::sin(static_cast<double>(k * k));
    const SplineSurface plain(basis, basis, c);
    const CurvedKnotSurface curved(3, square, {constant(0.3), constant(0.7)},
                                   {constant(0.7), constant(0.3)}, c);
    for (const double x : {0.1, 0.3, 0.55, 1.0}) {
        for (const double y : {0.0, 0.2, 0.7}) {
            for (const Partial p : {Partial{1, 0}, {0, 1}, {1, 1}, {2, 0}, {1, 2}, {3, 3}}) {
                const double exact = plain(x, y, p);
                EXPECT_NEAR(curved(x, y, p), exact, 1e-10 * (1 + std::fabs(exact)));
            }
        }
    }
    const Rectangle part{{0.1, 0.8}, {0.2, 0.9}};
    EXPECT_NEAR(integral(curved, part), integral(plain, part), 1e-14);
}

TEST(CurvedKnotSurface, IsIntegratedAsFineGridsSay) {
    for (const bool both : {false, true}) {
        const CurvedKnotSurface s = rough(both);
        const Rectangle part{{0.1, 0.9}, {0.15, 1}};
        const int n = 200;
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                sum += s(part.x.lo + part.x.length() * (i + 0.5) / n,
                         part.y.lo + part.y.length() * (j + 0.5) / n);
            }
        }
        const double mean = sum / (n * n) * part.x.length() * part.y.length();
        EXPECT_NEAR(integral(s, part), mean, 1e-5);
        EXPECT_NEAR(integral(s.transposed(), {part.y, part.x}), integral(s, part),
                    both ? 2e-8 : 1e-13);
    }
    // Behind a jump lies 1: the integral is that of 1 - front.
    const double exact = 1 - 0.4 - 0.2 / 3;
    EXPECT_NEAR(integral(step(0)), exact, 1e-14);
    EXPECT_NEAR(integral(step(0.05)), exact, 1e-13);
    EXPECT_EQ(testing::code_of([] { integral(step(0), {{0, 2}, {0, 1}}); }), "surface.outside");
}

TEST(CurvedKnotSurface, HasSectionsThatAreItsValues) {
    const CurvedKnotSurface s = rough(false), both = rough(true);
    const SplineFunction across = section_at_y(s, 0.3), along = section_at_x(s, 0.45);
    EXPECT_EQ(across.degree(), 3);
    EXPECT_EQ(across.breaks()[2], front(0.3));
    EXPECT_EQ(along.degree(), 5);
    for (const double t : even_places({0, 1}, 101)) {
        EXPECT_NEAR(across(t), s(t, 0.3), 1e-13);
        EXPECT_NEAR(along(t), s(0.45, t), 1e-8);
        EXPECT_NEAR(section_at_y(both, 0.62)(t), both(t, 0.62), 1e-8);
        EXPECT_NEAR(section_at_y(s.transposed(), 0.45)(t), along(t), 1e-13);
    }
}

TEST(CurvedKnotSurface, KeepsJumpsInItsSections) {
    const CurvedKnotSurface s = step(0);
    for (const auto& [cut, place] : {std::pair{section_at_y(s, 0.5), front(0.5)},
                                     std::pair{section_at_x(s, 0.45), 0.5}}) {
        const double before = cut(std::nextafter(place, 0) - 1e-9), behind = cut(place + 1e-9);
        EXPECT_NEAR(std::fabs(behind - before), 1, 1e-12);
    }
}

double farthest_from_front(const Curve& line, bool is_transposed) {
    double farthest = 0;
    for (std::size_t i = 0; i < line.pieces(); ++i) {
        for (const double u : {0.0, 0.3, 0.5, 0.8}) {
            const Interval piece = line.piece(i);
            const std::vector<double> p = line(piece.lo + u * piece.length());
            const double gap = is_transposed ? p[1] - front(p[0]) : p[0] - front(p[1]);
            farthest = std::max(farthest, std::fabs(gap));
        }
    }
    return farthest;
}

TEST(CurvedKnotSurface, HasItsLevelLineOnTheFrontHoweverSteepItIs) {
    for (const double width : {0.05, 1e-3, 1e-6, 0.0}) {
        for (const bool is_transposed : {false, true}) {
            const CurvedKnotSurface s = is_transposed ? step(width).transposed() : step(width);
            const std::vector<Contour> lines = contours(s, 0.5, absolute(1e-7));
            ASSERT_EQ(lines.size(), 1u);
            const Curve& line = lines.front().curve;
            EXPECT_LE(farthest_from_front(line, is_transposed), 1e-7) << width;
            const std::vector<double> a = line(line.domain().lo), b = line(line.domain().hi);
            // The higher ground, to the right of the front or above it, is on the left.
            if (is_transposed) EXPECT_TRUE(a[0] == 0 && b[0] == 1);
            else EXPECT_TRUE(a[1] == 1 && b[1] == 0);
        }
    }
    EXPECT_EQ(contours(step(0.05), 0.2).size(), 1u);
    EXPECT_TRUE(contours(step(0.05), 1.5).empty());
}

TEST(CurvedKnotSurface, HasLevelLinesThatLeaveAJumpAndGoOn) {
    // Falls with y on both sides: the level crosses the lower side first, then the jump.
    const CurvedKnotSurface jump = step(0);
    std::vector<double> c(8 * 5);
    const double before[] = {0, 0.1, 0.2, 0.3}, behind[] = {0.7, 0.8, 0.9, 1.2};
    for (std::size_t i = 0; i < 8; ++i) {
        for (std::size_t j = 0; j < 5; ++j) c[i * 5 + j] = (i < 4 ? before[i] : behind[i - 4]) -
                                                           0.15 * static_cast<double>(j);
    }
    const CurvedKnotSurface s(3, square, {jump.x_lines().begin(), jump.x_lines().end()},
                              {constant(0.5)}, c);
    const std::vector<Contour> lines = contours(s, 0.25, absolute(1e-6));
    ASSERT_EQ(lines.size(), 1u);
    const Curve& line = lines.front().curve;
    std::size_t on_jump = 0, beside = 0;
    for (std::size_t i = 0; i < line.pieces(); ++i) {
        const std::vector<double> p = line(line.piece(i).middle());
        if (std::fabs(p[0] - front(p[1])) <= 1e-6) {
            ++on_jump;
            continue;
        }
        EXPECT_NEAR(s(p[0], p[1]), 0.25, 1e-5);
        ++beside;
    }
    EXPECT_GT(on_jump, 10u);
    EXPECT_GT(beside, 10u);
}

TEST(CurvedKnotSurface, IsMeasured) {
    const SurfaceReport flat = measure_surface(step(0));
    EXPECT_NEAR(*flat.area, 1, 1e-12);
    EXPECT_NEAR(flat.integral, 1 - 0.4 - 0.2 / 3, 1e-14);
    EXPECT_EQ(flat.height.least.value, 0);
    EXPECT_NEAR(flat.height.largest.value, 1, 1e-14);

    const SurfaceReport r = measure_surface(rough(false));
    const SurfaceReport t = measure_surface(rough(false).transposed());
    EXPECT_EQ(r.status, Status::met);
    EXPECT_NEAR(*r.area, *t.area, 1e-8 * *r.area);
    EXPECT_NEAR(r.height.largest.value, t.height.largest.value, 1e-12);
    EXPECT_NEAR(r.height.largest.x, t.height.largest.y, 1e-6);
    double highest = -10;
    const Grid z = heights_on(rough(false), even_places({0, 1}, 201), even_places({0, 1}, 201));
    for (const double height : z.view().values()) highest = std::max(highest, height);
    EXPECT_GE(r.height.largest.value, highest - 1e-9);
    EXPECT_LE(r.height.largest.value, highest + 1e-3);
}

/// Numbers of the lines of an OBJ file that begin with `key`.
std::vector<std::array<double, 3>> vectors_in(const std::string& obj, const std::string& key) {
    std::vector<std::array<double, 3>> found;
    const auto next = [&](std::size_t from) { return obj.find('\n' + key + ' ', from); };
    for (std::size_t at = obj.find(key + ' '); at != std::string::npos; at = next(at + 1)) {
        std::size_t from = obj.find(' ', at) + 1;
        std::array<double, 3> row{};
        for (double& x : row) {
            std::size_t used = 0;
            x = std::stod(obj.substr(from, 40), &used);
            from += used + 1;
        }
        found.push_back(row);
    }
    return found;
}

TEST(Mesh, OfAJumpHasAnUprightWallOnIt) {
    for (const bool is_transposed : {false, true}) {
        const CurvedKnotSurface s = is_transposed ? step(0).transposed() : step(0);
        const std::string obj = obj_mesh(s, {even_places({0, 1}, 21), even_places({0, 1}, 11)});
        std::size_t low = 0, high = 0;
        const auto nodes = vectors_in(obj, "v"), normals = vectors_in(obj, "vn");
        ASSERT_EQ(nodes.size(), normals.size());
        for (const auto& [x, y, z] : nodes) {
            EXPECT_TRUE(std::fabs(z) < 1e-14 || std::fabs(z - 1) < 1e-14);
            const double gap = is_transposed ? y - front(x) : x - front(y);
            if (std::fabs(gap) > 1e-14) continue;
            ++(z < 0.5 ? low : high);
        }
        EXPECT_EQ(low, is_transposed ? 21u : 11u);
        EXPECT_EQ(high, low);
        for (const auto& n : normals) EXPECT_NEAR(n[2], 1, 1e-14);
    }
}

}  // namespace front_surface_test
}  // namespace batten
