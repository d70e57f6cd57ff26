#include "batten/make/arcs.hpp"

#include <cmath>
#include <numbers>

#include "shared_json.hpp"

namespace batten {
namespace arcs_test {

using testing::CsvTable;
using testing::shared_csv;
using testing::shared_json;

constexpr double pi = std::numbers::pi;

/// The paper's curves A, B, C with a = 2, b = 1, and their derivatives.
struct Example {
    std::string name;

    double value(double t, int order, int coordinate) const {
        const double sine = std::sin(t + order * pi / 2), cosine = std::cos(t + order * pi / 2);
        if (coordinate == 1) return name == "C" ? cosine : sine;
        if (name == "A") return 2 * cosine;
        return order == 0 ? 4 / pi * t : order == 1 ? 4 / pi : 0;
    }
    /// Over [0, pi], with breaks at n equal parts.
    Curve curve(int n) const {
        CallableCurve result;
        for (int i = 0; i <= n; ++i) result.joints.push_back(pi * i / n);
        result.function = [self = *this](double t, int order, std::span<double> out) {
            for (int k = 0; k <= order; ++k) {
                out[static_cast<std::size_t>(2 * k)] = self.value(t, k, 0);
                out[static_cast<std::size_t>(2 * k + 1)] = self.value(t, k, 1);
            }
        };
        return result;
    }
    Points points(int n) const {
        Points result(2);
        for (int i = 0; i <= n; ++i) {
            result.push_back(std::vector{value(pi * i / n, 0, 0), value(pi * i / n, 0, 1)});
        }
        return result;
    }
    Angle start() const { return {std::atan2(value(0, 1, 1), value(0, 1, 0))}; }
    /// 100 (y - theory(x)) / b.
    double error(double x, double y) const {
        if (name == "A") return 100 * (y - std::sqrt(1 - x * x / 4));
        return 100 * (y - (name == "B" ? std::sin(pi / 4 * x) : std::cos(pi / 4 * x)));
    }
    /// To the curve continued beyond [0, pi].
    double distance(double x, double y) const {
        const auto d = [&](double t) { return std::hypot(value(t, 0, 0) - x, value(t, 0, 1) - y); };
        double best = -0.5;
        for (double t = -0.5; t < 3.7; t += 0.001) {
            if (d(t) < d(best)) best = t;
        }
        for (double step = 0.0005; step > 1e-10; step /= 2) {
            if (d(best - step) < d(best)) best -= step;
            if (d(best + step) < d(best)) best += step;
        }
        return d(best);
    }
};

/// Row after row of the reference against the place at that share of the cell's length.
void expect_reference_rows(const CsvTable& table, const std::string& method) {
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.text(row, "method") != method) continue;
        const Example example{table.text(row, "curve")};
        const int n = static_cast<int>(table.number(row, "n"));
        ArcFit fit = arcs(example.curve(n), {});
        std::size_t each = 2;
        if (method == "chain") {
            ArcsOptions options;
            options.start_angle = example.start();
            fit = arcs(example.points(n), options);
            each = 1;
        }
        const std::size_t cell = static_cast<std::size_t>(table.number(row, "cell"));
        ASSERT_EQ(fit.chain.arcs(), each * static_cast<std::size_t>(n));
        const double share = table.number(row, "s(angle or length fraction)");
        const double lo = fit.chain.breaks()[each * cell];
        const double hi = fit.chain.breaks()[each * cell + each];
        const std::vector<double> p = Curve(fit.chain)(lo + share * (hi - lo));
        EXPECT_NEAR(p[0], table.number(row, "x"), 1e-13);
        EXPECT_NEAR(p[1], table.number(row, "y"), 1e-13);
        EXPECT_NEAR(example.error(p[0], p[1]), table.number(row, "error_rate_pct"), 1e-10);
        EXPECT_NEAR(100 * example.distance(p[0], p[1]),
                    table.number(row, "normal_distance_pct_of_b"), 1e-10);
        const Arc first = fit.chain.arc(each * cell), last = fit.chain.arc(each * cell + each - 1);
        EXPECT_NEAR(first.curvature(), table.number(row, "kappa_or_kappaA"), 1e-12);
        const double second = method == "chain" ? last.sweep() * 180 / pi : last.curvature();
        EXPECT_NEAR(second, table.number(row, "turn_deg_or_kappaB"), 1e-12);
    }
}

TEST(ArcChain, MakesThePapersErrors) {
    SKIP_UNLESS_SHARED("reference/lagrange/arc_chain_errors.csv");
    const CsvTable table = shared_csv("reference/lagrange/arc_chain_errors.csv");
    ASSERT_EQ(table.rows.size(), 180u);
    expect_reference_rows(table, "chain");
}

TEST(Biarcs, MakeTheReferencesErrors) {
    SKIP_UNLESS_SHARED("reference/lagrange/arc_chain_errors.csv");
    expect_reference_rows(shared_csv("reference/lagrange/arc_chain_errors.csv"), "biarc");
}

double largest_error(const Example& example, const ArcChain& chain) {
    double largest = 0;
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        const double lo = chain.breaks()[i], hi = chain.breaks()[i + 1];
        for (const double share : {0.25, 0.5, 0.75}) {
            const std::vector<double> p = Curve(chain)(lo + share * (hi - lo));
            largest = std::max(largest, std::fabs(example.error(p[0], p[1])));
        }
    }
    return largest;
}

double curvature_difference_sum(const ArcChain& chain) {
    double sum = 0;
    for (std::size_t i = 1; i < chain.arcs(); ++i) {
        const double step = chain.arc(i).curvature() - chain.arc(i - 1).curvature();
        sum += step * step;
    }
    return sum;
}

TEST(ArcChain, HasThePapersErrorsForTheExactStartTangent) {
    const std::vector<std::pair<const char*, double>> expected{
        {"A", 4.17434082424447}, {"B", 0.431718005524673}, {"C", 0.215064955442969}};
    for (const auto& [name, error] : expected) {
        const Example example{name};
        ArcsOptions options;
        options.start_angle = example.start();
        const ArcFit fit = arcs(example.points(6), options);
        EXPECT_NEAR(largest_error(example, fit.chain), error, 1e-10) << name;
    }
}

TEST(ArcChain, ZigzagsAroundTheEllipsesCurvature) {
    ArcsOptions options;
    options.start_angle = Angle{pi / 2};
    const ArcFit fit = arcs(Example{"A"}.points(6), options);
    const std::vector<double> radii{0.600480947, 3.328889618, 2.451942577,
                                    8.534838771, 1.526927905, 0.841312613};
    ASSERT_EQ(fit.report.arc.size(), radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i) {
        EXPECT_NEAR(*fit.report.arc[i].radius, radii[i], 1e-9);
    }
    const std::array<double, 2> end = fit.chain.arc(5).end_tangent();
    EXPECT_NEAR(std::fabs(std::atan2(end[0], -end[1])) * 180 / pi, 8.48438558665, 1e-10);
}

TEST(ArcChain, StartsByDefaultWhereTheCurvatureChangesLeast) {
    struct Row {
        const char* name;
        double offset, error, sum;
    };
    const std::vector<Row> rows{
        {"A", 4.242192793299886, 1.6913826333186222, 1.9054245258152942},
        {"B", 0.782672751182256, 0.2150649554437889, 0.255863422100816},
        {"C", -0.9631197977753594, 0.39914980422832147, 0.24786873408301915}};
    for (const Row& row : rows) {
        const Example example{row.name};
        const ArcFit fit = arcs(example.points(6), {});
        const std::array<double, 2> t = fit.chain.arc(0).start_tangent();
        const double offset = (std::atan2(t[1], t[0]) - example.start().radians) * 180 / pi;
        // The reference searched for its minimum: it is known to the root of a double's accuracy.
        EXPECT_NEAR(offset, row.offset, 1e-6) << row.name;
        EXPECT_NEAR(largest_error(example, fit.chain), row.error, 1e-7) << row.name;
        EXPECT_NEAR(curvature_difference_sum(fit.chain), row.sum, 1e-12) << row.name;
    }
}

TEST(ArcChain, TakesTheStartsNormalEitherWayRound) {
    const Example example{"C"};  // the paper's slope of the normal is infinite here
    ArcsOptions by_angle, by_normal;
    by_angle.start_angle = Angle{0};
    for (const double normal : {pi / 2, -pi / 2}) {
        by_normal.start_normal = Angle{normal};
        const ArcChain a = arcs(example.points(6), by_angle).chain;
        const ArcChain b = arcs(example.points(6), by_normal).chain;
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(a.bulges()[i], b.bulges()[i], 1e-15);
    }
}

TEST(ArcChain, ThroughPointsOfACircleIsTheCircle) {
    Points points(2);
    for (const double t : {0.1, 0.5, 1.4, 2.0, 2.2}) {
        points.push_back(std::vector{3 + 5 * std::cos(t), 1 + 5 * std::sin(t)});
    }
    for (const ArcRecord& arc : arcs(points, {}).report.arc) {
        EXPECT_NEAR(*arc.radius, 5, 1e-12);
        EXPECT_NEAR((*arc.center)[0], 3, 1e-12);
        EXPECT_NEAR((*arc.center)[1], 1, 1e-12);
    }
}

TEST(ArcChain, FlagsArcsOfMoreThanHalfACircle) {
    ArcsOptions options;
    options.start_angle = Angle{0.75 * pi};
    const ArcFit fit = arcs(Points({0, 0, 1, 0}, 2), options);
    ASSERT_EQ(fit.report.major_arcs, std::vector<std::size_t>{0});
    EXPECT_NEAR(fit.report.arc[0].sweep, -1.5 * pi, 1e-14);
    EXPECT_NEAR(*fit.report.arc[0].radius, std::sqrt(0.5), 1e-15);
}

TEST(ArcChain, ClosesAnOddPolygon) {
    Points points(2);
    for (int i = 0; i < 7; ++i) {
        const double t = 2 * pi * i / 7, r = 1 + 0.05 * std::cos(2 * t);
        points.push_back(std::vector{r * std::cos(t), r * std::sin(t)});
    }
    ArcsOptions options;
    options.closed = true;
    options.method = ArcMethod::chain;
    const ArcFit fit = arcs(points, options);
    EXPECT_EQ(fit.report.status, Status::met);
    EXPECT_EQ(fit.chain.arcs(), 7u);
    EXPECT_TRUE(fit.chain.is_closed());
    EXPECT_LT(fit.report.max_tangent_jump, 1e-14);
}

TEST(ArcChain, GivesWayToBiarcsAndSaysSoWhereAnEvenPolygonDoesNotClose) {
    const Points points({0, 0, 3, 0, 3, 1, 1, 1.5}, 2);
    ArcsOptions options;
    options.closed = true;
    options.method = ArcMethod::chain;
    const ArcFit fit = arcs(points, options);
    EXPECT_EQ(fit.report.status, Status::not_met);
    EXPECT_EQ(fit.chain.arcs(), 8u);
    EXPECT_LT(fit.report.max_tangent_jump, 1e-14);
    ASSERT_EQ(fit.report.notes.size(), 1u);
    EXPECT_NE(fit.report.notes[0].find("no tangent chain closes"), std::string::npos);
    // A square closes by chance: its circle.
    const ArcFit square = arcs(Points({0, 0, 1, 0, 1, 1, 0, 1}, 2), options);
    EXPECT_EQ(square.report.status, Status::met);
    for (const ArcRecord& arc : square.report.arc) {
        EXPECT_NEAR(*arc.radius, std::sqrt(0.5), 1e-15);
    }
}

TEST(Biarcs, HaveTheReferencesErrors) {
    const std::vector<std::tuple<const char*, int, double>> expected{
        {"A", 6, 0.284911194125228}, {"B", 6, 0.0544200954253733}, {"C", 6, 0.0544200954253733},
        {"A", 4, 1.41865672367645},  {"B", 4, 0.189759},           {"C", 4, 0.189759}};
    for (const auto& [name, n, error] : expected) {
        const Example example{name};
        const ArcFit fit = arcs(example.curve(n), {});
        double largest = 0;
        for (std::size_t i = 0; i < fit.chain.arcs(); i += 2) {
            const double lo = fit.chain.breaks()[i], hi = fit.chain.breaks()[i + 2];
            for (const double share : {0.25, 0.5, 0.75}) {
                const std::vector<double> p = Curve(fit.chain)(lo + share * (hi - lo));
                largest = std::max(largest, std::fabs(example.error(p[0], p[1])));
            }
        }
        EXPECT_NEAR(largest, error, n == 4 && *name != 'A' ? 1e-6 : 1e-10) << name << n;
    }
}

TEST(Biarcs, OfTheSpecialPairsAreWhatGeometrySays) {
    ArcsOptions options;
    options.tangent = {{0, {0}}, {1, {0}}};
    const ArcFit s_shape = arcs(Points({0, 0, 2, 2}, 2), options);  // two quarters of circles
    ASSERT_EQ(s_shape.chain.arcs(), 2u);
    EXPECT_NEAR(s_shape.report.arc[0].sweep, pi / 2, 1e-15);
    EXPECT_NEAR(s_shape.report.arc[1].sweep, -pi / 2, 1e-15);
    EXPECT_NEAR(*s_shape.report.arc[0].radius, 1, 1e-15);
    options.tangent = {{0, {pi / 2}}, {1, {-pi / 2}}};
    const ArcFit half = arcs(Points({0, 0, 2, 0}, 2), options);  // one arc is enough
    ASSERT_EQ(half.chain.arcs(), 1u);
    EXPECT_NEAR(half.report.arc[0].sweep, -pi, 1e-15);
    options.tangent = {{0, {0.3}}, {1, {0.3}}};
    const Points along({0, 0, std::cos(0.3), std::sin(0.3)}, 2);
    EXPECT_EQ(arcs(along, options).report.lines, 1u);
}

TEST(Biarcs, OfACircleInOnePieceAreItsHalves) {
    CallableCurve circle;
    circle.joints = {0, 2 * pi};
    circle.closed = true;
    circle.function = [](double t, int order, std::span<double> out) {
        for (int k = 0; k <= order; ++k) {
            out[static_cast<std::size_t>(2 * k)] = std::cos(t + k * pi / 2);
            out[static_cast<std::size_t>(2 * k + 1)] = std::sin(t + k * pi / 2);
        }
    };
    const ArcFit fit = arcs(circle, {});
    EXPECT_EQ(fit.report.arcs, 2u);  // each half is one arc
    EXPECT_LT(fit.report.max_error, 1e-15);
    EXPECT_TRUE(fit.chain.is_closed());
    ArcsOptions options;
    options.tolerance = absolute(10);  // larger than the circle
    EXPECT_EQ(arcs(circle, options).report.arcs, 2u);
}

TEST(Arcs, BecomeLinesBeyondTheLargestRadius) {
    Points circle(2);
    for (int i = 0; i <= 3; ++i) {
        circle.push_back(std::vector{1000 * std::cos(0.1 * i), 1000 * std::sin(0.1 * i)});
    }
    ArcsOptions options;
    options.max_radius = 1001;
    EXPECT_EQ(arcs(circle, options).report.arcs, 3u);
    options.max_radius = 999;
    const ArcFit lines = arcs(circle, options);
    EXPECT_EQ(lines.report.lines, 3u);
    EXPECT_NEAR(lines.report.max_tangent_jump, 0.1, 1e-12);
    EXPECT_EQ(arcs(Points({0, 0, 1, 1, 3, 3, 4, 4}, 2), {}).report.lines, 3u);
    // Within a tolerance the lines must be, too: the sagitta of a chord c is c^2 / 8000.
    options.tolerance = absolute(0.1);
    const ArcFit within = arcs(Example{"C"}.curve(1), options);
    EXPECT_LE(within.report.max_error, 0.1);
}

TEST(Arcs, SkipRepeatedPointsAndSaySo) {
    const ArcFit fit = arcs(Points({0, 0, 0, 0, 1, 1, 1, 1, 2, 0}, 2), {});
    EXPECT_EQ(fit.chain.arcs(), 2u);
    ASSERT_EQ(fit.report.notes.size(), 1u);
    EXPECT_EQ(fit.report.notes[0], "points equal to the one before skipped: 2");
}

TEST(Arcs, WithinAToleranceMakeTwoHalvesOfACircle) {
    Points points(2);
    for (int i = 0; i < 60; ++i) {
        points.push_back(std::vector{std::cos(pi * i / 30), std::sin(pi * i / 30)});
    }
    ArcsOptions options;
    options.closed = true;
    options.tolerance = absolute(1e-9);
    const ArcFit fit = arcs(points, options);
    EXPECT_EQ(fit.report.arcs, 2u);
    EXPECT_LT(fit.report.max_error, 1e-14);
    for (const ArcRecord& arc : fit.report.arc) EXPECT_NEAR(arc.sweep, pi, 1e-12);
}

TEST(Arcs, WithinAToleranceFollowTheReferencesGreedyCounts) {
    const std::vector<std::tuple<const char*, double, std::size_t>> expected{
        {"A", 1e-2, 8}, {"A", 1e-3, 14}, {"A", 1e-4, 28}, {"A", 1e-5, 56},
        {"B", 1e-2, 6}, {"B", 1e-3, 10}, {"B", 1e-4, 20}, {"B", 1e-5, 42}};
    for (const auto& [name, tolerance, count] : expected) {
        ArcsOptions options;
        options.tolerance = absolute(tolerance);
        const ArcFit fit = arcs(Example{name}.curve(1), options);
        EXPECT_LE(fit.chain.arcs(), count + 2) << name << tolerance;
        EXPECT_LE(fit.report.max_error, tolerance);
    }
}

TEST(Arcs, SayThatAToleranceBelowRoundingIsNotMet) {
    ArcsOptions options;
    options.tolerance = relative(1e-15);
    const ArcFit fit = arcs(Example{"B"}.curve(1), options);
    EXPECT_EQ(fit.report.status, Status::not_met);
    EXPECT_LT(fit.report.max_error, 1e-12);
    ASSERT_EQ(fit.report.notes.size(), 1u);
    EXPECT_EQ(fit.report.notes[0].substr(0, 10), "tolerance:");
}

}  // namespace arcs_test
}  // namespace batten
