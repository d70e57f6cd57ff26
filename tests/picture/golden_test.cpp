#include <gtest/gtest.h>

#include "pictures.hpp"
#include "shared.hpp"

// Each of these has been looked at. After a change on purpose: BATTEN_GOLDEN=accept, and look.
namespace batten::testing {
namespace golden_test {

TEST(Picture, OfPointsShowsMarkersCornersAndNumbers) {
    EXPECT_TRUE(is_golden("points.svg", svg(points_picture())));
}

TEST(Picture, OfACurveIsMadeOfItsOwnCubics) {
    EXPECT_TRUE(is_golden("outline.svg", svg(outline_picture())));
}

TEST(Picture, OfAnAerofoilShowsItsComb) {
    SKIP_UNLESS_SHARED("data/rae2822.dat");
    const CsvTable table = parse_csv([] {
        std::string text = "x,y\n" + read_text(*shared_file("data/rae2822.dat"));
        text.erase(4, text.find('\n', 4) - 3);
        for (std::size_t i = 4; i < text.size(); ++i) {
            if (text[i] == ' ') text[i] = ',';
        }
        return text;
    }());
    Points points(0, 2);
    for (std::size_t i = 0; i + 1 < table.rows.size(); ++i) {
        points.push_back(std::array{table.number(i, "x"), table.number(i, "y")});
    }
    EXPECT_TRUE(is_golden("aerofoil.svg", svg(aerofoil_picture(points))));
}

TEST(Picture, OfADropShowsWhereItsCombBreaks) {
    EXPECT_TRUE(is_golden("drop.svg", svg(drop_picture())));
}

TEST(Picture, OfNeedlesShowsHowSharpTheyAre) {
    EXPECT_TRUE(is_golden("needles.svg", svg(needle_picture())));
}

TEST(Picture, OfARangeIsCutThere) {
    EXPECT_TRUE(is_golden("cut.svg", svg(cut_picture())));
}

TEST(Picture, OfAStraightLineShowsTicksAndATangent) {
    EXPECT_TRUE(is_golden("line.svg", svg(line_picture())));
}

TEST(Picture, OfALongThinShapeStaysLegible) {
    EXPECT_TRUE(is_golden("ruler.svg", svg(ruler_picture())));
}

TEST(Picture, WithTwoPanelsSharesScaleAndLegend) {
    EXPECT_TRUE(is_golden("comparison.svg", svg(comparison_picture())));
}

TEST(Picture, WithSixPanelsNumbersTheOuterAxesOnly) {
    EXPECT_TRUE(is_golden("small_multiples.svg", svg(small_multiples_picture())));
}

TEST(Picture, OfErrorsHasLogarithmicAxes) {
    EXPECT_TRUE(is_golden("convergence.svg", svg(convergence_picture())));
}

TEST(Picture, OfCurvatureBreaksWhereItJumps) {
    EXPECT_TRUE(is_golden("curvature.svg", svg(curvature_picture())));
}

TEST(Picture, OfASpaceCurveShowsBoxShadowAndComb) {
    EXPECT_TRUE(is_golden("helix.svg", svg(helix_picture())));
}

TEST(Picture, WithoutAxesHoldsTheCurveAlone) {
    EXPECT_TRUE(is_golden("bare.svg", svg(bare_picture())));
}

TEST(Picture, FarFromTheOriginNotesTheOffset) {
    const Points points({1e9, 1e9, 1e9 + 1e-3, 1e9 + 5e-4, 1e9 + 2e-3, 1e9}, 2);
    EXPECT_TRUE(is_golden("offset.svg", svg(joined_points(points, "Near 10^9"))));
}

}  // namespace golden_test
}  // namespace batten::testing
