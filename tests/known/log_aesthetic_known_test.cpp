#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "batten/make/log_aesthetic.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/log_aesthetic_space.hpp"
#include "shared_json.hpp"

namespace batten {
namespace log_aesthetic_known_test {

using Complex = std::complex<double>;

constexpr double degree = std::numbers::pi / 180;
constexpr const char* reference = "reference/log-aesthetic/g1_reference.json";

double number(const nlohmann::json& value) {
    return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

TEST(LogAestheticSegments, HaveTheNumbersOfTheReference) {
    SKIP_UNLESS_SHARED(reference);
    const auto segments = testing::shared_json(reference)["segments"];
    EXPECT_EQ(segments.size(), 12u);
    for (const auto& s : segments) {
        const auto arc =
            log_aesthetic_segment(number(s["alpha"]), 1, number(s["chord_angle_deg"]) * degree,
                                  number(s["theta_d_deg"]) * degree);
        ASSERT_TRUE(arc) << s["alpha"];
        const auto near = [&](double got, const nlohmann::json& wanted) {
            EXPECT_NEAR(got, number(wanted), 1e-13 * std::fmax(1, std::fabs(number(wanted))))
                << s["alpha"];
        };
        near(arc->log_radius_ratio(), s["r_log_radius_ratio"]);
        near(arc->length, s["length"]);
        near(arc->start_curvature, s["kappa0"]);
        near(arc->end_curvature, s["kappa1"]);
        const LogAestheticCurve curve(std::vector<double>{0, 0}, 0, *arc);
        near(curve.joints()(1, 0), s["P2"][0]);
        near(curve.joints()(1, 1), s["P2"][1]);
        const Jet jet = Curve(curve).jet(0.5 * arc->length, 2);
        near(jet[0][0], s["midlength_point"][0]);
        near(jet[0][1], s["midlength_point"][1]);
        near(std::atan2(jet[1][1], jet[1][0]), s["midlength_theta"]);
        near(jet[1][0] * jet[2][1] - jet[1][1] * jet[2][0], s["midlength_kappa"]);
    }
}

TEST(LogAestheticSegments, AreDrawableExactlyWithinTheReferenceLimits) {
    SKIP_UNLESS_SHARED(reference);
    const auto json = testing::shared_json(reference);
    EXPECT_EQ(json["drawable_limits"].size(), 70u);
    for (const auto& limit : json["drawable_limits"]) {
        const double alpha = number(limit["alpha"]), turn = number(limit["theta_d_deg"]) * degree;
        const double most = largest_chord_angle(alpha, turn);
        EXPECT_NEAR(most / degree, number(limit["phi_max_deg"]), 1e-11) << alpha;
        EXPECT_FALSE(log_aesthetic_segment(alpha, 1, most + 1e-9, turn)) << alpha;
        EXPECT_FALSE(log_aesthetic_segment(alpha, 1, turn - most - 1e-9, turn)) << alpha;
    }
    for (const auto& s : json["not_drawable"]) {
        EXPECT_FALSE(log_aesthetic_segment(number(s["alpha"]), 1,
                                           number(s["chord_angle_deg"]) * degree,
                                           number(s["theta_d_deg"]) * degree));
    }
}

/// The end of an arc from (0, 0) along x with rho = 1 at the start, by its lambda and turn.
Complex end_of(double alpha, double lambda, double turn) {
    const double z = (alpha - 1) * lambda * turn;
    const double ratio = alpha == 1 ? lambda * turn : std::log1p(z) / (alpha - 1);
    const double end_curvature = std::exp(-ratio);
    const double length = alpha == 0 ? ratio / lambda : std::expm1(alpha * ratio) / (alpha * lambda);
    const LogAestheticCurve curve(std::vector<double>{0, 0}, 0, {alpha, length, 1, end_curvature});
    EXPECT_NEAR(curve.segments()[0].turn(), turn, 4e-15);
    return {curve.joints()(1, 0), curve.joints()(1, 1)};
}

TEST(LogAestheticArcs, OfAlphaOneAreLogarithmicSpirals) {
    for (const double lambda : {-1.5, -0.2, 0.3, 2.0}) {
        const double turn = 1.3;
        const Complex wanted = (std::exp(Complex(lambda, 1) * turn) - 1.0) / Complex(lambda, 1);
        EXPECT_LT(std::abs(end_of(1, lambda, turn) - wanted), 1e-14 * std::abs(wanted));
    }
}

TEST(LogAestheticArcs, OfAlphaTwoAreCircleInvolutes) {
    for (const double lambda : {-0.4, 0.3, 2.0}) {
        const double turn = 1.7;
        const auto at = [&](double psi) {
            return std::polar(1.0, psi) * Complex(lambda, -(1 + lambda * psi));
        };
        const Complex wanted = at(turn) - at(0);
        EXPECT_LT(std::abs(end_of(2, lambda, turn) - wanted), 1e-14 * std::abs(wanted));
    }
}

/// int e^(i theta(s)) ds in extended precision by Simpson's rule.
template <class Angle>
Complex integral(double length, Angle angle) {
    const int steps = 20000;
    std::complex<long double> sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const long double weight = i == 0 || i == steps ? 1 : i % 2 ? 4 : 2;
        sum += weight * std::polar<long double>(1, angle((long double)(length)*i / steps));
    }
    sum *= (long double)(length) / (3 * steps);
    return {double(sum.real()), double(sum.imag())};
}

TEST(LogAestheticArcs, OfAlphaMinusOneAndZeroTurnAsTheirFormulasSay) {
    for (const double lambda : {-0.7, 0.25, 0.35}) {
        const double turn = 1.2;
        // kappa = 1 - lambda s
        const double s1 = (1 - std::sqrt(1 - 2 * lambda * turn)) / lambda;
        const Complex clothoid =
            integral(s1, [&](long double s) { return s - 0.5L * lambda * s * s; });
        EXPECT_LT(std::abs(end_of(-1, lambda, turn) - clothoid), 1e-14 * std::abs(clothoid));
        // rho = e^(lambda s)
        const double s0 = -std::log1p(-lambda * turn) / lambda;
        const Complex nielsen = integral(
            s0, [&](long double s) { return -std::expm1((long double)(-lambda) * s) / lambda; });
        EXPECT_LT(std::abs(end_of(0, lambda, turn) - nielsen), 1e-14 * std::abs(nielsen));
    }
}

TEST(LogAestheticSegments, OfIsoscelesTrianglesAreCircles) {
    for (const double alpha : {-3.0, -1.0, 0.0, 0.5, 1.0, 2.0}) {
        const auto made = log_aesthetic({{0, 0, 1, 0, 1, 1}, alpha});
        ASSERT_TRUE(made.report.drawable);
        EXPECT_NEAR(*made.report.length, std::numbers::pi / 2, 1e-14);
        EXPECT_NEAR((*made.report.curvatures)[0], 1, 1e-14);
        EXPECT_NEAR((*made.report.curvatures)[1], 1, 1e-14);
    }
}

TEST(LogAestheticSpaceCurves, EndWhereTheReferenceSays) {
    SKIP_UNLESS_SHARED(reference);
    const auto curves = testing::shared_json(reference)["space_curve_reference"];
    EXPECT_EQ(curves.size(), 4u);
    for (const auto& s : curves) {
        const auto of = [&](const char* key) { return s[key].get<double>(); };
        const LogAestheticSpaceCurve curve({of("alpha"), of("c"), of("d")},
                                           {of("beta"), of("g"), of("h")}, of("length"));
        const auto end = curve.motion(of("length"));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(end.point[k], s["P"][k].get<double>(), 2e-13);
            EXPECT_NEAR(end.tangent[k], s["T"][k].get<double>(), 2e-13);
            EXPECT_NEAR(end.normal[k], s["N"][k].get<double>(), 2e-13);
            EXPECT_NEAR(end.binormal[k], s["B"][k].get<double>(), 2e-13);
        }
    }
}

}  // namespace log_aesthetic_known_test
}  // namespace batten
