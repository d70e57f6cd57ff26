#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/make/log_aesthetic.hpp"
#include "batten/measure/surface.hpp"
#include "errors.hpp"
#include "shared_json.hpp"

namespace batten {
namespace coons_test {

constexpr const char* reference = "reference/log-aesthetic/coons_reference.json";

/// A plane curve put up in the plane y = 0, scaled, turned and moved.
Curve upright(const Curve& flat, double scale, double turn, std::array<double, 3> shift) {
    const double c = scale * std::cos(turn), s = scale * std::sin(turn);
    const auto function = [=](double t, int order, std::span<double> out) {
        const Jet jet = flat.jet(t, order);
        for (int k = 0; k <= order; ++k) {
            const double x = jet[k][0], z = jet[k][1];
            const std::array<double, 3> row{c * x - s * z, 0, s * x + c * z};
            for (std::size_t i = 0; i < 3; ++i) {
                out[static_cast<std::size_t>(3 * k) + i] = row[i] + (k == 0 ? shift[i] : 0);
            }
        }
    };
    const auto breaks = flat.breaks();
    return CallableCurve{function, 3, {breaks.begin(), breaks.end()}, false};
}

Curve line(const std::vector<double>& from, const std::vector<double>& to) {
    const auto function = [=](double t, int order, std::span<double> out) {
        for (int k = 0; k <= order; ++k) {
            for (std::size_t i = 0; i < 3; ++i) {
                const double slope = to[i] - from[i];
                out[static_cast<std::size_t>(3 * k) + i] =
                    k == 0 ? from[i] + t * slope : k == 1 ? slope : 0;
            }
        }
    };
    return CallableCurve{function, 3, {0, 1}, false};
}

CoonsPatch ruled(const Curve& c0, const Curve& c1) {
    const double e0 = c0.domain().hi, e1 = c1.domain().hi;
    return {c0, c1, line(c0(0), c1(0)), line(c0(e0), c1(e1))};
}

Curve edge() {
    const double degree = std::numbers::pi / 180;
    const auto arc = log_aesthetic_segment(0.5, 1, 55 * degree, 90 * degree);
    return LogAestheticCurve(std::vector<double>{0, 0}, 0, *arc);
}

TEST(CoonsPatch, OfTranslatedEdgesIsACylinderAsInTheReference) {
    SKIP_UNLESS_SHARED(reference);
    const auto json = testing::shared_json(reference);
    const CoonsPatch patch =
        ruled(upright(edge(), 1, 0, {0, 0, 0}), upright(edge(), 1, 0, {0.2, 1, 0.3}));
    const Interval range = gaussian_range(patch);
    EXPECT_LT(std::fmax(-range.lo, range.hi), 1e-12);
    std::optional<double> zero;  // where angles begin is a matter of taste
    ZebraView view{{0.5, -6, 4}, {0, 0, 1}, 12};
    for (const auto& sample : json["zebra_angle_samples"]) {
        const SurfaceJet jet = patch.jet(sample["u"], sample["v"]);
        const auto bend = surface_bend(jet);
        ASSERT_TRUE(bend);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(jet.point[k], sample["S"][k].get<double>(), 1e-12);
            EXPECT_NEAR(bend->normal[k], sample["n"][k].get<double>(), 1e-12);
        }
        EXPECT_NEAR(bend->mean, sample["H"].get<double>(), 1e-11);
        const double ahead = *zebra_angle(jet, view) - sample["phi"].get<double>();
        if (!zero) zero = ahead;
        EXPECT_NEAR(std::remainder(ahead - *zero, 2 * std::numbers::pi), 0, 1e-12);
    }
}

TEST(CoonsPatch, OfOtherEdgesHasTheCurvatureOfTheReference) {
    SKIP_UNLESS_SHARED(reference);
    const auto json = testing::shared_json(reference);
    const CoonsPatch patch =
        ruled(upright(edge(), 1, 0, {0, 0, 0}), upright(edge(), 1.3, 0.4, {0, 1, 0}));
    const Interval range = gaussian_range(patch, 41);
    EXPECT_NEAR(range.lo, json["different_edges_K_range"][0].get<double>(), 1e-3);
    EXPECT_NEAR(range.hi, json["different_edges_K_range"][1].get<double>(), 1e-3);
}

TEST(CoonsPatch, HasTheDerivativesOfItsPoints) {
    const CoonsPatch patch =
        ruled(upright(edge(), 1, 0, {0, 0, 0}), upright(edge(), 1.3, 0.4, {0, 1, 0}));
    const double h = 1e-5, u = 0.3, v = 0.6;
    const SurfaceJet at = patch.jet(u, v), left = patch.jet(u - h, v), right = patch.jet(u + h, v),
                     low = patch.jet(u, v - h), high = patch.jet(u, v + h);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(at.u[k], (right.point[k] - left.point[k]) / (2 * h), 1e-8);
        EXPECT_NEAR(at.v[k], (high.point[k] - low.point[k]) / (2 * h), 1e-8);
        EXPECT_NEAR(at.uu[k], (right.u[k] - left.u[k]) / (2 * h), 1e-8);
        EXPECT_NEAR(at.uv[k], (high.u[k] - low.u[k]) / (2 * h), 1e-8);
        EXPECT_NEAR(at.vv[k], (high.v[k] - low.v[k]) / (2 * h), 1e-8);
    }
}

TEST(CoonsPatch, RefusesEdgesThatDoNotMeet) {
    const Curve c0 = upright(edge(), 1, 0, {0, 0, 0}), c1 = upright(edge(), 1, 0, {0, 1, 0});
    const Curve d0 = line(c0(0), c1(0)), d1 = line(c0(c0.domain().hi), c1(c1.domain().hi));
    EXPECT_NO_THROW(CoonsPatch(c0, c1, d0, d1));
    EXPECT_EQ(testing::code_of([&] { CoonsPatch(c0, c1, d1, d0); }), "coons.corners");
}

}  // namespace coons_test
}  // namespace batten
