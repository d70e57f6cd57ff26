#include <gtest/gtest.h>

#include <cmath>

#include "batten/measure/arc_length_map.hpp"
#include "batten/measure/length.hpp"
#include "curves.hpp"
#include "random.hpp"

namespace batten {
namespace arc_length_map_sweep_test {

using namespace batten::testing;

TEST(ArcLengthMapSweep, ReachesTheToleranceAskedForOnRandomCubics) {
    Random random(71);
    for (int round = 0; round < 30; ++round) {
        const int dim = 2 + round % 2;
        const Points control = random.points(4, dim);
        const std::vector<double> numbers(control.coordinates().begin(),
                                          control.coordinates().end());
        const Curve curve = bezier(numbers, dim);
        const double whole = length(curve).value;
        for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
            const ArcLengthMap map(curve, relative(tolerance));
            EXPECT_LE(std::fabs(map.length() - whole), tolerance * whole);
            for (int i = 1; i < 20; ++i) {
                const double s = map.length() * random.within(0, 1), t = map.t_of(s);
                const double found = length(curve, Interval{0, t}, relative(1e-14)).value;
                EXPECT_LE(std::fabs(found - s), tolerance * whole) << tolerance;
                EXPECT_LE(std::fabs(map.s_of(t) - found), tolerance * whole) << tolerance;
            }
        }
    }
}

/// Pieces that neither bend nor change speed alike, with joints in between.
Curve random_chain(Random& random, std::size_t pieces, int dim) {
    const Points points = random.points(pieces + 1, dim);
    Points slopes = random.points(pieces + 1, dim);
    for (double& x : slopes.coordinates()) x *= 4;
    return hermite(points, slopes);
}

TEST(ArcLengthMapSweep, ReachesTheToleranceAllAlongChains) {
    Random random(72);
    for (int round = 0; round < 6; ++round) {
        const Curve curve = random_chain(random, 12, 2 + round % 2);
        const double whole = length(curve, relative(1e-15)).value;
        for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
            const ArcLengthMap map(curve, relative(tolerance));
            EXPECT_LE(std::fabs(map.length() - whole), tolerance * whole);
            std::vector<double> s, t(40);
            for (int i = 0; i < 40; ++i) s.push_back(map.length() * (i + 0.5) / 40);
            map.t_of(s, t);
            for (std::size_t i = 0; i < s.size(); ++i) {
                const double found = length(curve, Interval{0, t[i]}, relative(1e-14)).value;
                EXPECT_LE(std::fabs(found - s[i]), tolerance * whole) << tolerance;
                EXPECT_LE(std::fabs(map.s_of(t[i]) - found), tolerance * whole) << tolerance;
            }
        }
    }
}

TEST(ArcLengthMapSweep, TakesAbsoluteTolerancesInDataUnits) {
    const Curve curve = bezier({0, 0, 1000, 1, -1000, 1, 1, 0});
    for (const double tolerance : {1.0, 1e-3, 1e-6, 1e-9}) {
        const ArcLengthMap map(curve, absolute(tolerance));
        EXPECT_LE(map.error(), tolerance);
        const double t = map.t_of(0.3 * map.length());
        EXPECT_NEAR(length(curve, Interval{0, t}).value, 0.3 * map.length(), tolerance);
    }
}

}  // namespace arc_length_map_sweep_test
}  // namespace batten
