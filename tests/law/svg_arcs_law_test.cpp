#include <gtest/gtest.h>

#include <cmath>

#include "batten/io/svg_arcs.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/shape/curve.hpp"
#include "random.hpp"

namespace batten {
namespace svg_arcs_law_test {

TEST(SvgArcs, AreWrittenWithTrueArcs) {
    EXPECT_EQ(svg_path(ArcChain(Points({0, 0, 2, 0, 2, 2}, 2), {0, 1})),
              "M 0 0 L 2 0 A 1 1 0 0 1 2 2");
    EXPECT_EQ(svg_path(ArcChain(Points({1, 0, -1, 0, 1, 0}, 2), {-1, -1}, true)),
              "M 1 0 A 1 1 0 0 0 -1 0 A 1 1 0 0 0 1 0 Z");
}

TEST(SvgArcs, AreReadBackAsTheSameArcs) {
    testing::Random random(4);
    for (int round = 0; round < 100; ++round) {
        const Points joints = random.points(6, 2);
        std::vector<double> bulges;
        for (int i = 0; i < 5; ++i) bulges.push_back(random.within(-2, 2));
        const ArcChain chain(joints, bulges);
        const Curve read = parse_svg_path(svg_path(chain), "path");
        std::size_t piece = 0;  // an arc is read as pieces of a quarter turn at most
        for (std::size_t i = 0; i < chain.arcs(); ++i) {
            const Arc arc = chain.arc(i);
            const auto [cx, cy] = *arc.center();
            EXPECT_NEAR(read(read.piece(piece).lo)[0], arc.start[0], 1e-15);
            double to_end = 1;
            for (double turn = 0; to_end > 1e-15 && piece < read.pieces(); ++piece) {
                for (int k = 0; k <= 10; ++k) {
                    const Interval part = read.piece(piece);
                    const Jet p = read.jet_on(piece, part.lo + part.length() * k / 10, 0);
                    EXPECT_NEAR(std::hypot(p[0][0] - cx, p[0][1] - cy), *arc.radius(),
                                1e-7 * *arc.radius());
                    to_end = std::hypot(p[0][0] - arc.end[0], p[0][1] - arc.end[1]);
                }
                turn += 1.5708;
                EXPECT_LT(turn, std::fabs(arc.sweep()) + 1.5709);
            }
            EXPECT_LE(to_end, 1e-15);
        }
        EXPECT_EQ(piece, read.pieces());
    }
}

}  // namespace svg_arcs_law_test
}  // namespace batten
