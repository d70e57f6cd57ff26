#include "batten/make/densify.hpp"

#include <cmath>
#include <numbers>

#include "shared_json.hpp"

namespace batten {
namespace densify_test {

using testing::CsvTable;
using testing::shared_csv;
using testing::shared_json;

constexpr double pi = std::numbers::pi;

/// The paper's curves A, B, C with a = 2, b = 1 at n + 1 equal parameters.
Points example(const std::string& name, int n) {
    Points points(2);
    for (int i = 0; i <= n; ++i) {
        const double t = pi * i / n;
        const double x = name == "A" ? 2 * std::cos(t) : 4 / pi * t;
        points.push_back(std::vector{x, name == "C" ? std::cos(t) : std::sin(t)});
    }
    return points;
}

double theory(const std::string& name, double x) {
    if (name == "A") return std::sqrt(1 - x * x / 4);
    return name == "B" ? std::sin(pi / 4 * x) : std::cos(pi / 4 * x);
}

double fraction(const std::string& text) {
    const std::size_t bar = text.find('/');
    const double above = std::stod(text.substr(0, bar));
    return bar == std::string::npos ? above : above / std::stod(text.substr(bar + 1));
}

TEST(LagrangeWeights, AreThePapersTablesExactly) {
    // [Nakajima, eqs. 6, 8, 10, 12, 14], the last with its sign corrected.
    const std::vector<double> quarter = lagrange_weights(std::vector{0., 1., 2.}, 0.25);
    EXPECT_EQ(quarter, (std::vector{21 / 32., 14 / 32., -3 / 32.}));
    const std::vector<double> half = lagrange_weights(std::vector{-1., 0., 1.}, 0.5);
    EXPECT_EQ(half, (std::vector{-1 / 8., 6 / 8., 3 / 8.}));
    const std::vector<double> central = lagrange_weights(std::vector{-1., 0., 1., 2.}, 0.5);
    EXPECT_EQ(central, (std::vector{-1 / 16., 9 / 16., 9 / 16., -1 / 16.}));
    const std::vector<double> backward = lagrange_weights(std::vector{-2., -1., 0., 1.}, 0.5);
    EXPECT_EQ(backward, (std::vector{1 / 16., -5 / 16., 15 / 16., 5 / 16.}));
}

TEST(LagrangeWeights, AreTheReferenceTableExactly) {
    SKIP_UNLESS_SHARED("reference/lagrange/lagrange_weights.json");
    const nlohmann::json stencils = shared_json("reference/lagrange/lagrange_weights.json");
    int compared = 0;
    for (const auto& [name, stencil] : stencils.items()) {
        const std::vector<double> nodes = stencil["stencil_offsets"];
        for (const auto& [s, row] : stencil["weights"].items()) {
            const std::vector<double> weights = lagrange_weights(nodes, fraction(s));
            const double denominator = row["denominator"];
            for (std::size_t i = 0; i < weights.size(); ++i) {
                EXPECT_EQ(weights[i], row["numerators"][i].get<double>() / denominator) << name;
                ++compared;
            }
        }
    }
    EXPECT_EQ(compared, 2 * 3 * 3 + 3 * 3 * 4);
}

TEST(Densify, MakesThePapersErrors) {
    SKIP_UNLESS_SHARED("reference/lagrange/lagrange_errors.csv");
    const CsvTable table = shared_csv("reference/lagrange/lagrange_errors.csv");
    ASSERT_EQ(table.rows.size(), 180u);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string curve = table.text(row, "curve");
        const int n = static_cast<int>(table.number(row, "n"));
        DensifyOptions options;
        options.degree = static_cast<int>(table.number(row, "degree"));
        const Points points = densify(example(curve, n), options).points;
        ASSERT_EQ(points.size(), static_cast<std::size_t>(4 * n + 1));
        const double place = 4 * (table.number(row, "cell_k") + fraction(table.text(row, "s")));
        const std::size_t at = static_cast<std::size_t>(place);
        EXPECT_NEAR(points(at, 0), table.number(row, "x_interp"), 1e-14);
        EXPECT_NEAR(points(at, 1), table.number(row, "y_interp"), 1e-14);
        const double error = 100 * (points(at, 1) - theory(curve, points(at, 0)));
        EXPECT_NEAR(error, table.number(row, "error_rate_pct"), 1e-12);
    }
}

TEST(Densify, MakesTheExactRationalsOfTheGeneralCases) {
    SKIP_UNLESS_SHARED("reference/lagrange/lagrange_general.json");
    const nlohmann::json data = shared_json("reference/lagrange/lagrange_general.json");
    Points points(3);
    for (const auto& row : data["points"]) {
        points.push_back(std::vector{fraction(row[0]), fraction(row[1]), fraction(row[2])});
    }
    for (const auto& one : data["cases"]) {
        DensifyOptions options;
        options.degree = one["degree"];
        options.closed = one["kind"] == "closed";
        options.keep_spikes = true;
        options.between = 9;
        for (const auto& t : data["parameters"]) options.parameter_values.push_back(fraction(t));
        if (options.closed) options.parameter_values.push_back(12);
        const Densified result = densify(points, options);
        const double s = fraction(one["s"]);
        const std::size_t cell = one["cell"];
        const double lo = result.curve.breaks()[cell], hi = result.curve.breaks()[cell + 1];
        const std::vector<double> value = result.curve(lo + s * (hi - lo));
        const std::size_t row = 10 * cell + static_cast<std::size_t>(std::lround(10 * s));
        for (int k = 0; k < 3; ++k) {
            const double exact = fraction(one["value"][static_cast<std::size_t>(k)]);
            const double rounding = 1e-13 * std::max(1.0, std::fabs(exact));
            EXPECT_NEAR(value[static_cast<std::size_t>(k)], exact, rounding);
            EXPECT_NEAR(result.points(row, k), exact, rounding);
        }
    }
}

TEST(Densify, ReportsTheTangentJumpsOfThePapersCurves) {
    SKIP_UNLESS_SHARED("reference/lagrange/lagrange_tangent_jumps.json");
    const nlohmann::json data = shared_json("reference/lagrange/lagrange_tangent_jumps.json");
    for (const auto& [name, jumps] : data.items()) {
        DensifyOptions options;
        options.degree = name.back() - '0';
        const Points points = example(name.substr(0, 1), name[3] - '0');
        const DensifyReport report = densify(points, options).report;
        ASSERT_EQ(report.tangent_jumps.size(), jumps.size()) << name;
        for (std::size_t i = 0; i < jumps.size(); ++i) {
            EXPECT_NEAR(report.tangent_jumps[i] * 180 / pi, jumps[i].get<double>(), 1e-12) << name;
        }
    }
}

TEST(Densify, KeepsThePapersEllipseInsideOnlyBeyondAFewHundredths) {
    // x of the cubic through 2 cos(0), 2 cos(pi/6), ... exceeds a = 2 for s < 0.0901207.
    const Curve curve = densify(example("A", 6), {}).curve;
    EXPECT_GT(curve(0.0901)[0], 2);
    EXPECT_LT(curve(0.0902)[0], 2);
    const Curve coarse = densify(example("A", 4), {}).curve;
    EXPECT_GT(coarse(0.1290)[0], 2);
    EXPECT_LT(coarse(0.1291)[0], 2);
}

TEST(Densify, WithAQuadraticEndHalvesTheErrorOfTheEllipsesEnds) {
    DensifyOptions options;
    options.end_degree = 2;
    const Points points = densify(example("A", 6), options).points;
    const auto error = [&](std::size_t i) { return points(i, 1) - theory("A", points(i, 0)); };
    EXPECT_NEAR(100 * error(1), -1.52141276273145, 1e-11);   // the quadratic's, end cell
    EXPECT_NEAR(100 * error(6), -0.243289044711627, 1e-11);  // the cubic's, cell 1
}

TEST(Densify, OfTheAerofoilIsAsFarOffAsTheReferenceForEveryParameter) {
    SKIP_UNLESS_SHARED("reference/lagrange/aerofoil_reference.json");
    const nlohmann::json data = shared_json("reference/lagrange/aerofoil_reference.json");
    const double mx = data["parameters"]["mu"][0], my = data["parameters"]["mu"][1];
    const double radius = data["parameters"]["R"], chord = data["aerofoil_whole_n10"]["chord"];
    const auto distance_sq = [&](double phi, double x, double y) {
        const double zx = mx + radius * std::cos(phi), zy = my + radius * std::sin(phi);
        const double norm = zx * zx + zy * zy;
        const double dx = zx + zx / norm - x, dy = zy - zy / norm - y;
        return dx * dx + dy * dy;
    };
    // To the whole contour, as the reference measured: at the trailing edge the other surface is
    // the nearer one (to its own, the upper surface by index is 0.01664 % off).
    const auto distance = [&](double x, double y) {
        double best = 1e9, phi = 0;
        for (int i = 0; i < 7200; ++i) {
            const double d = distance_sq(i * pi / 3600, x, y);
            if (d < best) {
                best = d;
                phi = i * pi / 3600;
            }
        }
        for (double step = pi / 7200; step > 1e-9; step /= 2) {
            for (const double other : {phi - step, phi + step}) {
                if (distance_sq(other, x, y) < distance_sq(phi, x, y)) phi = other;
            }
        }
        return std::sqrt(distance_sq(phi, x, y));
    };
    const std::vector<std::pair<std::string, LagrangeParameter>> parameters{
        {"uniform_index", LagrangeParameter::index},
        {"chord", LagrangeParameter::chord},
        {"centripetal", LagrangeParameter::centripetal}};
    for (const std::string side : {"aerofoil_upper", "aerofoil_lower"}) {
        Points points(2);
        for (const auto& row : data[side]["points"]) {
            points.push_back(row.get<std::vector<double>>());
        }
        for (const auto& [name, parameter] : parameters) {
            DensifyOptions options;
            options.parameter = parameter;
            const Points dense = densify(points, options).points;
            double largest = 0;
            for (std::size_t i = 0; i < dense.size(); ++i) {
                largest = std::max(largest, distance(dense(i, 0), dense(i, 1)));
            }
            const double expected = data[side]["errors"][name]["max_pct_chord"];
            EXPECT_NEAR(100 * largest / chord, expected, 1e-8) << side << ' ' << name;
        }
    }
}

TEST(Densify, ReportsTheLargestDistanceFromTheChords) {
    // On the parabola y = x^2 sampled at integers, degree 2 is exact: in the direction across the
    // chord of a step h the curve is h^2 / 4 / sqrt(1 + slope^2) off, most at the bottom.
    Points points(2);
    for (int i = -3; i <= 3; ++i) points.push_back(std::vector{1.0 * i, 1.0 * i * i});
    DensifyOptions options;
    options.degree = 2;
    options.between = 3;
    const Densified result = densify(points, options);
    const double h = 0.25, slope = 0.25;
    EXPECT_NEAR(result.report.max_chord_error, h * h / 4 / std::sqrt(1 + slope * slope), 1e-9);
    EXPECT_EQ(result.report.points_in, 7u);
    EXPECT_EQ(result.report.points_out, 25u);
    EXPECT_NEAR(result.report.max_tangent_jump, 0, 1e-15);
}

}  // namespace densify_test
}  // namespace batten
