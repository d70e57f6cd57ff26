#include <cmath>
#include <random>

#include "batten/make/densify.hpp"
#include "batten/make/thin.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "shared.hpp"

namespace batten {
namespace densify_law_test {

/// A wandering row of points, now and then nearly coincident.
Points wandering(unsigned seed, std::size_t n, int dim) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(-1, 1);
    Points points(n, dim);
    for (std::size_t i = 0; i < n; ++i) {
        const double size = random() % 5 == 0 ? 1e-3 : 1;
        for (int k = 0; k < dim; ++k) {
            points(i, k) = (i > 0 ? points(i - 1, k) : 0) + size * (step(random) + (k == 0));
        }
    }
    return points;
}

DensifyOptions any_options(unsigned seed) {
    DensifyOptions options;
    options.degree = 1 + static_cast<int>(seed % 6);
    options.between = static_cast<int>(seed / 6 % 4);
    options.parameter = names_of(LagrangeParameter{})[seed / 24 % 3].value;
    options.closed = seed / 72 % 2 == 1;
    options.blend = options.degree > 1 && seed / 144 % 2 == 1;
    options.keep_spikes = seed / 288 % 2 == 1;
    return options;
}

TEST(DensifyLaw, TheGivenPointsAreKeptBitForBit) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        const DensifyOptions options = any_options(seed);
        const Points points = wandering(seed, 12, 1 + static_cast<int>(seed % 4));
        const Densified result = densify(points, options);
        const std::size_t steps = static_cast<std::size_t>(*options.between) + 1;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto row = result.points.view()[i * steps];
            EXPECT_TRUE(std::equal(row.begin(), row.end(), points.view()[i].begin()));
            const std::vector<double> met = result.curve(result.curve.breaks()[i]);
            EXPECT_TRUE(std::equal(met.begin(), met.end(), points.view()[i].begin()));
        }
    }
}

TEST(DensifyLaw, PointsTimesAPowerOfTwoGiveExactlyThat) {
    for (unsigned seed = 0; seed < 600; ++seed) {
        const DensifyOptions options = any_options(seed);
        const Points points = wandering(seed, 11, 2 + static_cast<int>(seed % 2));
        for (const int power : {1, -7, 40}) {
            Points larger = points;
            for (double& x : larger.coordinates()) x = std::ldexp(x, power);
            const Densified a = densify(points, options), b = densify(larger, options);
            ASSERT_EQ(a.points.size(), b.points.size());
            for (std::size_t i = 0; i < a.points.coordinates().size(); ++i) {
                ASSERT_EQ(std::ldexp(a.points.view().coordinates()[i], power),
                          b.points.view().coordinates()[i])
                    << seed;
            }
            EXPECT_EQ(std::ldexp(a.report.max_chord_error, power), b.report.max_chord_error);
            EXPECT_EQ(a.report.tangent_jumps, b.report.tangent_jumps);
            EXPECT_EQ(a.report.tamed_cells, b.report.tamed_cells);
        }
    }
}

TEST(DensifyLaw, TheBulkKernelWritesTheSameBits) {
    for (unsigned seed = 0; seed < 576; ++seed) {
        const DensifyOptions options = any_options(seed);
        const Points points = wandering(seed, 14, 1 + static_cast<int>(seed % 4));
        std::vector<double> out(densified_count(points.size(), options) *
                                static_cast<std::size_t>(points.dim()));
        densify_into(points, options, out);
        const Points whole = densify(points, options).points;
        ASSERT_TRUE(std::equal(out.begin(), out.end(), whole.coordinates().begin(),
                               whole.coordinates().end()))
            << seed;
    }
}

TEST(DensifyLaw, ReversingThePointsReversesTheCurveWhereTheWindowsAreSymmetric) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        DensifyOptions options = any_options(seed);
        // A cell's window has room to be central for odd degrees, a point's for even ones.
        options.degree = 2 * (options.degree / 2) + (options.blend ? 2 : 1);
        const Points points = wandering(seed, 10, 2);
        Points back(0, 2);
        for (std::size_t i = points.size(); i-- > 0;) back.push_back(points.view()[i]);
        const Points a = densify(points, options).points, b = densify(back, options).points;
        const std::size_t n = a.size();
        const std::size_t offset = options.closed ? static_cast<std::size_t>(*options.between) : 0;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (2 * n - 1 - i - offset) % n;
            for (int k = 0; k < 2; ++k) EXPECT_NEAR(a(i, k), b(j, k), 1e-9) << seed;
        }
    }
}

TEST(DensifyLaw, APolynomialOfTheDegreeIsMadeAgain) {
    for (int degree = 1; degree <= 8; ++degree) {
        const auto f = [&](double t, int k) { return std::pow(t, degree) - k * t; };
        Points points(3);
        DensifyOptions options;
        for (const double t : {0.0, 0.3, 0.5, 1.0, 1.1, 1.7, 2.0, 2.2, 2.7, 3.0}) {
            points.push_back(std::vector{f(t, 0), f(t, 1), t});
            options.parameter_values.push_back(t);
        }
        options.degree = degree;
        options.keep_spikes = true;
        const Points dense = densify(points, options).points;
        for (std::size_t i = 0; i < dense.size(); ++i) {
            const double t = dense(i, 2);
            EXPECT_NEAR(dense(i, 0), f(t, 0), 1e-11 * std::pow(3, degree));
            EXPECT_NEAR(dense(i, 1), f(t, 1), 1e-11 * std::pow(3, degree));
        }
    }
}

TEST(DensifyLaw, ABlendHasNoTangentJumps) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        DensifyOptions options = any_options(seed);
        options.degree = 2 + static_cast<int>(seed % 4);
        options.blend = true;
        options.keep_spikes = true;
        EXPECT_LT(densify(wandering(seed, 12, 2 + static_cast<int>(seed % 2)), options)
                      .report.max_tangent_jump,
                  1e-9);
        options.blend = false;
        options.degree = 3;
        EXPECT_GT(densify(wandering(seed, 12, 2), options).report.max_tangent_jump, 1e-3);
    }
}

TEST(DensifyLaw, NoTamedCellStraysFurtherFromItsMiddleThanItsChordIsLong) {
    std::size_t tamed = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        DensifyOptions options = any_options(seed);
        options.keep_spikes = false;
        options.between = 15;
        const Points points = wandering(seed, 12, 2);
        const Densified result = densify(points, options);
        tamed += result.report.tamed_cells.size();
        for (std::size_t i = 0; i < result.points.size(); ++i) {
            const std::size_t cell = i / 16, next = (cell + 1) % points.size();
            if (!options.closed && cell + 1 == points.size()) continue;
            const double mx = 0.5 * (points(cell, 0) + points(next, 0));
            const double my = 0.5 * (points(cell, 1) + points(next, 1));
            const double chord =
                std::hypot(points(next, 0) - points(cell, 0), points(next, 1) - points(cell, 1));
            EXPECT_LE(std::hypot(result.points(i, 0) - mx, result.points(i, 1) - my),
                      chord * (1 + 1e-9));
        }
    }
    EXPECT_GT(tamed, 100u);
}

TEST(DensifyLaw, TheCurveIsCubicPiecesUpToDegreeThreeAndItsJetsAreItsDerivatives) {
    const Points points = wandering(5, 9, 2);
    for (int degree = 1; degree <= 7; ++degree) {
        DensifyOptions options;
        options.degree = degree;
        const Curve curve = densify(points, options).curve;
        EXPECT_EQ(curve.shape<PiecewiseCubic>() != nullptr, degree <= 3);
        EXPECT_EQ(curve.degree(), std::max(3, degree));
        const double h = 1e-5;
        for (const double t : {0.3, 2.5, 6.7}) {
            const Jet jet = curve.jet(t, 2);
            const std::vector<double> a = curve(t - h), b = curve(t), c = curve(t + h);
            for (std::size_t k = 0; k < 2; ++k) {
                EXPECT_NEAR(jet[1][k], (c[k] - a[k]) / (2 * h), 1e-5 * (1 + std::fabs(jet[1][k])));
                EXPECT_NEAR(jet[2][k], (c[k] - 2 * b[k] + a[k]) / (h * h),
                            1e-3 * (1 + std::fabs(jet[2][k])));
            }
        }
    }
}

TEST(ThinLaw, PointsTimesAPowerOfTwoKeepTheSameRows) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        const Points points = wandering(seed, 25, 2);
        ThinOptions options;
        options.tolerance = relative(0.02);
        Points larger = points;
        for (double& x : larger.coordinates()) x = std::ldexp(x, 9);
        const Thinned a = thin(points, options), b = thin(larger, options);
        EXPECT_EQ(a.kept, b.kept);
        EXPECT_EQ(std::ldexp(a.report.max_error, 9), b.report.max_error);
    }
}

}  // namespace densify_law_test
}  // namespace batten
