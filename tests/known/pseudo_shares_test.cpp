#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "make/pseudo/tables/end_slopes.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "num/patch_kernel.hpp"
#include "random.hpp"

namespace batten {
namespace pseudo_shares_test {

using namespace pseudo;
using batten::testing::Random;
using std::numbers::pi;

/// A polynomial by powers about another point.
std::vector<double> shifted(std::vector<double> c, double to) {
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t k = c.size() - 1; k-- > i;) c[k] += to * c[k + 1];
    }
    return c;
}

/// What the polynomial is at least on [-1, 1]: on each of 16 parts no power takes more than its
/// coefficient away.
double at_least(const std::vector<double>& c) {
    constexpr int parts = 16;
    double least = 1e300;
    for (int i = 0; i < parts; ++i) {
        const std::vector<double> about = shifted(c, (2 * i + 1.0) / parts - 1);
        double bound = about[0], power = 1;
        for (std::size_t k = 1; k < about.size(); ++k) {
            power /= parts;
            bound -= std::fabs(about[k]) * power;
        }
        least = std::fmin(least, bound);
    }
    return least;
}

std::vector<double> derivative(const std::vector<double>& c) {
    std::vector<double> d;
    for (std::size_t k = 1; k < c.size(); ++k) d.push_back(static_cast<double>(k) * c[k]);
    return d;
}

/// J by powers of x.
std::vector<double> energy_of(const EndPiece& piece) {
    const double middle = 0.5 * (piece.lo + piece.hi), half = 0.5 * (piece.hi - piece.lo);
    std::vector<double> j(piece.energy.begin(), piece.energy.end());
    for (int i = 0; i < 2; ++i) {
        j.push_back(0);
        for (std::size_t k = j.size(); k-- > 0;) j[k] = middle * j[k] + (k > 0 ? half * j[k - 1] : 0);
    }
    return j;
}

// What makes the search for the least tangent complete: J grows, is convex between its kinks, and
// its slope falls at these.
TEST(TheFreeEnd, GrowsAndIsConvexBetweenItsKinks) {
    for (const EndPiece& piece : end_pieces()) {
        const double half = 0.5 * (piece.hi - piece.lo);
        const std::vector<double> slope = derivative(energy_of(piece));
        EXPECT_GT(at_least(derivative(slope)), 5.9 * half * half) << piece.lo;
        EXPECT_GE(slopes_on(piece, piece.lo).first, 0) << piece.lo;
    }
    for (const double kink : end_kinks()) {
        const EndPiece* const after = &piece_at(kink);
        EXPECT_GT(slopes_on(after[-1], kink).first, slopes_on(*after, kink).first) << kink;
    }
}

double energy_at(double turn, double weight, double u) {
    return tabulated_end(u).pseudo_energy + weight * tabulated_end(turn - u).pseudo_energy;
}

void expect_least(double turn, double weight) {
    constexpr int steps = 1000;
    const double u = tabulated_three_point_angle({turn, 1, weight}, 1);
    const double found = energy_at(turn, weight, u);
    for (int i = 0; i <= steps; ++i) {
        const double rival = energy_at(turn, weight, turn * i / steps);
        ASSERT_LE(found, rival * (1 + 1e-11)) << turn << ' ' << weight << ' ' << i;
    }
}

TEST(TheTabulatedRuleOfThreePoints, HasNoRivalAnywhereBetweenTheChords) {
    Random random(11);
    for (int i = 0; i < 300; ++i) expect_least(random.within(0.8, pi), random.within(0, 1));
}

TEST(TheTabulatedRuleOfThreePoints, HasNoRivalBesideItsTies) {
    for (const TurnPart& part : turn_parts()) {
        for (const auto& tie : part.ties) {
            for (const double x : {-0.9, -0.2, 0.4, 1.0}) {
                const double weight = patches::polynomial_8(tie.data(), x);
                if (weight == 0) continue;
                const double turn = 0.5 * (part.lo + part.hi) + 0.5 * (part.hi - part.lo) * x;
                for (const double off : {-1e-3, -1e-9, 1e-9, 1e-3}) {
                    if (weight + off > 0 && weight + off < 1) expect_least(turn, weight + off);
                }
            }
        }
    }
}

TEST(TheTabulatedRuleOfThreePoints, LeansToTheHeavierSideTheMoreTheHeavierItIs) {
    for (const double turn : {0.5, 0.93, 1.0, 1.3, 1.7, 1.9, 2.6, 3.1}) {
        double last = 0;
        for (int i = 1; i <= 500; ++i) {
            const double u = tabulated_three_point_angle({turn, 1, i / 500.0}, 1);
            EXPECT_GE(u, last - 1e-10) << turn << ' ' << i;
            EXPECT_LE(u, turn / 2 + 1e-10) << turn << ' ' << i;
            last = u;
        }
    }
}

}  // namespace pseudo_shares_test
}  // namespace batten
