#include "batten/make/fit_scattered.hpp"
#include "surface_samples.hpp"

/// Surfaces that the samples determine only just, or not at all, are still those of least squares.
namespace batten {
namespace fit_surface_delicate_test {

using namespace testing;

std::vector<double> uneven_lines(std::size_t count, Noise& noise) {
    std::vector<double> lines;
    for (std::size_t i = 0; i < count; ++i) lines.push_back(10 * noise.uniform());
    std::sort(lines.begin(), lines.end());
    return lines;
}

/// The largest product of the residuals with a spline, of what its parts would come to.
template <class Samples>
double largest_cosine(const SplineSurface& surface, const Samples& samples) {
    double largest = 0;
    for (std::size_t k = 0; k < surface.coefficients().size(); ++k) {
        std::vector<double> c(surface.coefficients().size(), 0.0);
        c[k] = 1;
        const SplineSurface one(surface.x_basis(), surface.y_basis(), c);
        double dot = 0, spline_sq = 0, all_sq = 0;
        for (std::size_t n = 0; n < samples.z.size(); ++n) {
            const double value = one(samples.x[n], samples.y[n]);
            const double e = samples.z[n] - surface(samples.x[n], samples.y[n]);
            dot += value * e;
            spline_sq += value * value;
            all_sq += samples.z[n] * samples.z[n];
        }
        if (spline_sq > 0) {
            largest = std::max(largest, std::fabs(dot) / std::sqrt(spline_sq * all_sq));
        }
    }
    return largest;
}

struct Rows {
    std::vector<double> x, y, z;
};

TEST(DelicateGrid, LeavesNoMoreThanNoSurfaceAtAll) {
    int regular = 0, open = 0;
    for (int seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(seed);
        Noise noise(static_cast<std::uint64_t>(seed));
        SurfaceTable table{uneven_lines(23, noise), uneven_lines(24, noise)};
        table.z = Grid(23, 24);
        Rows rows;
        double all_sq = 0;
        for (std::size_t i = 0; i < 23; ++i) {
            for (std::size_t j = 0; j < 24; ++j) {
                table.z(i, j) = std::sin(table.x[i]) * std::cos(table.y[j]) + 0.05 * noise.normal();
                rows.x.push_back(table.x[i]);
                rows.y.push_back(table.y[j]);
                rows.z.push_back(table.z(i, j));
                all_sq += table.z(i, j) * table.z(i, j);
            }
        }
        FitSurfaceOptions options;
        options.degree = 4;
        options.knots = SurfaceKnots::given;
        const std::vector<double> breaks = even_places({table.x.front(), table.x.back()}, 15);
        options.x_knots.assign(breaks.begin() + 1, breaks.end() - 1);
        options.y_knots = {table.y[8], table.y[16]};
        options.sigma = 1;
        const SurfaceFit fit = fit_surface(table.view(), options);
        EXPECT_LE(fit.report.delta2, all_sq);
        if (fit.report.status == Status::met) {
            ++regular;
            EXPECT_LT(largest_cosine(fit.surface, rows), 1e-9);
        } else {
            ++open;
            EXPECT_EQ(fit.report.status, Status::rank_deficient);
            EXPECT_FALSE(fit.report.undetermined.empty());
        }
    }
    EXPECT_GT(regular, 0);
    EXPECT_GT(open, 0);
}

/// Splines without a line of their own, a node missing: a plane more is a plane more.
TEST(DelicateGrid, WithAHoleTakesAnyHeightForGround) {
    const auto land = [](double ground) {
        SurfaceTable table{even_places({0, 8}, 9), even_places({0, 5}, 6)};
        table.z = Grid(9, 6);
        for (std::size_t i = 0; i < 9; ++i) {
            for (std::size_t j = 0; j < 6; ++j) {
                table.z(i, j) = ground + std::sin(table.x[i]) * std::cos(table.y[j]);
            }
        }
        table.z.drop(4, 3);
        FitSurfaceOptions options;
        options.knots = SurfaceKnots::given;
        options.x_knots = {7.9};
        options.y_knots = {2.2, 2.4, 2.6, 2.8};
        options.sigma = 0.02;
        return fit_surface(table.view(), options);
    };
    const SurfaceFit low = land(0), high = land(100);
    EXPECT_EQ(high.report.status, Status::rank_deficient);
    EXPECT_NEAR(high.report.delta2 / low.report.delta2, 1, 1e-6);
    const std::span<const double> a = low.surface.coefficients(), b = high.surface.coefficients();
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(b[k], a[k] + 100, 0.01);
}

TEST(DelicateGrid, TellsWhereAMissingCornerLetsTheSurfaceGo) {
    const auto wave = [](double x, double y) { return std::sin(6 * x) * std::cos(5 * y); };
    SurfaceTable table = surface_of(wave, 20, 15, 0.02);
    const auto notes = [&] {
        FitSurfaceOptions options;
        options.knots = SurfaceKnots::equal;
        options.intervals = {6, 6};
        options.sigma = 0.02;
        const std::vector<std::string> all = fit_surface(table.view(), options).report.notes;
        return std::count_if(all.begin(), all.end(), [](const std::string& note) {
            return note.starts_with("between the samples the surface goes from ");
        });
    };
    EXPECT_EQ(notes(), 0);
    table.z.drop(10, 7);
    EXPECT_EQ(notes(), 0);
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < 9; ++j) table.z.drop(i, j);
    }
    EXPECT_EQ(notes(), 1);
}

TEST(DelicateCloud, LeavesNothingThatSplinesSee) {
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        Noise noise(static_cast<std::uint64_t>(seed));
        Rows rows;
        for (int n = 0; n < 92; ++n) {
            rows.x.push_back(noise.uniform());
            rows.y.push_back(noise.uniform());
            rows.z.push_back(std::sin(5 * rows.x.back()) * std::cos(3 * rows.y.back()) +
                             0.05 * noise.normal());
        }
        FitSurfaceOptions options;
        options.degree = 5;
        options.knots = SurfaceKnots::equal;
        options.intervals = {5, 3};
        options.sigma = 0.05;
        const SurfaceFit fit = fit_scattered({rows.x, rows.y, rows.z}, options);
        EXPECT_LT(largest_cosine(fit.surface, rows), 1e-9);
    }
}

}  // namespace fit_surface_delicate_test
}  // namespace batten
