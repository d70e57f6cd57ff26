#include "batten/base/error.hpp"
#include "batten/make/fit_front.hpp"
#include "surface_samples.hpp"

/// Surfaces with a front along a curve.
namespace batten {
namespace fit_front_test {

using namespace testing;

constexpr const char* scintillator = "reference/fitting/scintillator_like.csv";

double front_of(double y) { return 0.22 + 0.5 * y + 0.07 * std::sin(2 * std::numbers::pi * y); }

/// Two slanted plains and a front of half-width w between them.
double plains(double x, double y, double w) {
    return 0.4 + 0.2 * std::sin(2 * x) * (1 - 0.5 * y) +
           (0.9 + 0.2 * y - 0.3 * x) * 0.5 * (1 - std::tanh((x - front_of(y)) / w));
}

/// What scintillator_like.csv was made with.
double scintillator_truth(double x, double y) {
    const double hill =
        0.9 * std::exp(-((x - 0.45) * (x - 0.45) / 0.18 + (y - 0.6) * (y - 0.6) / 0.35));
    const double step = 0.5 * (1 + std::tanh((front_of(y) - x) / 0.006));
    return (0.25 + hill) * step * (1 + 0.15 * std::sin(3 * x)) +
           0.12 * std::exp(-3 * (x - 0.2) * (x - 0.2)) * (0.4 + 0.6 * y) + 0.02;
}

/// Root mean square distance over 500 x 40 places between the nodes.
template <class Truth>
double distance_between(const CurvedKnotSurface& surface, Truth truth) {
    double sum = 0;
    for (int i = 0; i < 500; ++i) {
        for (int j = 0; j < 40; ++j) {
            const double x = (i + 0.5) / 500, y = (j + 0.5) / 40;
            const double e = surface(x, y) - truth(x, y);
            sum += e * e / (500 * 40);
        }
    }
    return std::sqrt(sum);
}

struct Trial {
    FrontFit fit;
    double noise_sigma2 = 0;  ///< what the truth leaves of the same data
    double distance = 0;      ///< rms to the truth between the nodes
};

Trial trial(double w, double sigma) {
    const auto truth = [w](double x, double y) { return plains(x, y, w); };
    const SurfaceTable table = surface_of(truth, 156, 21, sigma, 4);
    FitFrontOptions options;
    options.sigma = sigma;
    Trial result{fit_front(table.view(), options)};
    for (std::size_t i = 0; i < 156; ++i) {
        for (std::size_t j = 0; j < 21; ++j) {
            const double e = (table.z(i, j) - truth(table.x[i], table.y[j])) / sigma;
            result.noise_sigma2 += e * e / (156 * 21);
        }
    }
    result.distance = distance_between(result.fit.surface, truth);
    return result;
}

/// What the report says beside the numbers of parameters, worked out anew.
void expect_the_rest(const FrontReport& r, const CurvedKnotSurface& surface,
                     const SurfaceTable& table) {
    constexpr double sigma = 0.01;
    double delta2 = 0, within = 0, largest = 0;
    const double n = static_cast<double>(table.x.size() * table.y.size());
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        for (std::size_t j = 0; j < table.y.size(); ++j) {
            const double e = std::fabs(table.z(i, j) - surface(table.x[i], table.y[j]));
            delta2 += e * e / sigma / sigma;
            within += e <= sigma;
            largest = std::max(largest, e);
        }
    }
    EXPECT_NEAR(r.delta2, delta2, 1e-9 * delta2);
    EXPECT_NEAR(r.psi.at(0), within / n, 1e-12);
    EXPECT_NEAR(r.max_residual, largest, 1e-12);
    EXPECT_NEAR(r.aic, n * std::log(delta2) + 2 * r.parameters, 1e-6);
    EXPECT_NEAR(*r.chi2_p, chi2_survival(delta2, n - r.parameters), 1e-9);
    EXPECT_EQ(static_cast<double>(r.samples), n);
    EXPECT_EQ(r.sigma, sigma);
    EXPECT_EQ(r.breaks_x, (std::vector{table.x.front(), table.x.back()}));
    EXPECT_EQ(static_cast<int>(r.breaks_y.size()), r.intervals[1] + 1);
    ASSERT_FALSE(r.path.empty());
    double least = r.path[0].bic;
    for (const SurfaceStep& step : r.path) least = std::min(least, step.bic);
    EXPECT_EQ(least, r.bic);
    EXPECT_GT(r.separability.additive, 0.1);
}

TEST(Front, NeedsEightyParametersWhereATensorProductNeedsThousands) {
    SKIP_UNLESS_SHARED(scintillator);
    const SurfaceTable table = surface_table("scintillator_like");
    FitFrontOptions options;
    options.sigma = 0.01;
    const FrontFit made = fit_front(table.view(), options);
    const FrontReport& r = made.report;
    EXPECT_LE(r.sigma2, 1.15);
    EXPECT_LE(r.parameters_charged, 80);
    EXPECT_TRUE(r.has_front);
    EXPECT_LE(distance_between(made.surface, scintillator_truth), 0.005);
    EXPECT_LT(r.bic, *r.tensor_bic / 2);
    expect_the_rest(r, made.surface, table);
}

TEST(Front, IsTrueBetweenTheNodesUnderNoise) {
    const Trial noisy = trial(0.006, 0.03), loud = trial(0.006, 0.1);
    EXPECT_LE(noisy.distance, 0.008);
    EXPECT_LE(loud.distance, 0.018);
    EXPECT_LE(noisy.fit.report.sigma2, noisy.noise_sigma2 + 0.1);
    EXPECT_LE(loud.fit.report.sigma2, loud.noise_sigma2 + 0.1);
}

TEST(Front, ThatIsNearlyAJumpLeavesWhatTheTruthLeaves) {
    const Trial steep = trial(0.0005, 0.01);
    EXPECT_LE(steep.fit.report.sigma2, steep.noise_sigma2 + 0.04);
    EXPECT_EQ(steep.fit.report.notes.size(), 1u);  // narrower than a cell
}

TEST(Front, ThatIsAJumpIsDeclaredOne) {
    const Trial jump = trial(1e-9, 0.01);
    const FrontReport& r = jump.fit.report;
    EXPECT_TRUE(r.is_jump);
    EXPECT_LE(r.sigma2, jump.noise_sigma2 + 0.04);
    // Four lines lie together, and the surface falls there by what the truth falls.
    for (const double y : {0.1, 0.5, 0.9}) {
        std::vector<double> places;
        for (const SplineFunction& line : jump.fit.surface.x_lines()) places.push_back(line(y));
        std::size_t first = 0;
        while (first + 3 < places.size() && places[first + 3] - places[first] > 1e-12) ++first;
        ASSERT_LT(first + 3, places.size());
        const double x = places[first];
        EXPECT_NEAR(x, front_of(y), 1.0 / 155);
        EXPECT_NEAR(jump.fit.surface(x - 1e-9, y) - jump.fit.surface(x + 1e-9, y),
                    0.9 + 0.2 * y - 0.3 * x, 0.03);
    }
}

TEST(Front, MayHaveAnotherBesideIt) {
    const auto truth = [](double x, double y) {
        const double rise = std::tanh((x - 0.15 - 0.25 * y) / 0.01);
        const double fall = std::tanh((x - 0.62 - 0.2 * y + 0.06 * std::sin(3 * y)) / 0.01);
        return 0.2 * std::sin(2 * x) + (0.45 + 0.1 * y) * rise - (0.35 - 0.1 * y) * fall;
    };
    const SurfaceTable table = surface_of(truth, 100, 17, 0.02, 4);
    FitFrontOptions options;
    options.sigma = 0.02;
    const FrontFit made = fit_front(table.view(), options);
    EXPECT_TRUE(made.report.has_front);
    EXPECT_EQ(made.report.fronts, 2);
    EXPECT_LE(made.report.sigma2, 1.15);
    EXPECT_LE(distance_between(made.surface, truth), 0.007);
}

TEST(Front, MayDieOutOnItsWay) {
    const auto truth = [](double x, double y) {
        const double share = std::max(0.0, 0.7 - y) / 0.7;
        return 0.2 * std::sin(2 * x) +
               share * share * 0.5 * (1 - std::tanh((x - front_of(y)) / 0.01));
    };
    const SurfaceTable table = surface_of(truth, 100, 17, 0.02, 4);
    FitFrontOptions options;
    options.sigma = 0.02;
    const FrontFit made = fit_front(table.view(), options);
    EXPECT_TRUE(made.report.has_front);
    EXPECT_LE(made.report.sigma2, 1.15);
    EXPECT_LE(distance_between(made.surface, truth), 0.007);
}

TEST(Front, ThatIsClosedIsLeftToTheTensorProduct) {
    const auto island = [](double x, double y) {
        return 0.8 * std::tanh((0.28 - std::hypot(x - 0.5, y - 0.5)) / 0.03);
    };
    const SurfaceTable table = surface_of(island, 45, 45, 0.02, 4);
    FitFrontOptions options;
    options.sigma = 0.02;
    EXPECT_FALSE(fit_front(table.view(), options).report.has_front);
}

TEST(Front, MayRunInEitherDirection) {
    const auto lying = [](double x, double y) { return plains(y, x, 0.01); };
    const SurfaceTable table = surface_of(lying, 25, 90, 0.02, 6);
    FitFrontOptions options;
    options.sigma = 0.02;
    const FrontFit made = fit_front(table.view(), options);
    EXPECT_TRUE(made.report.has_front);
    EXPECT_EQ(made.report.front, FrontRuns::across_columns);
    EXPECT_LE(made.report.sigma2, 1.15);
    double sum = 0;
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const double x = (i + 0.5) / 100, y = (j + 0.5) / 100;
            sum += std::pow(made.surface(x, y) - lying(x, y), 2) / 1e4;
        }
    }
    EXPECT_LE(std::sqrt(sum), 0.01);
}

TEST(Front, TakesLinesThatAreGiven) {
    const auto truth = [](double x, double y) { return plains(x, y, 0.02); };
    const SurfaceTable table = surface_of(truth, 120, 21, 0.01, 5);
    Points rows(0, 8);
    for (int k = 0; k <= 12; ++k) {
        const double y = k / 12.0, phi = front_of(y);
        rows.push_back(std::array{y, phi - 0.08, phi - 0.03, phi - 0.012, phi, phi + 0.012,
                                  phi + 0.03, phi + 0.08});
    }
    const std::vector<SplineFunction> lines = lines_through(rows);
    ASSERT_EQ(lines.size(), 7u);
    for (const double y : {0.1, 0.33, 0.8}) EXPECT_NEAR(lines[3](y), front_of(y), 2e-4);
    const LinesFit made = fit_with_lines(table.view(), lines, 3, 0.01);
    EXPECT_EQ(made.report.parameters_charged, made.report.parameters);
    EXPECT_EQ(made.report.parameters, 11 * 6);
    EXPECT_LE(made.report.sigma2, 1.2);
    rows(3, 2) = 0.99;
    EXPECT_THROW(fit_with_lines(table.view(), lines_through(rows), 3, 0.01), Error);
    Points constants(0, 3);
    constants.push_back(std::array{0.0, 0.4, 0.6});
    EXPECT_THROW(lines_through(constants), Error);
}

TEST(Front, IsNotSeenWhereThereIsNone) {
    const auto hills = [](double x, double y) {
        return std::exp(-20 * (x - 0.4) * (x - 0.4)) + std::sin(3 * y) * x;
    };
    for (const std::uint64_t seed : {1, 2, 3}) {
        const SurfaceTable table = surface_of(hills, 61, 25, 0.02, seed);
        FitFrontOptions options;
        options.sigma = 0.02;
        EXPECT_FALSE(fit_front(table.view(), options).report.has_front);
    }
}

}  // namespace fit_front_test
}  // namespace batten
