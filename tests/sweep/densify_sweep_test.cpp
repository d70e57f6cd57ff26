#include <cmath>
#include <numbers>

#include "batten/make/densify.hpp"
#include "batten/make/thin.hpp"
#include "shared.hpp"

namespace batten {
namespace densify_sweep_test {

Points spiral(int dim) {
    Points points(0, dim);
    for (int i = 0; i <= 24; ++i) {
        const double t = 0.35 * i;
        std::vector<double> row{t * std::cos(t), t * std::sin(t), 0.3 * t * t};
        row.resize(static_cast<std::size_t>(dim));
        points.push_back(row);
    }
    return points;
}

double distance(std::span<const double> p, std::span<const double> a, std::span<const double> b) {
    double along = 0, length_sq = 0, sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
        along += (p[k] - a[k]) * (b[k] - a[k]);
        length_sq += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double s = std::clamp(along / length_sq, 0.0, 1.0);
    for (std::size_t k = 0; k < p.size(); ++k) {
        sum += std::pow(p[k] - a[k] - s * (b[k] - a[k]), 2);
    }
    return std::sqrt(sum);
}

/// The largest distance of the curve, at 40 places a chord, from the chords of the points made.
double chord_error(const Densified& result, const Points& given) {
    double largest = 0;
    std::size_t row = 0;
    for (std::size_t cell = 0; cell + 1 < given.size(); ++cell) {
        std::size_t steps = 1;
        const auto next = given.view()[cell + 1];
        while (!std::equal(next.begin(), next.end(), result.points.view()[row + steps].begin())) {
            ++steps;
        }
        const double lo = result.curve.breaks()[cell], hi = result.curve.breaks()[cell + 1];
        for (std::size_t i = 0; i < 40 * steps; ++i) {
            const double s = (static_cast<double>(i) + 0.5) / (40 * static_cast<double>(steps));
            const std::size_t chord = row + i / 40;
            largest = std::max(largest, distance(result.curve(lo + s * (hi - lo)),
                                                 result.points.view()[chord],
                                                 result.points.view()[chord + 1]));
        }
        row += steps;
    }
    return largest;
}

TEST(DensifySweep, NoPointOfTheCurveIsFurtherFromItsChordThanAsked) {
    for (const int degree : {1, 2, 3, 4, 7}) {
        for (const int dim : {2, 3}) {
            for (int power = 0; power >= -5; --power) {
                DensifyOptions options;
                options.degree = degree;
                options.tolerance = absolute(std::pow(10, power));
                const Points given = spiral(dim);
                const Densified result = densify(given, options);
                const double error = chord_error(result, given);
                EXPECT_LE(error, options.tolerance->value) << degree << ' ' << dim;
                EXPECT_LE(error, result.report.max_chord_error * (1 + 1e-5) + 1e-14);
                EXPECT_GE(error, result.report.max_chord_error * (1 - 1e-2) - 1e-14);
            }
        }
    }
}

TEST(DensifySweep, TheGuaranteeCostsNoMoreThanTheAsymptoticOptimumForEachCell) {
    // A circle of radius 1 in 64 cells: a chord of angle a is off by a^2 / 8.
    Points circle(2);
    for (int i = 0; i < 64; ++i) {
        const double t = i * std::numbers::pi / 32;
        circle.push_back(std::vector{std::cos(t), std::sin(t)});
    }
    for (int power = -3; power >= -9; --power) {
        DensifyOptions options;
        options.closed = true;
        options.tolerance = absolute(std::pow(10, power));
        const double steps =
            std::ceil(std::numbers::pi / 32 / std::sqrt(8 * options.tolerance->value) * 1.01);
        EXPECT_LE(densify(circle, options).points.size(), 64 * static_cast<std::size_t>(steps));
    }
}

TEST(ThinSweep, TheKeptPointsCurveIsWithinTheTolerance) {
    DensifyOptions fine;
    fine.between = 9;
    const Points given = densify(spiral(2), fine).points;
    std::size_t before = 0;
    for (int power = 0; power >= -4; --power) {
        ThinOptions options;
        options.tolerance = absolute(std::pow(10, power));
        const Thinned result = thin(given, options);
        fine.between = 100;
        const Points dense = densify(result.points, fine).points;
        double largest = 0;
        for (std::size_t i = 0; i < given.size(); i += 3) {
            double nearest = 1e300;
            for (std::size_t k = 0; k + 1 < dense.size(); ++k) {
                nearest = std::min(nearest, distance(given.view()[i], dense.view()[k],
                                                     dense.view()[k + 1]));
            }
            largest = std::max(largest, nearest);
        }
        EXPECT_LE(largest, options.tolerance.value * (1 + 1e-3));
        EXPECT_LE(result.report.max_error, options.tolerance.value);
        EXPECT_GE(result.points.size(), before);
        before = result.points.size();
    }
}

}  // namespace densify_sweep_test
}  // namespace batten
