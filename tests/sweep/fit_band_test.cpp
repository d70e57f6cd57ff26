#include <functional>

#include "fit_samples.hpp"

/// Are 95 % bands 95 % bands, and do the noisy fits come as near the truth as promised?
namespace batten {
namespace fit_band_test {

using testing::FitTable;
using testing::Noise;

/// How many of `places` abscissae of the range have the truth inside the band.
int covered(const Fit& result, const std::function<double(double)>& truth, int places) {
    const Interval domain = result.spline.domain();
    int inside = 0;
    for (int i = 0; i < places; ++i) {
        const double x = domain.clamp(domain.lo + domain.length() * (i / (places - 1.0)));
        const double half = result.covariance.factor_95() * result.covariance.deviation(x);
        inside += std::fabs(result.spline(x) - truth(x)) <= half;
    }
    return inside;
}

TEST(FitBands, CoverSplinesOverTheirOwnKnots) {
    FitOptions options;
    options.knots = KnotPlacement::given;
    options.knots_values = {6, 12, 20, 25, 31, 38, 44, 47, 50, 53, 56, 62, 66, 69, 72, 75, 81, 88};
    std::vector<double> knots(4, 0.0);
    knots.insert(knots.end(), options.knots_values.begin(), options.knots_values.end());
    knots.insert(knots.end(), 4, 100.0);
    Noise noise(31);
    std::vector<double> c(knots.size() - 4);
    for (double& v : c) v = noise.normal();
    const SplineFunction truth(knots, c, 3);
    for (const bool is_known : {true, false}) {
        int inside = 0, in_integral = 0;
        const double area = integral(truth, {10, 60});
        constexpr int sets = 2000, places = 51;
        for (int set = 0; set < sets; ++set) {
            FitTable table;
            for (int i = 0; i <= 200; ++i) {
                table.x.push_back(0.5 * i);
                table.y.push_back(truth(0.5 * i) + 0.3 * noise.normal());
                table.sigma.push_back(0.3);
            }
            const Fit result =
                fit(is_known ? table.view() : table.without_sigma(), options);
            inside += covered(result, [&](double x) { return truth(x); }, places);
            const Uncertain a = result.covariance.integral({10, 60});
            in_integral += std::fabs(a.value - area) <= result.covariance.factor_95() * a.deviation;
        }
        const double share = inside / double(sets * places);
        RecordProperty(is_known ? "known" : "unknown", std::to_string(share));
        EXPECT_GT(share, 0.93);
        EXPECT_LT(share, 0.97);
        EXPECT_GT(in_integral, 0.93 * sets);
        EXPECT_LT(in_integral, 0.97 * sets);
    }
}

TEST(FitBands, StayHonestAfterAutomaticKnots) {
    struct Case {
        const char* name;
        std::function<double(double)> truth;
        double sigma;
    };
    const Case cases[] = {
        {"curve", [](double t) { return testing::curve_truth(100 * t); }, 1.5},
        {"sine", [](double t) { return std::sin(2 * std::numbers::pi * t); }, 0.2},
        {"bump", [](double t) { return std::exp(-78.125 * (t - 0.5) * (t - 0.5)); }, 0.1},
        {"runge", [](double t) { return 1 / (1 + 25 * (2 * t - 1) * (2 * t - 1)); }, 0.1},
        {"logistic", [](double t) { return 1 / (1 + std::exp(-20 * (t - 0.4))); }, 0.1}};
    for (const Case& c : cases) {
        for (const int n : {100, 400, 1600}) {
            constexpr int sets = 60, places = 101;
            int inside = 0;
            for (int set = 0; set < sets; ++set) {
                Noise noise(static_cast<std::uint64_t>(1000 * n + set));
                FitTable table;
                for (int i = 0; i < n; ++i) {
                    table.x.push_back((i + 0.5) / n);
                    table.y.push_back(c.truth(table.x.back()) + c.sigma * noise.normal());
                    table.sigma.push_back(c.sigma);
                }
                inside += covered(fit(table.view(), {}), c.truth, places);
            }
            const double share = inside / double(sets * places);
            RecordProperty(std::string(c.name) + std::to_string(n), std::to_string(share));
            EXPECT_GE(share, 0.92) << c.name << " " << n;
            EXPECT_LE(share, 0.98) << c.name << " " << n;
        }
    }
}

struct Outcome {
    double intervals, distance;
};

/// The Monte Carlo of the specification, 201 samples of sigma 1.5; with 480 sets the median
/// distance is good to 0.005.
Outcome monte_carlo(Robust robust, bool outliers, int sets) {
    std::vector<double> intervals, distances;
    for (int set = 0; set < sets; ++set) {
        FitTable table = testing::noisy_curve(201, 1.5, static_cast<std::uint64_t>(500 + set));
        if (outliers) {
            table.y[100] += 9;
            table.y[40] -= 15;
        }
        FitOptions options;
        options.robust = robust;
        const Fit result = fit(table.view(), options);
        intervals.push_back(result.report.intervals);
        distances.push_back(testing::distance_to_truth(result.spline));
    }
    return {testing::median(intervals), testing::median(distances)};
}

TEST(FitOfNoisyData, ChoosesAboutTwentyIntervalsAndComesNearTheTruth) {
    const Outcome outcome = monte_carlo(Robust::none, false, 480);
    RecordProperty("distance", std::to_string(outcome.distance));
    // Half of the sets take 19 or fewer, half 20 or more: the median of any 480 is one or the other.
    EXPECT_NEAR(outcome.intervals, 20, 1);
    EXPECT_LE(outcome.distance, 0.70);
}

TEST(FitOfNoisyData, IsSavedFromOutliersByRejection) {
    const Outcome saved = monte_carlo(Robust::reject, true, 480);
    RecordProperty("distance", std::to_string(saved.distance));
    EXPECT_LE(saved.distance, 0.70);
    EXPECT_GT(monte_carlo(Robust::none, true, 30).distance, 1);
    EXPECT_LT(monte_carlo(Robust::tukey, true, 30).distance, 0.75);
}

}  // namespace fit_band_test
}  // namespace batten
