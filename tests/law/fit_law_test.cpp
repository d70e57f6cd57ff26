#include "batten/make/fit_chunks.hpp"
#include "batten/make/fit_statistics.hpp"
#include "fit_samples.hpp"

/// What holds for every fit.
namespace batten {
namespace fit_law_test {

using testing::FitTable;
using testing::Noise;
using testing::noisy_curve;

FitTable scaled(FitTable table, double x, double y) {
    for (double& v : table.x) v *= x;
    for (double& v : table.y) v *= y;
    for (double& v : table.sigma) v *= y;
    return table;
}

std::vector<double> times(std::vector<double> values, double factor) {
    for (double& v : values) v *= factor;
    return values;
}

/// N samples with abscissae, errors and repetitions at random.
FitTable ragged(std::size_t n, std::uint64_t seed) {
    Noise noise(seed);
    FitTable table;
    for (std::size_t i = 0; i < n; ++i) {
        const bool repeats = i > 0 && noise.uniform() < 0.1;
        table.x.push_back(repeats ? table.x.back() : 100 * noise.uniform());
        table.sigma.push_back(0.5 + noise.uniform());
        table.y.push_back(testing::curve_truth(table.x.back()) +
                          table.sigma.back() * noise.normal());
    }
    return table;
}

FitOptions over(std::vector<double> knots, int degree) {
    FitOptions options;
    options.knots = KnotPlacement::given;
    options.knots_values = std::move(knots);
    options.degree = degree;
    return options;
}

TEST(Fit, ScalesExactlyWithTheOrdinates) {
    const FitTable table = noisy_curve(201, 1.5, 1);
    for (const KnotPlacement knots : {KnotPlacement::automatic, KnotPlacement::free}) {
        FitOptions options;
        options.knots = knots;
        if (knots == KnotPlacement::free) options.intervals = 6;
        const Fit one = fit(table.view(), options);
        for (const double factor : {0x1p-40, 0x1p+30}) {
            const Fit other = fit(scaled(table, 1, factor).view(), options);
            EXPECT_EQ(other.report.coefficients, times(one.report.coefficients, factor));
            EXPECT_EQ(other.report.knots, one.report.knots);
            EXPECT_EQ(other.report.delta2, one.report.delta2);
            EXPECT_EQ(other.report.path.size(), one.report.path.size());
        }
    }
}

TEST(Fit, ScalesExactlyWithTheAbscissae) {
    const FitTable table = noisy_curve(201, 1.5, 2);
    for (const KnotPlacement knots : {KnotPlacement::automatic, KnotPlacement::free}) {
        FitOptions options;
        options.knots = knots;
        if (knots == KnotPlacement::free) options.intervals = 6;
        const Fit one = fit(table.view(), options);
        const Fit other = fit(scaled(table, 0x1p-20, 1).view(), options);
        EXPECT_EQ(other.report.coefficients, one.report.coefficients);
        EXPECT_EQ(other.report.knots, times(one.report.knots, 0x1p-20));
        EXPECT_EQ(other.report.delta2, one.report.delta2);
    }
}

TEST(Fit, DoesNotDependOnTheOrderOfTheSamples) {
    FitTable table = ragged(400, 3);
    const Fit one = fit(table.view(), over({20, 40, 60, 80}, 3));
    FitTable other;
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        const std::size_t j = (i * 171) % table.x.size();
        other.x.push_back(table.x[j]);
        other.y.push_back(table.y[j]);
        other.sigma.push_back(table.sigma[j]);
    }
    const Fit shuffled = fit(other.view(), over({20, 40, 60, 80}, 3));
    for (std::size_t j = 0; j < one.report.coefficients.size(); ++j) {
        EXPECT_NEAR(shuffled.report.coefficients[j], one.report.coefficients[j], 1e-11);
    }
}

/// No spline over the same knots leaves less.
void expect_least(const FitTable& table, const Fit& result) {
    const int degree = result.spline.degree();
    const std::size_t p = result.report.coefficients.size();
    for (std::size_t j = 0; j < p; ++j) {
        std::vector<double> unit(p);
        unit[j] = 1;
        const SplineFunction b(result.report.knots, unit, degree);
        double product = 0, norm = 0, rest = 0;
        for (std::size_t i = 0; i < table.x.size(); ++i) {
            const double w = 1 / table.sigma[i];
            const double e = w * (table.y[i] - result.spline(table.x[i]));
            product += e * w * b(table.x[i]);
            norm += w * w * b(table.x[i]) * b(table.x[i]);
            rest += e * e;
        }
        EXPECT_LT(std::fabs(product), 1e-11 * std::sqrt(norm * rest) + 1e-9 * norm)
            << degree << " " << j;
    }
}

TEST(Fit, LeavesResidualsOrthogonalToTheSplines) {
    for (int degree = 0; degree <= 9; ++degree) {
        const FitTable table = ragged(600, 4);
        expect_least(table, fit(table.view(), over({10, 25, 50, 50.5, 75}, degree)));
    }
}

/// Nine of ten samples in the first or the last tenth.
FitTable crowded(bool at_the_end) {
    FitTable table = ragged(1000, 5);
    Noise noise(6);
    for (std::size_t i = 0; i < table.x.size(); ++i) {
        double x = table.x[i];
        if (i % 10 != 0) x = at_the_end ? 90 + x / 10 : x / 10;
        table.x[i] = x;
        table.y[i] = testing::curve_truth(x) + table.sigma[i] * noise.normal();
    }
    return table;
}

TEST(Fit, OfSamplesThatCrowdLeavesResidualsOrthogonalToo) {
    for (const bool at_the_end : {false, true}) {
        const FitTable table = crowded(at_the_end);
        for (const int degree : {0, 1, 3}) {
            expect_least(table, fit(table.view(), over({20, 40, 60, 80}, degree)));
            expect_least(table, fit(table.view(), over({5, 50}, degree)));
        }
        FitOptions automatic;
        expect_least(table, fit(table.view(), automatic));
        automatic.knots = KnotPlacement::equal;
        automatic.intervals = 7;
        expect_least(table, fit(table.view(), automatic));
    }
}

TEST(Fit, ReproducesSplinesOfItsOwnKnots) {
    Noise noise(5);
    for (int degree = 1; degree <= 9; ++degree) {
        std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0), c;
        knots.insert(knots.end(), {20, 45, 45, 70});
        knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 100.0);
        if (degree == 1) knots.erase(knots.begin() + 3);
        while (c.size() + static_cast<std::size_t>(degree) + 1 < knots.size()) {
            c.push_back(noise.normal());
        }
        const SplineFunction truth(knots, c, degree);
        FitTable table;
        for (int i = 0; i <= 200; ++i) {
            table.x.push_back(0.5 * i);
            table.y.push_back(truth(0.5 * i));
            table.sigma.push_back(1);
        }
        std::vector<double> inside(knots.begin() + degree + 1, knots.end() - degree - 1);
        const Fit result = fit(table.view(), over(inside, degree));
        for (std::size_t j = 0; j < c.size(); ++j) {
            EXPECT_NEAR(result.report.coefficients[j], c[j], 1e-10) << degree << " " << j;
        }
    }
}

TEST(Fit, GivesSamplesOfInfiniteErrorNoWeight) {
    FitTable table = noisy_curve(201, 1.5, 6);
    FitTable fewer = table, ignored = table;
    ignored.y[77] = 1e6;
    ignored.sigma[77] = std::numeric_limits<double>::infinity();
    for (auto* column : {&fewer.x, &fewer.y, &fewer.sigma}) column->erase(column->begin() + 77);
    const Fit one = fit(fewer.view(), {}), other = fit(ignored.view(), {});
    EXPECT_EQ(one.report.coefficients, other.report.coefficients);
    EXPECT_EQ(other.report.samples, 200u);
}

TEST(Fit, CountsItsResidualsAsTheyAre) {
    for (const std::size_t n : {50u, 519u, 1001u}) {
        FitTable table = noisy_curve(n, 1.5, n);
        for (std::size_t i = 0; i < n; i += 97) table.y[i] += i % 2 == 0 ? 5.3 : -9;
        const Fit made = fit(table.view(), over({10, 25, 40, 60, 80}, 3));
        double delta2 = 0, largest = 0;
        std::size_t runs = 1, positive = 0;
        std::vector<double> psi(10, 0.0);
        bool before = true;
        for (std::size_t i = 0; i < n; ++i) {
            const double e = table.y[i] - made.spline(table.x[i]), q = e / table.sigma[i];
            delta2 += q * q;
            largest = std::max(largest, std::fabs(e));
            for (int w = 0; w < 10; ++w) {
                psi[static_cast<std::size_t>(w)] +=
                    (std::fabs(e) <= (w + 1) * table.sigma[i]) / static_cast<double>(n);
            }
            runs += i > 0 && (e >= 0) != before;
            before = e >= 0;
            positive += before;
        }
        EXPECT_NEAR(made.report.delta2, delta2, 1e-12 * delta2);
        EXPECT_DOUBLE_EQ(*made.report.max_residual, largest);
        EXPECT_EQ(made.report.runs_p, runs_probability(runs, positive, n - positive)) << n;
        for (std::size_t w = 0; w < 10; ++w) EXPECT_NEAR(made.report.psi[w], psi[w], 1e-12) << w;
        FitOptions common = over({10, 25, 40, 60, 80}, 3);
        common.sigma = 1.5;
        const Fit other = fit(table.without_sigma(), common);
        EXPECT_NEAR(other.report.delta2, delta2, 1e-11 * delta2);
        EXPECT_EQ(other.report.psi, made.report.psi);
    }
}

TEST(Fit, IsContinuousInErrorsAndDataForFixedKnots) {
    const FitTable table = ragged(300, 7);
    const FitOptions options = over({15, 30, 45, 60, 75, 90}, 3);
    const Fit one = fit(table.view(), options);
    for (std::size_t i = 0; i < table.x.size(); i += 29) {
        FitTable near = table;
        near.sigma[i] *= 1 + 1e-9;
        near.y[i] += 1e-9;
        const Fit other = fit(near.view(), options);
        for (std::size_t j = 0; j < one.report.coefficients.size(); ++j) {
            EXPECT_NEAR(other.report.coefficients[j], one.report.coefficients[j], 1e-7);
        }
    }
}

TEST(Fit, OfAClosedSplineContinuesWhereItStarts) {
    Noise noise(8);
    FitTable table;
    for (int i = 0; i <= 300; ++i) {
        const double x = i / 300.0;
        table.x.push_back(x);
        table.y.push_back(std::sin(2 * std::numbers::pi * x) + 0.1 * noise.normal());
        table.sigma.push_back(0.1);
    }
    for (int degree = 1; degree <= 5; ++degree) {
        for (const int n : {1, 2, 3, 5, 8, 13}) {
            FitOptions options;
            options.knots = KnotPlacement::equal;
            options.intervals = n;
            options.degree = degree;
            options.closed = true;
            const Fit result = fit(table.view(), options);
            EXPECT_EQ(result.report.parameters, n);
            for (int d = 0; d < degree; ++d) {
                const double scale = std::pow(10.0 * n, d);
                EXPECT_NEAR(result.spline(0, d), result.spline(1, d), 1e-10 * scale)
                    << degree << " " << n << " " << d;
            }
        }
    }
}

TEST(FitChunks, MergeToTheFitOfTheWhole) {
    for (const int degree : {0, 1, 3, 6}) {
        const FitTable table = ragged(1000, 9);
        const std::vector<double> knots{10, 30, 50, 52, 90};
        const Fit whole = fit(table.view(), over(knots, degree));
        const Interval domain{whole.report.breaks.front(), whole.report.breaks.back()};
        std::vector<FitChunk> chunks(4, FitChunk(domain, knots, degree));
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            const std::size_t first = c * 250;
            chunks[c].add({std::span(table.x).subspan(first, 250),
                           std::span(table.y).subspan(first, 250),
                           std::span(table.sigma).subspan(first, 250)});
        }
        FitChunk left = chunks[0], right = chunks[3];
        left.merge(chunks[1]);
        right.merge(chunks[2]);
        right.merge(left);
        for (std::size_t c = 1; c < chunks.size(); ++c) chunks[0].merge(chunks[c]);
        for (const FitChunk& merged : {chunks[0], right}) {
            const Fit result = merged.solve();
            EXPECT_EQ(result.report.samples, 1000u);
            EXPECT_NEAR(result.report.delta2 / whole.report.delta2, 1, 1e-12);
            for (std::size_t j = 0; j < whole.report.coefficients.size(); ++j) {
                EXPECT_NEAR(result.report.coefficients[j], whole.report.coefficients[j], 1e-10);
            }
            EXPECT_NEAR(result.covariance.deviation(33) / whole.covariance.deviation(33), 1,
                        1e-11);
        }
    }
}

TEST(FitChunks, MayEachSeeAPlaceOfTheirOwn) {
    FitTable table = ragged(500, 12);
    std::sort(table.x.begin(), table.x.end());
    const std::vector<double> knots{10, 30, 50, 52, 90};
    const Fit whole = fit(table.view(), over(knots, 3));
    for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{100}}) {
        FitChunk chunk({whole.report.breaks.front(), whole.report.breaks.back()}, knots, 3);
        for (std::size_t first = 0; first < 500; first += size) {
            const std::size_t count = std::min(size, 500 - first);
            chunk.add({std::span(table.x).subspan(first, count),
                       std::span(table.y).subspan(first, count),
                       std::span(table.sigma).subspan(first, count)});
        }
        const Fit result = chunk.solve();
        EXPECT_EQ(result.report.samples, 500u);
        EXPECT_NEAR(result.report.delta2 / whole.report.delta2, 1, 1e-11);
        for (std::size_t j = 0; j < whole.report.coefficients.size(); ++j) {
            EXPECT_NEAR(result.report.coefficients[j], whole.report.coefficients[j], 1e-9);
        }
    }
}

TEST(FitByInsertion, GivesTheSamePathFromATreeAndFromSamples) {
    // 3,000 samples go through the tree; every fourth step is checked against fixed knots.
    const FitTable table = noisy_curve(3000, 1.5, 10);
    const Fit path = fit(table.view(), {});
    FitOptions options;
    for (int n = 1; n <= 40; n += 4) {
        options.intervals = n;
        const Fit exact = fit(table.view(), options);
        EXPECT_NEAR(path.report.path[static_cast<std::size_t>(n - 1)].delta2 /
                        exact.report.delta2, 1, 1e-11);
    }
}

TEST(FitSuggestions, AreThoseOfTheErrorThatTheResidualsSay) {
    // Few knots: residuals are far above the differences of neighbours.
    const FitTable table = noisy_curve(120, 0.05, 11);
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 5;
    options.suggest = 6;
    const FitReport estimated = fit(table.without_sigma(), options).report;
    ASSERT_GT(*estimated.sigma2, 100);
    options.sigma = *estimated.sigma * std::sqrt(*estimated.sigma2);
    const FitReport stated = fit(table.without_sigma(), options).report;
    EXPECT_EQ(estimated.suggestions, stated.suggestions);
}

}  // namespace fit_law_test
}  // namespace batten
