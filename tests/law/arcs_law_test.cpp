#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "batten/make/arcs.hpp"
#include "shared.hpp"

namespace batten {
namespace arcs_law_test {

constexpr double pi = std::numbers::pi;

/// A smooth wandering row of points.
Points wandering(unsigned seed, std::size_t n) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> turn(-0.4, 0.4), step(0.5, 1.5);
    Points points(0, 2);
    double x = 0, y = 0, angle = turn(random);
    for (std::size_t i = 0; i < n; ++i) {
        points.push_back(std::vector{x, y});
        angle += turn(random);
        const double length = step(random);
        x += length * std::cos(angle);
        y += length * std::sin(angle);
    }
    return points;
}

Curve figure_eight() {
    CallableCurve curve;
    curve.joints = {0, 2 * pi};
    curve.closed = true;
    curve.function = [](double t, int order, std::span<double> out) {
        for (int k = 0; k <= order; ++k) {
            const std::size_t at = static_cast<std::size_t>(2 * k);
            out[at] = 3 * std::sin(t + k * pi / 2);
            out[at + 1] = std::pow(2.0, k) * std::sin(2 * t + k * pi / 2);
        }
    };
    return curve;
}

/// Every way of making arcs, over many inputs.
void for_each_fit(const std::function<void(const ArcFit&)>& visit) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Points points = wandering(seed, 20);
        for (const bool closed : {false, true}) {
            for (const int way : {0, 1, 2}) {
                ArcsOptions options;
                options.closed = closed;
                if (way == 1) options.method = ArcMethod::biarc;
                if (way == 2) options.tolerance = relative(0.02);
                visit(arcs(points, options));
            }
        }
    }
    for (const double tolerance : {0.1, 1e-3}) {
        ArcsOptions options;
        options.tolerance = absolute(tolerance);
        visit(arcs(figure_eight(), options));
    }
}

TEST(ArcsLaw, JointsAreSharedBitForBitAndTangentsAreJoined) {
    int smooth = 0;
    for_each_fit([&](const ArcFit& fit) {
        const auto& arc = fit.report.arc;
        for (std::size_t i = 0; i + 1 < arc.size(); ++i) EXPECT_EQ(arc[i].end, arc[i + 1].start);
        if (fit.chain.is_closed()) {
            EXPECT_EQ(arc.back().end, arc.front().start);
        }
        EXPECT_EQ(fit.report.arcs + fit.report.lines, arc.size());
        const auto& notes = fit.report.notes;
        if (!notes.empty() && notes[0].find("lines instead") != std::string::npos) return;
        EXPECT_LT(fit.report.max_tangent_jump, 1e-8);
        ++smooth;
    });
    EXPECT_GT(smooth, 180);
}

TEST(ArcsLaw, EveryRadiusIsTheDistanceOfBothEndsFromTheCentre) {
    for_each_fit([&](const ArcFit& fit) {
        for (const ArcRecord& arc : fit.report.arc) {
            if (!arc.radius) continue;
            for (const auto& p : {arc.start, arc.end}) {
                const double r = std::hypot(p[0] - (*arc.center)[0], p[1] - (*arc.center)[1]);
                EXPECT_NEAR(r, *arc.radius, 1e-9 * (1 + *arc.radius));
            }
        }
    });
}

TEST(ArcsLaw, AChainPassesThroughAllPoints) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Points points = wandering(seed, 15);
        const ArcFit fit = arcs(points, {});
        if (fit.chain.arcs() != 14) continue;
        EXPECT_EQ(fit.chain.joints(), points);
    }
}

TEST(ArcsLaw, PointsTimesAPowerOfTwoGiveExactlyThat) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        for (const bool closed : {false, true}) {
            for (const int way : {0, 1, 2}) {
                for (const int power : {3, -20, 700, -700}) {
                    const Points points = wandering(seed, 12);
                    Points larger = points;
                    for (double& x : larger.coordinates()) x = std::ldexp(x, power);
                    ArcsOptions options;
                    options.closed = closed;
                    if (way == 1) options.method = ArcMethod::biarc;
                    if (way == 2) options.tolerance = relative(0.02);
                    const ArcFit a = arcs(points, options), b = arcs(larger, options);
                    ASSERT_EQ(a.chain.arcs(), b.chain.arcs());
                    EXPECT_EQ(a.report.max_tangent_jump, b.report.max_tangent_jump);
                    EXPECT_EQ(std::ldexp(a.report.max_error, power), b.report.max_error);
                    for (std::size_t i = 0; i < a.chain.arcs(); ++i) {
                        ASSERT_EQ(a.chain.bulges()[i], b.chain.bulges()[i]) << seed << ' ' << way;
                        ASSERT_EQ(std::ldexp(a.chain.joints()(i, 0), power),
                                  b.chain.joints()(i, 0));
                    }
                }
            }
        }
    }
}

TEST(ArcsLaw, AnErrorOfTheStartsAngleReachesEveryJointUndiminished) {
    const Points points = wandering(3, 12);
    ArcsOptions options;
    options.start_angle = Angle{0.1};
    const ArcChain a = arcs(points, options).chain;
    options.start_angle = Angle{0.1 + pi / 180};
    const ArcChain b = arcs(points, options).chain;
    for (std::size_t i = 0; i < a.arcs(); ++i) {
        const auto s = a.arc(i).start_tangent(), t = b.arc(i).start_tangent();
        const double turn = std::atan2(s[0] * t[1] - s[1] * t[0], s[0] * t[0] + s[1] * t[1]);
        EXPECT_NEAR(turn, (i % 2 == 0 ? 1 : -1) * pi / 180, 1e-12);
    }
}

TEST(ArcsLaw, NoTurnOfTheDefaultStartMakesTheCurvatureChangeLess) {
    const auto sum = [](const ArcChain& chain) {
        double total = 0;
        for (std::size_t i = 1; i < chain.arcs(); ++i) {
            total += std::pow(chain.arc(i).curvature() - chain.arc(i - 1).curvature(), 2);
        }
        return total;
    };
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Points points = wandering(seed, 10);
        ArcsOptions options;
        options.method = ArcMethod::chain;
        const ArcChain best = arcs(points, options).chain;
        const auto t = best.arc(0).start_tangent();
        for (int i = 0; i < 72; ++i) {
            options.start_angle = Angle{std::atan2(t[1], t[0]) + i * pi / 36};
            EXPECT_LE(sum(best), sum(arcs(points, options).chain) * (1 + 1e-12));
        }
    }
}

TEST(ArcsLaw, ReversedPointsGiveTheReversedArcs) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Points points = wandering(seed, 13);
        Points back(0, 2);
        for (std::size_t i = points.size(); i-- > 0;) back.push_back(points.view()[i]);
        for (const ArcMethod method : {ArcMethod::chain, ArcMethod::biarc}) {
            ArcsOptions options;
            options.method = method;
            const ArcChain a = arcs(points, options).chain, b = arcs(back, options).chain;
            ASSERT_EQ(a.arcs(), b.arcs());
            for (std::size_t i = 0; i < a.arcs(); ++i) {
                EXPECT_NEAR(a.bulges()[i], -b.bulges()[a.arcs() - 1 - i], 1e-9);
            }
        }
    }
}

TEST(ArcsLaw, WithinAToleranceThereAreNeverMoreMovesThanChords) {
    std::size_t chains = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        const Points points = wandering(seed, 30);
        for (const double tolerance : {1.0, 0.1, 1e-2, 1e-4, 1e-8}) {
            for (const bool closed : {false, true}) {
                ArcsOptions options;
                options.tolerance = absolute(tolerance);
                options.closed = closed;
                const ArcFit fit = arcs(points, options);
                EXPECT_LE(fit.chain.arcs(), closed ? 30u : 29u);
                EXPECT_LE(fit.report.max_error, tolerance);
                EXPECT_EQ(fit.report.status, Status::met);
                chains += fit.report.notes.empty() ? 0 : 1;
            }
        }
    }
    EXPECT_GT(chains, 10u);
}

}  // namespace arcs_law_test
}  // namespace batten
