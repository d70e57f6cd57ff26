#include "shared_json.hpp"
#include "surface_samples.hpp"

/// Surfaces against the reference made by dense QR.
namespace batten {
namespace fit_surface_test {

using nlohmann::json;
using namespace testing;

constexpr const char* surface_json = "reference/fitting/surface_reference.json";
constexpr const char* missing_json = "reference/fitting/missing_reference.json";

FitSurfaceOptions with_unit_sigma() {
    FitSurfaceOptions options;
    options.sigma = 1;
    return options;
}

TEST(FittedSurface, GivesTheNumbersOfTheReferenceWithEqualStrips) {
    SKIP_UNLESS_SHARED(surface_json);
    const json want = shared_json(surface_json)["equal"]["kprog1"];
    FitSurfaceOptions options = with_unit_sigma();
    options.knots = SurfaceKnots::equal;
    options.intervals = {12, 10};
    const SurfaceFit made = fit_surface(surface_table("surface_equal").view(), options);
    const FitSurfaceReport& r = made.report;
    double sum = 0;
    for (const double c : made.surface.coefficients()) sum += c;
    EXPECT_NEAR(r.delta2, want["delta2"].get<double>(), 1e-9 * r.delta2);
    EXPECT_NEAR(*r.sigma2, want["sigma2"].get<double>(), 1e-9);
    EXPECT_NEAR(r.aic, want["aic"].get<double>(), 1e-7);
    EXPECT_NEAR(sum, want["coef_sum"].get<double>(), 1e-7);
    EXPECT_NEAR(made.surface.coefficient(0, 0), want["coef00"].get<double>(), 1e-9);
    EXPECT_NEAR(made.surface.coefficient(5, 5), want["coef_5_5"].get<double>(), 1e-9);
    EXPECT_EQ(r.parameters, 15 * 13);
    EXPECT_EQ(r.status, Status::met);
}

/// The reference's path entry by entry: strips, delta2, sigma2, aic, psi_1 to psi_4 to 4 digits.
void expect_path(const SurfaceFit& made, const json& want) {
    const std::vector<SurfaceStep>& path = made.report.path;
    const json& history = want["hist"];
    ASSERT_EQ(path.size(), history.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(path[i].intervals[0], history[i][0].get<int>());
        EXPECT_EQ(path[i].intervals[1], history[i][1].get<int>());
        EXPECT_NEAR(path[i].delta2, history[i][2].get<double>(), 1e-9 * path[i].delta2);
        EXPECT_NEAR(*path[i].sigma2, history[i][3].get<double>(), 1e-9 * *path[i].sigma2);
        EXPECT_NEAR(path[i].aic, history[i][4].get<double>(), 1e-9 * path[i].aic);
        for (std::size_t w = 0; w < 4; ++w) {
            EXPECT_NEAR(path[i].psi[w], history[i][5][w].get<double>(), 0.51e-4);
        }
    }
    EXPECT_EQ(made.report.breaks_x, want["bx"].get<std::vector<double>>());
    EXPECT_EQ(made.report.breaks_y, want["by"].get<std::vector<double>>());
}

TEST(FittedSurface, PutsLinesInTheOrderOfTheReferenceForBothRules) {
    SKIP_UNLESS_SHARED(surface_json);
    const json reference = shared_json(surface_json)["equal"];
    const SurfaceTable table = surface_table("surface_equal");
    FitSurfaceOptions options = with_unit_sigma();
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.95, 0.99};
    options.rule = StripRule::marginal;
    expect_path(fit_surface(table.view(), options), reference["kprog2_paper"]);
    options.rule = StripRule::projected;
    expect_path(fit_surface(table.view(), options), reference["kprog2_proj"]);
}

TEST(FittedSurface, SeesWhatTheMarginalRuleIsBlindTo) {
    SKIP_UNLESS_SHARED(surface_json);
    const auto f = [](double x, double y) {
        return 10 * std::sin(6 * std::numbers::pi * x) * std::sin(6 * std::numbers::pi * y);
    };
    const SurfaceTable table = surface_of(f, 81, 81, 0.1);
    FitSurfaceOptions options;
    options.sigma = 0.1;
    options.delta2 = 1.1 * (6561 - 361);
    const FitSurfaceReport projected = fit_surface(table.view(), options).report;
    options.rule = StripRule::marginal;
    const FitSurfaceReport marginal = fit_surface(table.view(), options).report;
    EXPECT_EQ(projected.parameters, 361);
    EXPECT_GE(marginal.parameters, 600);
    EXPECT_LE(*projected.sigma2, 1.1);
}

TEST(FittedSurface, FillsMissingNodesLikeTheReference) {
    SKIP_UNLESS_SHARED(missing_json);
    const json reference = shared_json(missing_json);
    const json knots = shared_json(surface_json)["equal"]["kprog2_paper"];
    const CsvTable masks = shared_csv("reference/fitting/missing_masks.csv");
    FitSurfaceOptions options = with_unit_sigma();
    options.x_knots = knots["bx"].get<std::vector<double>>();
    options.y_knots = knots["by"].get<std::vector<double>>();
    for (const auto& [name, want] : reference.items()) {
        SCOPED_TRACE(name);
        std::string column = name;
        std::replace(column.begin(), column.end(), ' ', '_');
        SurfaceTable table = surface_table("surface_equal");
        const std::size_t n = table.y.size();
        for (std::size_t k = 0; k < masks.rows.size(); ++k) {
            if (masks.number(k, column) == 0) table.z.drop(k / n, k % n);
        }
        const FitSurfaceReport r = fit_surface(table.view(), options).report;
        EXPECT_EQ(r.samples, want["N"].get<std::size_t>());
        EXPECT_NEAR(r.delta2, want["d2"].get<double>(), 1e-8 * r.delta2);
        EXPECT_LE(r.iterations, 2 * want["cg_iters"].get<int>());
        EXPECT_TRUE(r.undetermined.empty());
        EXPECT_EQ(r.status, Status::met);
    }
}

TEST(FittedSurface, ListsTheCoefficientsThatAHoleSwallows) {
    SurfaceTable table = surface_of([](double x, double y) { return x * y; }, 41, 41);
    for (std::size_t i = 10; i < 31; ++i) {
        for (std::size_t j = 10; j < 31; ++j) table.z.drop(i, j);
    }
    FitSurfaceOptions options;
    options.sigma = 0.01;
    options.knots = SurfaceKnots::equal;
    options.intervals = {10, 10};
    const SurfaceFit made = fit_surface(table.view(), options);
    // The hole spans (0.225, 0.775): splines 6 and 7 of 13 live on [0.3, 0.7] and [0.4, 0.8]...
    EXPECT_EQ(made.report.status, Status::rank_deficient);
    EXPECT_EQ(made.report.missing, 21u * 21u);
    ASSERT_FALSE(made.report.undetermined.empty());
    for (const auto& [i, j] : made.report.undetermined) {
        EXPECT_GE(made.surface.x_basis().knots()[static_cast<std::size_t>(i)], 0.225);
        EXPECT_LE(made.surface.x_basis().knots()[static_cast<std::size_t>(i) + 4], 0.775);
    }
    EXPECT_NEAR(made.surface(0.1, 0.9), 0.09, 1e-9);
}

/// The rule `distribution` needs every residual, so that its search reads the nodes at each step.
TEST(FittedSurface, TakesTheSameStepsWhereTheNodesAreReadOnce) {
    const auto f = [](double x, double y) { return std::sin(6 * x) * std::cos(5 * y) + x * y; };
    const SurfaceTable table = surface_of(f, 300, 200, 0.02);
    FitSurfaceOptions options;
    options.sigma = 0.02;
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.95, 0.99};
    const std::vector<SurfaceStep> each = fit_surface(table.view(), options).report.path;
    options.stop = StopRule::bic;
    options.distribution.clear();
    const std::vector<SurfaceStep> once = fit_surface(table.view(), options).report.path;
    const std::size_t steps = std::min(each.size(), once.size());
    ASSERT_GT(steps, 20u);
    for (std::size_t i = 0; i < steps; ++i) {
        EXPECT_EQ(once[i].intervals, each[i].intervals);
        EXPECT_NEAR(once[i].delta2, each[i].delta2, 1e-10 * each[i].delta2);
        EXPECT_TRUE(once[i].psi.empty());
        EXPECT_FALSE(each[i].psi.empty());
    }
}

bool has_note(const FitSurfaceReport& report, std::string_view words) {
    return std::any_of(report.notes.begin(), report.notes.end(), [&](const std::string& note) {
        return note.find(words) != std::string::npos;
    });
}

TEST(FittedSurface, StopsAtTheNormalDistributionWhereNoneIsGiven) {
    const auto f = [](double x, double y) { return std::sin(6 * x) * std::cos(5 * y); };
    const SurfaceTable table = surface_of(f, 41, 37, 0.1);
    FitSurfaceOptions options;
    options.sigma = 0.1;
    options.stop = StopRule::distribution;
    const FitSurfaceReport report = fit_surface(table.view(), options).report;
    EXPECT_EQ(report.status, Status::met);
    EXPECT_LT(report.parameters, 200);
    EXPECT_GE(report.psi[0], 0.68);
    EXPECT_LT(report.psi[0], 1);
}

TEST(FittedSurface, SpendsNoStripOnRounding) {
    const auto plane = [](double x, double y) { return x / 7 + y / 3; };
    SurfaceTable table = surface_of(plane, 12, 6);
    for (const bool has_hole : {false, true}) {
        if (has_hole) table.z.drop(5, 2);
        const SurfaceFit made = fit_surface(table.view(), {});
        EXPECT_EQ(made.report.intervals, (std::array{1, 1}));
        EXPECT_EQ(made.report.oscillation, 0);
        EXPECT_TRUE(made.report.notes.empty());
        EXPECT_NEAR(made.surface(0.3, 0.7), plane(0.3, 0.7), has_hole ? 1e-10 : 1e-14);
    }
}

TEST(FittedSurface, SaysHowManyStripsThereCanBe) {
    const SurfaceTable table = surface_of([](double x, double y) { return x * y; }, 11, 9, 0.1);
    FitSurfaceOptions options;
    options.sigma = 0.1;
    options.intervals = {20, 2};
    const FitSurfaceReport report = fit_surface(table.view(), options).report;
    EXPECT_EQ(report.status, Status::not_met);
    EXPECT_TRUE(has_note(report, "intervals: the data determine no more than 8 x 2"));
}

TEST(FittedSurface, EndsItsSearchWhereMissingNodesLeaveTooFew) {
    SurfaceTable table = surface_of([](double x, double y) { return std::sin(20 * x * y); }, 16, 15, 0.3);
    for (std::size_t k = 0; k < 28; ++k) table.z.drop(k * 7 % 16, k * 4 % 15);
    for (const SurfaceKnots knots : {SurfaceKnots::automatic, SurfaceKnots::equal}) {
        FitSurfaceOptions options;
        options.sigma = 1e-3;
        options.knots = knots;
        const FitSurfaceReport report = fit_surface(table.view(), options).report;
        EXPECT_GT(report.parameters, 100);
        EXPECT_LE(static_cast<std::size_t>(report.parameters), report.samples);
        EXPECT_EQ(report.missing, 28u);
    }
}

TEST(FittedSurface, KnowsProductsAndConstants) {
    FitSurfaceOptions options = with_unit_sigma();
    const auto odd = [](double x, double y) { return (x - 0.5) * (y - 0.5); };
    const Separability product = fit_surface(surface_of(odd, 33, 31).view(), options).report.separability;
    EXPECT_LE(product.product, 1e-12);
    EXPECT_NEAR(product.additive, 1, 1e-12);
    const auto two = [](double x, double y) { return x < 0.1 ? 10 * (y < 0.5) : 9 * (y >= 0.5); };
    options.degree = 1;
    options.knots = SurfaceKnots::equal;
    options.intervals = {32, 30};
    // 4 rows of 15 heights 10, the others of 16 heights 9.
    const Separability blocks = fit_surface(surface_of(two, 33, 31).view(), options).report.separability;
    const double small = 4 * 15 * 100, large = 29 * 16 * 81;
    EXPECT_NEAR(blocks.product, small / (small + large), 1e-9);
    options.degree = 0;
    options.intervals = {1, 1};
    const auto flat = [](double, double) { return 0.1; };
    const Separability none = fit_surface(surface_of(flat, 9, 9).view(), options).report.separability;
    EXPECT_EQ(none.additive, 0);
    EXPECT_LE(none.product, 1e-12);
}

TEST(FittedSurface, WarnsOfResidualsLargerThanTheErrors) {
    const auto f = [](double x, double y) { return std::sin(9 * x) * std::cos(7 * y); };
    const SurfaceTable table = surface_of(f, 41, 37, 0.01);
    FitSurfaceOptions options;
    options.sigma = 0.01;
    EXPECT_TRUE(fit_surface(table.view(), options).report.notes.empty());
    options.intervals = {3, 3};
    EXPECT_TRUE(has_note(fit_surface(table.view(), options).report,
                         "chi2_p: the residuals are larger than the errors"));
}

TEST(FittedSurface, WarnsWhereItSwingsBetweenTheNodes) {
    const auto front = [](double x, double y) { return x + 0.3 * y > 0.6 ? 1.0 : 0.0; };
    const SurfaceTable table = surface_of(front, 60, 31, 0.01);
    FitSurfaceOptions options;
    options.sigma = 0.01;
    const FitSurfaceReport report = fit_surface(table.view(), options).report;
    EXPECT_GT(report.oscillation, 2);
    EXPECT_TRUE(has_note(report, "the surface swings between the samples; separability"));
    EXPECT_TRUE(has_note(report, "curved knot lines"));
}

TEST(FittedSurface, TellsOfStripsThatFitEquallyBadly) {
    const auto hill = [](double x, double y) {
        return std::exp(-8 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)));
    };
    const SurfaceTable table = surface_of(hill, 33, 33);
    FitSurfaceOptions options;
    options.sigma = 0.001;
    options.intervals = {2, 2};
    const FitSurfaceReport report = fit_surface(table.view(), options).report;
    EXPECT_TRUE(has_note(report, "tie: at 1 x 1 two strips fit equally badly; the first is halved"));
}

}  // namespace fit_surface_test
}  // namespace batten
