#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "shared_json.hpp"

// The seven data sets of ../shared/reference/pseudo-spline/examples.json, by six methods.
namespace batten {
namespace interpolate_examples_test {

constexpr const char* examples = "reference/pseudo-spline/examples.json";

Points points_of(const nlohmann::json& set) {
    Points points(set["x"].size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points(i, 0) = set["x"][i];
        points(i, 1) = set["y"][i];
    }
    return points;
}

Interpolation by(Method method, const Points& points) {
    InterpolateOptions options;
    options.method = method;
    return interpolate(points, options);
}

/// Calls check(set name, points, reference) for every data set.
template <class Check>
void for_all_sets(const std::string& method, Check&& check) {
    const nlohmann::json sets = testing::shared_json(examples);
    ASSERT_EQ(sets.size(), 7u);
    for (const auto& [name, set] : sets.items()) {
        SCOPED_TRACE(name);
        check(points_of(set), set["methods"][method]);
    }
}

/// The worst error as multiples of size 1: P0, P1, T0, T1 of every span, T = dP/du, u = 0 ... 1.
void expect_segments(const Curve& curve, const nlohmann::json& segments, double error) {
    ASSERT_EQ(curve.pieces(), segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const Interval piece = curve.piece(i);
        const Jet start = curve.jet_on(i, piece.lo, 1), end = curve.jet_on(i, piece.hi, 1);
        const double h = piece.length();
        const double found[] = {start[0][0],     start[0][1],     end[0][0],     end[0][1],
                                h * start[1][0], h * start[1][1], h * end[1][0], h * end[1][1]};
        for (std::size_t k = 0; k < 8; ++k) {
            ASSERT_NEAR(found[k], segments[i][k], error) << "span " << i << ", number " << k;
        }
    }
}

void expect_angles(const InterpolateReport& report, const nlohmann::json& want, double error) {
    ASSERT_TRUE(report.tangent_angles);
    ASSERT_EQ(report.tangent_angles->size(), want.size());
    for (std::size_t i = 0; i < want.size(); ++i) {
        const double turn = (*report.tangent_angles)[i] - want[i].get<double>();
        EXPECT_NEAR(std::remainder(turn, 2 * std::numbers::pi), 0, error) << "point " << i;
    }
}

/// Totals to 1e-9 relative or 1e-12 absolute, with the reference's own last digits allowed for.
void expect_totals(const InterpolateReport& report, const nlohmann::json& want) {
    const std::map<std::string, double> found{
        {"pseudo_energy_sum_EiLi2", report.pseudo_energy.value()},
        {"total_E", report.bending_energy.value()},
        {"total_length", report.length},
        {"scale_invariant_E_times_L", report.energy_length.value()},
        {"max_abs_curvature", report.max_curvature.value().value}};
    for (const auto& [key, value] : found) {
        const double reference = want[key];
        EXPECT_NEAR(value, reference, std::max(1e-9 * reference, 1e-12)) << key;
    }
}

TEST(Interpolate, GivesTheNaturalSplinesOfTheExamples) {
    SKIP_UNLESS_SHARED(examples);
    for_all_sets("spline_A_uniform", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::natural_uniform, points);
        expect_segments(made.curve, want["segments_hermite"], 1e-12);
        expect_totals(made.report, want);
    });
    for_all_sets("spline_B_chord", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::natural_chord, points);
        expect_segments(made.curve, want["segments_hermite"], 1e-12);
        expect_totals(made.report, want);
    });
}

TEST(Interpolate, GivesTheHermiteCurvesOfTheExamples) {
    SKIP_UNLESS_SHARED(examples);
    for_all_sets("hermite_A", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::hermite_chord, points);
        expect_segments(made.curve, want["segments_hermite"], 1e-14);
        expect_angles(made.report, want["tangent_angle_rad"], 1e-14);
        expect_totals(made.report, want);
    });
    for_all_sets("hermite_B", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::hermite_arc, points);
        expect_segments(made.curve, want["segments_hermite"], 1e-14);
        expect_angles(made.report, want["tangent_angle_rad"], 1e-14);
        expect_totals(made.report, want);
    });
}

TEST(Interpolate, GivesThePseudoSplinesOfTheExamples) {
    SKIP_UNLESS_SHARED(examples);
    for_all_sets("pseudo_spline", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::pseudo_spline, points);
        expect_angles(made.report, want["tangent_angle_rad"], 1e-8);
        expect_totals(made.report, want);
    });
}

// Only y = 5 of Table 1 is not symmetric: its mirror image is as good.
TEST(Interpolate, GivesTheGlobalPseudoSplinesOfTheExamples) {
    SKIP_UNLESS_SHARED(examples);
    for_all_sets("pseudo_spline_global", [](const Points& points, const nlohmann::json& want) {
        const Interpolation made = by(Method::pseudo_spline_global, points);
        const double reference = want["pseudo_energy_sum_EiLi2"];
        EXPECT_EQ(made.report.status, Status::met);
        EXPECT_LE(made.report.pseudo_energy.value(), reference * (1 + 1e-10) + 1e-12);
        nlohmann::json angles = want["tangent_angle_rad"];
        const std::vector<double>& found = made.report.tangent_angles.value();
        if (std::fabs(found[0] - angles[0].get<double>()) > 1e-6) {  // the mirror image, x to -x
            std::reverse(angles.begin(), angles.end());
            for (auto& angle : angles) angle = -angle.get<double>();
        }
        expect_angles(made.report, angles, 1e-6);
    });
}

// Figures of the paper's Table 1 with y = 1, restated: this test needs no other file.
TEST(Interpolate, GivesTheBumpOfTableOne) {
    const Points points({-4, 0, -3, 0, -2, 0, -1, 0, 0, 1, 1, 0, 2, 0, 3, 0, 4, 0}, 2);
    struct Row {
        Method method;
        double pseudo_energy, bending_energy, length, max_curvature;
    };
    for (const Row& row :
         {Row{Method::natural_uniform, 13.5558780632, 8.0147, 8.991498918, 4.3918},
          Row{Method::natural_chord, 16.5770619039, 8.8242, 8.919152803, 6.1224},
          Row{Method::hermite_chord, 13.2530149551, 7.0700, 8.953734200, 2.6237},
          Row{Method::hermite_arc, 15.0462094602, 7.4185, 8.949084670, 2.8332},
          Row{Method::pseudo_spline, 13.2449038447, 7.0000, 8.964693932, 2.4035}}) {
        const InterpolateReport report = by(row.method, points).report;
        EXPECT_NEAR(report.pseudo_energy.value(), row.pseudo_energy, 1e-10);
        EXPECT_NEAR(report.bending_energy.value(), row.bending_energy, 5e-5);
        EXPECT_NEAR(report.length, row.length, 5e-10);
        EXPECT_NEAR(report.max_curvature.value().value, row.max_curvature, 5e-5);
        EXPECT_NEAR(report.energy_length.value(), row.bending_energy * row.length, 5e-4);
    }
}

TEST(Interpolate, ByArcsHasTheTangentsOfACircle) {
    Points points(7, 2);
    const double angles[] = {0, 0.3, 0.8, 2, 3, 3.5, 5};
    for (std::size_t i = 0; i < 7; ++i) {
        points(i, 0) = std::cos(angles[i]);
        points(i, 1) = std::sin(angles[i]);
    }
    InterpolateOptions options;
    options.method = Method::hermite_arc;
    for (const bool closed : {false, true}) {
        options.closed = closed;
        const Interpolation made = interpolate(points, options);
        for (std::size_t i = 0; i < 7; ++i) {
            const double turn = (*made.report.tangent_angles)[i] - angles[i];
            EXPECT_NEAR(std::remainder(turn - std::numbers::pi / 2, 2 * std::numbers::pi), 0,
                        4e-15);
        }
    }
}

TEST(Interpolate, TellsBothTangentsOfACorner) {
    InterpolateOptions options;
    options.method = Method::hermite_chord;
    options.corner = {1};
    const Interpolation made = interpolate(Points({0, 0, 1, 0, 1, 1}, 2), options);
    EXPECT_EQ(*made.report.tangent_angles,
              (std::vector<double>{0, std::numbers::pi / 2, std::numbers::pi / 2}));
    EXPECT_EQ(*made.report.tangent_angles_in, (std::vector<double>{0, 0, std::numbers::pi / 2}));
    EXPECT_EQ(made.report.length, 2);
    EXPECT_EQ(made.report.area, 0.5);
    EXPECT_EQ(made.report.bending_energy, 0);
    EXPECT_EQ(made.report.max_curvature.value().value, 0);
}

TEST(Interpolate, LeavesARepeatedFirstPointOutAndSaysSo) {
    InterpolateOptions options;
    options.closed = true;
    const Points square({0, 0, 1, 0, 1, 1, 0, 1}, 2);
    Points repeated(square);
    repeated.push_back(square[0]);
    const Interpolation plain = interpolate(square, options);
    const Interpolation noted = interpolate(repeated, options);
    EXPECT_EQ(noted.report.length, plain.report.length);
    EXPECT_TRUE(plain.report.notes.empty());
    EXPECT_EQ(noted.report.notes, (std::vector<std::string>{"point 4 repeats point 0 of the closed "
                                                            "curve and is left out"}));
}

TEST(Interpolate, HasNoAreaAndNoAnglesInSpace) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    const Interpolation made =
        interpolate(Points({0, 0, 0, 1, 0, 1, 1, 1, 0, 0, 1, 1}, 3), options);
    EXPECT_EQ(made.report.area, std::nullopt);
    EXPECT_EQ(made.report.tangent_angles, std::nullopt);
    EXPECT_EQ(made.report.notes.size(), 1u);
    EXPECT_GT(made.report.bending_energy.value(), 0);
}

}  // namespace interpolate_examples_test
}  // namespace batten
