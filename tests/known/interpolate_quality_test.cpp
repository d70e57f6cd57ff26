#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "shared_json.hpp"

// The nine data sets of ../shared/reference/pseudo-spline/quality.json, four of them closed.
namespace batten {
namespace interpolate_quality_test {

constexpr const char* sets_file = "reference/pseudo-spline/quality_sets.json";
constexpr const char* totals_file = "reference/pseudo-spline/quality.json";

enum class By { tables, minimisation };

InterpolateReport by(Method method, const nlohmann::json& set, By how = By::tables) {
    Points points(2);
    for (const auto& row : set["points"]) points.push_back(row.get<std::vector<double>>());
    InterpolateOptions options;
    options.method = method;
    options.closed = set["closed"];
    options.exact = how == By::minimisation;
    return interpolate(points, options).report;
}

/// Calls check(set, totals) for every set whose totals by `method` are known.
template <class Check>
void for_all_sets(const std::string& method, Check&& check) {
    const nlohmann::json sets = testing::shared_json(sets_file);
    const nlohmann::json totals = testing::shared_json(totals_file);
    for (const auto& [name, set] : sets.items()) {
        if (!totals[name].contains(method)) continue;
        SCOPED_TRACE(name);
        check(set, totals[name][method]);
    }
}

void expect_totals(const InterpolateReport& report, const nlohmann::json& want, double error) {
    const auto expect = [&](const char* key, double found) {
        const double reference = want[key];
        EXPECT_NEAR(found, reference, error * reference) << key;
    };
    expect("pseudo_energy_sum_EiLi2", report.pseudo_energy.value());
    expect("total_E", report.bending_energy.value());
    expect("total_length", report.length);
    expect("scale_invariant_E_times_L", report.energy_length.value());
    expect("max_abs_curvature", report.max_curvature.value().value);
}

TEST(Interpolate, HasTheQualityOfTheReferenceOpenAndClosed) {
    SKIP_UNLESS_SHARED(sets_file);
    SKIP_UNLESS_SHARED(totals_file);
    for_all_sets("pseudo_spline", [](const nlohmann::json& set, const nlohmann::json& want) {
        expect_totals(by(Method::pseudo_spline, set, By::minimisation), want, 1e-11);
        expect_totals(by(Method::pseudo_spline, set, By::tables), want, 1e-8);
    });
    for_all_sets("hermite_B", [](const nlohmann::json& set, const nlohmann::json& want) {
        expect_totals(by(Method::hermite_arc, set), want, 1e-11);
    });
    for_all_sets("spline_B_chord", [](const nlohmann::json& set, const nlohmann::json& want) {
        expect_totals(by(Method::natural_chord, set), want, 1e-11);
    });
}

// Energy is flat at its minimum, so the reference's angles, good to 1e-7, show in the other totals.
TEST(Interpolate, HasTheQualityOfTheReferenceGlobally) {
    SKIP_UNLESS_SHARED(sets_file);
    SKIP_UNLESS_SHARED(totals_file);
    for_all_sets("pseudo_spline_global", [](const nlohmann::json& set, const nlohmann::json& want) {
        const InterpolateReport report = by(Method::pseudo_spline_global, set);
        EXPECT_EQ(report.status, Status::met);
        EXPECT_LE(report.pseudo_energy.value(),
                  want["pseudo_energy_sum_EiLi2"].get<double>() * (1 + 1e-10));
        expect_totals(report, want, 1e-6);
    });
}

// Uneven points of a unit circle: long chords dominate with the paper's weights.
TEST(Interpolate, CurvesUnevenPointsOfACircleMoreEvenlyWithANegativeWeightExponent) {
    SKIP_UNLESS_SHARED(sets_file);
    const nlohmann::json set = testing::shared_json(sets_file)["circle_irregular"];
    InterpolateOptions options;
    options.closed = true;
    Points points(2);
    for (const auto& row : set["points"]) points.push_back(row.get<std::vector<double>>());
    EXPECT_NEAR(interpolate(points, options).report.max_curvature.value().value, 5.404, 5e-4);
    options.weight_exponent = -1;
    EXPECT_NEAR(interpolate(points, options).report.max_curvature.value().value, 1.296, 5e-4);
}

}  // namespace interpolate_quality_test
}  // namespace batten
