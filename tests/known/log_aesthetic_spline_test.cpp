#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/make/interpolate.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "make/log_aesthetic/spline.hpp"
#include "shared_json.hpp"

namespace batten {
namespace log_aesthetic_spline_test {

constexpr const char* sets_file = "reference/pseudo-spline/quality_sets.json";
constexpr const char* quality_file = "reference/pseudo-spline/quality.json";

InterpolateOptions with_alpha(double alpha, bool closed = false) {
    InterpolateOptions options;
    options.method = Method::log_aesthetic;
    options.alpha = alpha;
    options.closed = closed;
    return options;
}

/// The largest jump of the curvature at an inner joint, times the shorter arc beside it.
double largest_jump(const LogAestheticCurve& curve) {
    const auto arcs = curve.segments();
    double jump = 0;
    for (std::size_t i = curve.is_closed() ? 0 : 1; i < arcs.size(); ++i) {
        const LogAestheticSegment &a = arcs[(i + arcs.size() - 1) % arcs.size()], &b = arcs[i];
        jump = std::fmax(jump, std::fabs(b.start_curvature - a.end_curvature) *
                                   std::fmin(a.length, b.length));
    }
    return jump;
}

TEST(LogAestheticSplines, OfAlphaMinusOneAreNearlyAsFairAsCanBe) {
    SKIP_UNLESS_SHARED(sets_file);
    SKIP_UNLESS_SHARED(quality_file);
    const auto sets = testing::shared_json(sets_file), quality = testing::shared_json(quality_file);
    int compared = 0;
    for (const auto& [name, set] : sets.items()) {
        Points points(0, 2);
        for (const auto& row : set["points"]) {
            points.push_back(std::vector<double>{row[0].get<double>(), row[1].get<double>()});
        }
        const bool closed = set["closed"].get<bool>();
        const Interpolation made = interpolate(points, with_alpha(-1, closed));
        EXPECT_EQ(made.report.status, Status::met) << name;
        EXPECT_LT(largest_jump(*made.curve.shape<LogAestheticCurve>()), 1e-9) << name;
        if (!quality[name].contains("si")) continue;
        const auto& best = quality[name]["si"];
        ++compared;
        EXPECT_LT(*made.report.energy_length, 1.01 * best["scale_invariant_E_times_L"].get<double>()) << name;
        EXPECT_LT(made.report.max_curvature->value, 1.15 * best["max_abs_curvature"].get<double>()) << name;
    }
    EXPECT_GE(compared, 7);
}

}  // namespace log_aesthetic_spline_test
}  // namespace batten
