#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/text.hpp"
#include "batten/io/gcode.hpp"
#include "batten/shape/curve.hpp"
#include "random.hpp"

namespace batten {
namespace gcode_test {

constexpr double pi = std::numbers::pi;

/// One move of a program, as a machine understands it.
struct Move {
    int kind = 0;  ///< 0 rapid, 1 straight, 2 clockwise, 3 counter-clockwise
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0, cx = 0, cy = 0, feed = 0;

    double start_radius() const { return std::hypot(x0 - cx, y0 - cy); }
    double end_radius() const { return std::hypot(x1 - cx, y1 - cy); }
    /// Signed, counter-clockwise positive.
    double sweep() const {
        const double a = std::atan2(y0 - cy, x0 - cx), b = std::atan2(y1 - cy, x1 - cx);
        const double turn = kind == 3 ? b - a : a - b;
        return (kind == 3 ? 1 : -1) * (turn > 0 ? turn : turn + 2 * pi);
    }
    std::array<double, 2> at(double share) const {
        if (kind < 2) return {x0 + share * (x1 - x0), y0 + share * (y1 - y0)};
        const double a = std::atan2(y0 - cy, x0 - cx) + share * sweep();
        const double r = start_radius() + share * (end_radius() - start_radius());
        return {cx + r * std::cos(a), cy + r * std::sin(a)};
    }
};

/// Runs a program; fails at what it does not know.
std::vector<Move> run(const std::string& program) {
    std::vector<Move> moves;
    double x = 0, y = 0, feed = 0;
    for (std::size_t at = 0; at < program.size();) {
        const std::size_t end = program.find('\n', at);
        std::string line = program.substr(at, end - at) + ' ';
        at = end + 1;
        Move move;
        move.x0 = move.x1 = x;
        move.y0 = move.y1 = y;
        bool moves_in_plane = false;
        while (line.find_first_not_of(' ') != std::string::npos) {
            const std::size_t blank = line.find(' ');
            const char letter = line[0];
            const double value = parse_number(line.substr(1, blank - 1)).value();
            line.erase(0, blank + 1);
            if (letter == 'G' && value <= 3) move.kind = static_cast<int>(value);
            if (letter == 'X') move.x1 = value;
            if (letter == 'Y') move.y1 = value;
            if (letter == 'I') move.cx = x + value;
            if (letter == 'J') move.cy = y + value;
            if (letter == 'F') feed = value;
            moves_in_plane = moves_in_plane || letter == 'X';
            EXPECT_NE(std::string("GXYZIJFM").find(letter), std::string::npos) << letter;
        }
        move.feed = feed;
        if (!moves_in_plane) continue;
        x = move.x1;
        y = move.y1;
        moves.push_back(move);
    }
    return moves;
}

ArcChain random_chain(unsigned seed) {
    testing::Random random(seed);
    Points joints(0, 2);
    std::vector<double> bulges;
    double x = 0, y = 0;
    for (int i = 0; i < 30; ++i) {
        joints.push_back(std::vector{x, y});
        x += random.within(-20, 20);
        y += random.within(-20, 20);
        const double size = std::pow(10, random.within(-7, 0.5));
        if (i < 29) bulges.push_back(random.whole(0, 5) == 0 ? 0 : random.within(-1, 1) * size);
    }
    return {joints, bulges};
}

TEST(Gcode, IsTheProgramThatAPersonWouldWrite) {
    GcodeOptions options;
    options.z = -0.5;
    options.feed = 300;
    options.header = "M3";
    const ArcChain chain(Points({0, 0, 10, 0, 10, 5, 0, 5}, 2), {0, 1, 0});
    EXPECT_EQ(gcode(chain, options),
              "M3\nG21\nG90\nG17\nG0 X0 Y0\nG1 Z-0.5 F300\nG1 X10 Y0\nG3 X10 Y5 I0 J2.5\n"
              "G1 X0 Y5\nM2\n");
    options.units = GcodeUnits::inch;
    options.footer.clear();
    options.z.reset();
    options.header.clear();
    const ArcChain right(Points({0, 0, 1, 1}, 2), {1 - std::sqrt(2)});
    EXPECT_EQ(gcode(right, options), "G20\nG90\nG17\nG0 X0 Y0\nG2 X1 Y1 I1 J0 F300\n");
}

/// How many arcs of the chain are higher over their chord than a last decimal.
int clear_arcs(const ArcChain& chain, double unit) {
    int count = 0;
    for (std::size_t i = 0; i < chain.arcs(); ++i) {
        const Arc arc = chain.arc(i);
        const double chord = std::hypot(arc.end[0] - arc.start[0], arc.end[1] - arc.start[1]);
        if (0.5 * chord * std::fabs(arc.bulge) > unit) ++count;
    }
    return count;
}

TEST(Gcode, StartAndEndRadiiAgreeToTheLastDecimal) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const ArcChain chain = random_chain(seed);
        for (const int decimals : {2, 3, 5}) {
            GcodeOptions options;
            options.decimals = decimals;
            const double unit = std::pow(10, -decimals);
            int arcs = 0;
            for (const Move& move : run(gcode(chain, options))) {
                if (move.kind < 2) continue;
                ++arcs;
                EXPECT_LE(std::fabs(move.start_radius() - move.end_radius()), unit * (1 + 1e-6));
                EXPECT_LE(std::fabs(move.sweep()), pi + 0.1);
            }
            EXPECT_GE(arcs, clear_arcs(chain, unit));
        }
    }
}

TEST(Gcode, FollowsTheChainWithinTwoLastDecimals) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const ArcChain chain = random_chain(seed);
        const Curve curve(chain);
        GcodeOptions options;
        options.decimals = 3;
        const std::vector<Move> moves = run(gcode(chain, options));
        std::size_t next = 1;
        for (std::size_t i = 0; i < chain.arcs(); ++i) {
            const bool is_major = std::fabs(chain.bulges()[i]) > 1;
            const std::size_t parts = is_major ? 2 : 1;
            for (std::size_t part = 0; part < parts; ++part, ++next) {
                ASSERT_LT(next, moves.size());
                for (int k = 0; k <= 8; ++k) {
                    const double share = (static_cast<double>(part) + k / 8.0) /
                                         static_cast<double>(parts);
                    const double lo = chain.breaks()[i], hi = chain.breaks()[i + 1];
                    const std::vector<double> wanted = curve(lo + share * (hi - lo));
                    const std::array<double, 2> made = moves[next].at(k / 8.0);
                    EXPECT_LE(std::hypot(made[0] - wanted[0], made[1] - wanted[1]), 2e-3)
                        << seed << ' ' << chain.bulges()[i];
                }
            }
        }
        EXPECT_EQ(next, moves.size());
    }
}

TEST(Gcode, LeavesOutMovesThatRoundToNothing) {
    const ArcChain chain(Points({0, 0, 1, 0, 1.0002, 0.0001, 2, 0}, 2), {0.5, 0.5, 0});
    const std::vector<Move> moves = run(gcode(chain));
    ASSERT_EQ(moves.size(), 3u);
    EXPECT_EQ(moves[2].kind, 1);
    EXPECT_EQ(moves[2].x0, 1);
}

TEST(Gcode, TakesASpeedForEachArc) {
    const ArcChain chain(Points({0, 0, 1, 0, 2, 0, 3, 0}, 2), {0, 0, 0});
    const std::vector<double> feeds{100, 100, 250.5};
    const std::vector<Move> moves = run(gcode(chain, {}, feeds));
    ASSERT_EQ(moves.size(), 4u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(moves[i + 1].feed, feeds[i]);
}

/// The program that `convert` writes for a chain.
std::vector<Move> converted(const ArcChain& chain, std::vector<Setting> settings) {
    const Input input{"chain", Curve(chain)};
    settings.push_back({"feed", "600"});
    const Outcome outcome = find_operation("convert")->run({&input, 1}, settings, {});
    for (const OutputForm& form : outcome.forms) {
        if (form.name == "gcode") return run(form.text());
    }
    ADD_FAILURE() << "no G-code";
    return {};
}

TEST(Gcode, FeedsFollowALawOfMotion) {
    const ArcChain line(Points({0, 0, 1, 0, 2, 0, 3, 0, 4, 0}, 2), {0, 0, 0, 0});
    const std::vector<Move> moves = converted(line, {{"feed_law", "accelerate"}});
    ASSERT_EQ(moves.size(), 5u);
    for (int i = 0; i < 4; ++i) {  // s = 4 tau^2
        const double time = std::sqrt((i + 1) / 4.0) - std::sqrt(i / 4.0);
        const double last = 1 - std::sqrt(3 / 4.0);
        EXPECT_NEAR(moves[i + 1].feed, 600 * last / time, 1e-5 * 600) << i;
        EXPECT_LE(moves[i + 1].feed, 600);
    }
}

TEST(Gcode, FeedsKeepTheLimitsOfTheFastestMotion) {
    // From rest over a line of 40, a half circle of radius 4 and back. 600 a minute are 10 a second.
    const ArcChain hairpin(Points({0, 0, 20, 0, 40, 0, 40, 8, 20, 8, 0, 8}, 2), {0, 0, 1, 0, 0});
    const std::vector<Move> moves =
        converted(hairpin, {{"feed_law", "time-optimal"}, {"max_lateral", "9"},
                            {"max_tangential", "2"}});
    ASSERT_EQ(moves.size(), 6u);
    const double bend = 6;  // sqrt(9 x 4)
    EXPECT_NEAR(moves[3].feed, 60 * bend, 1e-4 * 60 * bend);
    // v^2 = 4 s from rest, and v^2 = 36 + 4 (40 - s) before the bend: they meet at s = 24.5.
    const double middle = std::sqrt(80.0), crest = std::sqrt(98.0);
    EXPECT_NEAR(moves[1].feed, 60 * middle / 2, 1e-4 * 600);
    const double time = (crest - middle) / 2 + (crest - bend) / 2;
    EXPECT_NEAR(moves[2].feed, 60 * 20 / time, 1e-4 * 600);
    EXPECT_NEAR(moves[4].feed, moves[2].feed, 1e-2);
    EXPECT_NEAR(moves[5].feed, moves[1].feed, 1e-2);
}

}  // namespace gcode_test
}  // namespace batten
