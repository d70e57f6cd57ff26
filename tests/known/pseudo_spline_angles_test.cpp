#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "make/pseudo/free_end.hpp"
#include "make/pseudo/global/angles.hpp"
#include "make/pseudo/local_angles.hpp"
#include "make/pseudo/segment/angles.hpp"
#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/three_point.hpp"
#include "shared_json.hpp"

namespace batten::pseudo {
namespace pseudo_spline_angles_test {

using testing::shared_csv;
using testing::shared_json;

constexpr double degree = std::numbers::pi / 180;
constexpr const char* examples = "reference/pseudo-spline/examples.json";

/// Sums over a curve's spans.
struct Totals {
    double pseudo_energy = 0;
    double energy = 0;
    double length = 0;
};

Totals totals(const std::vector<SpanAngles>& spans) {
    Totals sum;
    for (const SpanAngles& span : spans) {
        const Minimum m = least_minimum(span.theta0, span.theta1);
        sum.pseudo_energy += span.length * m.pseudo_energy;
        sum.energy += m.energy / span.length;
        sum.length += span.length * m.length;
    }
    return sum;
}

Points points_of(const nlohmann::json& set) {
    const std::vector<double> x = set.at("x"), y = set.at("y");
    Points points(x.size(), 2);
    for (std::size_t i = 0; i < x.size(); ++i) {
        points(i, 0) = x[i];
        points(i, 1) = y[i];
    }
    return points;
}

/// The largest difference to the tangents listed, modulo 2 pi.
double tangent_error(const std::vector<SpanAngles>& spans, const std::vector<double>& tangents) {
    double error = 0;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        error = std::max(error, std::fabs(wrap(spans[i].start_tangent() - tangents[i])));
        error = std::max(error, std::fabs(wrap(spans[i].end_tangent() - tangents[i + 1])));
    }
    return error;
}

Points table_2() { return Points({0, 0, 2, -0.1, 1, -0.1, 3, 0}, 2); }

double near(double value) { return std::max(1e-12, 1e-9 * value); }

TEST(FreeEnd, HasTheEnergyAndAngleStatedInTheSpecification) {
    EXPECT_NEAR(free_end(180 * degree).pseudo_energy, 44.5696076797, 1e-9);
    EXPECT_NEAR(free_end(180 * degree).segment.theta1, -35.5211537494 * degree, 1e-11);
    EXPECT_NEAR(free_end(51 * degree).segment.theta1, -25.66657998198 * degree, 1e-11);
    EXPECT_NEAR(free_end(50 * degree).segment.theta1, -22.93254274024 * degree, 1e-11);
    const double theta = 1e-3;  // the series of section 3b
    EXPECT_NEAR(free_end(theta).pseudo_energy / (3 * theta * theta), 1 + 17.0 / 210 * 1e-6, 1e-12);
    EXPECT_NEAR(free_end(theta).segment.theta1 / theta, -0.5 + 2.0 / 35 * 1e-6, 1e-12);
}

TEST(FreeEnd, FollowsTheReferenceTable) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/jtheta.csv");
    const auto table = shared_csv("reference/pseudo-spline/jtheta.csv");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double theta = table.number(i, "theta_deg");
        const FreeEnd end = free_end(theta * degree);
        const double j = table.number(i, "J");
        EXPECT_NEAR(end.pseudo_energy, j, 1e-12 * j) << theta;
        EXPECT_NEAR(end.segment.theta1 / degree, table.number(i, "theta1_deg"), 1e-9) << theta;
        EXPECT_NEAR(end.segment.r0, table.number(i, "r0"), 1e-9) << theta;
        EXPECT_NEAR(end.segment.r1, table.number(i, "r1"), 1e-9) << theta;
    }
}

TEST(ThreePointRule, FollowsTheReferenceTable) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/threepoint.csv");
    const auto table = shared_csv("reference/pseudo-spline/threepoint.csv");
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const double turn = table.number(i, "turn_deg");
        const double length1 = table.number(i, "l1");
        const ThreePoints points{turn * degree, table.number(i, "l0"), length1};
        const ThreePointAngle found = three_point_angle(points, 1);
        const double w = table.number(i, "w");
        // This row was made before its table's pocket was found; ours is lower.
        const bool is_stale = turn == 150 && length1 == 0.5;
        if (is_stale) {
            EXPECT_LT(found.energy, w * (1 - 7e-6));
            EXPECT_NEAR(found.angle / degree, table.number(i, "psi_deg_rel_first_chord"), 0.03);
            continue;
        }
        const double side = turn == 180 ? -1 : 1;  // an exact fold-back is a tie
        EXPECT_NEAR(side * found.angle / degree, table.number(i, "psi_deg_rel_first_chord"), 2e-10)
            << turn << ' ' << length1;
        EXPECT_NEAR(found.energy, w, 5e-12 * w) << turn << ' ' << length1;
        const auto rival = three_point_rival(points, 1);
        ASSERT_EQ(rival.has_value(), table.text(i, "second_w") != "nan") << turn << ' ' << length1;
        if (!rival) continue;
        EXPECT_NEAR(side * rival->angle / degree, table.number(i, "second_psi_deg"), 1e-8);
        EXPECT_NEAR(rival->energy, table.number(i, "second_w"), 1e-9 * rival->energy);
    }
}

TEST(ThreePointRule, TakesTheBisectorOfEqualChords) {
    for (const double turn : {1e-6, 0.3, 102 * degree, 2.0, 3.1}) {
        EXPECT_EQ(three_point_angle({turn, 2.5, 2.5}, 1).angle, turn / 2);
    }
}

TEST(LocalAngles, OfTable2MakeTheOpenLoop) {
    const std::vector<SpanAngles> spans = local_angles(table_2(), {});
    EXPECT_LT(tangent_error(spans, {0.491886477784624, -1.219559578302065, 1.219559578302065,
                                    -0.491886477784624}),
              1e-11);
    EXPECT_NEAR(totals(spans).length, 6.141998559222, 1e-11);
    EXPECT_NEAR(totals(spans).pseudo_energy, 46.8507275212, 1e-9);
}

TEST(LocalAngles, AreThoseOfTheReferenceExamples) {
    SKIP_UNLESS_SHARED(examples);
    const auto sets = shared_json(examples);
    EXPECT_EQ(sets.size(), 7u);
    for (const auto& [name, set] : sets.items()) {
        const auto& reference = set.at("methods").at("pseudo_spline");
        const std::vector<SpanAngles> spans = local_angles(points_of(set), {});
        EXPECT_LT(tangent_error(spans, reference.at("tangent_angle_rad")), 1e-8) << name;
        const Totals sum = totals(spans);
        const double pseudo_energy = reference.at("pseudo_energy_sum_EiLi2");
        const double energy = reference.at("total_E");
        const double length = reference.at("total_length");
        EXPECT_NEAR(sum.pseudo_energy, pseudo_energy, near(pseudo_energy)) << name;
        EXPECT_NEAR(sum.energy, energy, near(energy)) << name;
        EXPECT_NEAR(sum.length, length, near(length)) << name;
    }
}

TEST(LocalAngles, OfOtherWeightExponentsAreThoseOfTheReference) {
    SKIP_UNLESS_SHARED("reference/pseudo-spline/quality.json");
    const auto quality = shared_json("reference/pseudo-spline/quality.json");
    const auto sets = shared_json("reference/pseudo-spline/quality_sets.json");
    const std::string names[] = {"weight_l^-1", "weight_l^0", "pseudo_spline"};
    for (const auto& [name, set] : sets.items()) {
        for (int exponent = -1; exponent <= 1; ++exponent) {
            // With equal weights the reference leaves the bisector at one point of the ellipse,
            // whose turn is near 102 degrees.
            if (name == "ellipse3to1_8" && exponent == 0) continue;
            const auto& entry = quality.at(name);
            const std::string& key = names[exponent + 1];
            if (!entry.contains(key)) continue;
            AngleRules rules;
            rules.is_closed = set.at("closed");
            rules.weight_exponent = exponent;
            Points points(0, 2);
            for (const std::vector<double> point : set.at("points")) points.push_back(point);
            const Totals sum = totals(local_angles(points, rules));
            const double energy = entry.at(key).at("total_E");
            const double length = entry.at(key).at("total_length");
            EXPECT_NEAR(sum.energy, energy, 1e-9 * energy) << name << ' ' << exponent;
            EXPECT_NEAR(sum.length, length, 1e-9 * length) << name << ' ' << exponent;
        }
    }
}

TEST(GlobalAngles, OfTable2AreLowerThanTheLocalOnes) {
    const GlobalSpline spline = global_angles(table_2(), {});
    EXPECT_EQ(spline.status, GlobalStatus::converged);
    EXPECT_NEAR(spline.energy, 45.517360447351, 1e-10);
    EXPECT_LT(spline.gradient, 1e-12);
    const std::vector<double> tangents{0.53463262, -1.36577388, 1.36577388, -0.53463262};
    EXPECT_LT(tangent_error(spline.spans, tangents), 1e-7);
}

TEST(GlobalAngles, AreAsLowAsTheReferenceExamples) {
    SKIP_UNLESS_SHARED(examples);
    const auto sets = shared_json(examples);
    for (const auto& [name, set] : sets.items()) {
        const auto& reference = set.at("methods").at("pseudo_spline_global");
        const GlobalSpline spline = global_angles(points_of(set), {});
        EXPECT_EQ(spline.status, GlobalStatus::converged) << name;
        const double energy = reference.at("pseudo_energy_sum_EiLi2");
        EXPECT_LE(spline.energy, energy * (1 + 1e-10)) << name;
        EXPECT_NEAR(totals(spline.spans).pseudo_energy, spline.energy, 1e-12 * energy) << name;
        // The minimum of Table 1, y = 5, is lopsided: its mirror image is as good.
        std::vector<double> tangents = reference.at("tangent_angle_rad");
        const double error = tangent_error(spline.spans, tangents);
        std::reverse(tangents.begin(), tangents.end());
        for (double& angle : tangents) angle = -angle;
        EXPECT_LT(std::min(error, tangent_error(spline.spans, tangents)), 1e-6) << name;
    }
}

}  // namespace pseudo_spline_angles_test
}  // namespace batten::pseudo
