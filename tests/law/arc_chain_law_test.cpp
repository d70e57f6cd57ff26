#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "batten/base/text.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/make/convert.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/curve.hpp"
#include "random.hpp"

namespace batten {
namespace arc_chain_law_test {

ArcChain any_chain(testing::Random& random) {
    std::vector<double> bulges;
    for (int i = 0; i < 5; ++i) bulges.push_back(random.within(-1.5, 1.5));
    bulges[2] = 0;
    return {random.points(6, 2), bulges};
}

TEST(ArcChain, TrimmedRunsThroughTheSamePoints) {
    testing::Random random(1);
    for (int round = 0; round < 50; ++round) {
        const ArcChain chain = any_chain(random);
        const double end = chain.breaks().back();
        const Interval part{random.within(0, 0.4) * end, random.within(0.6, 1) * end};
        const ArcChain kept = trimmed(chain, part);
        EXPECT_NEAR(kept.breaks().back(), part.length(), 1e-13 * end);
        for (int i = 0; i <= 40; ++i) {
            const double s = kept.breaks().back() * i / 40;
            const auto a = Curve(kept)(s), b = Curve(chain)(std::min(part.lo + s, part.hi));
            EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), 0, 1e-12);
        }
    }
}

TEST(ArcChain, TrimmedAtJointsKeepsWholeArcsBitForBit) {
    testing::Random random(2);
    const ArcChain chain = any_chain(random);
    const ArcChain kept = trimmed(chain, {chain.breaks()[1], chain.breaks()[4]});
    ASSERT_EQ(kept.arcs(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(kept.arc(i), chain.arc(i + 1));
    EXPECT_EQ(trimmed(chain, {0, chain.breaks().back()}), chain);
}

TEST(ArcChain, ReversedTwiceIsItself) {
    testing::Random random(3);
    const ArcChain chain = any_chain(random);
    EXPECT_EQ(reversed(reversed(chain)), chain);
    const double end = chain.breaks().back();
    for (int i = 0; i <= 20; ++i) {
        const auto a = Curve(chain)(end * i / 20), b = Curve(reversed(chain))(end - end * i / 20);
        EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), 0, 1e-13);
    }
}

TEST(ArcChain, ScaledByAPowerOfTwoIsScaledExactly) {
    testing::Random random(4);
    const ArcChain chain = any_chain(random), large = scaled(chain, 1024);
    EXPECT_EQ(scaled(large, 0x1p-10), chain);
    for (std::size_t i = 0; i <= chain.arcs(); ++i) {
        EXPECT_EQ(large.breaks()[i], 1024 * chain.breaks()[i]);
    }
}

TEST(ArcChain, StaysOneWhenItIsConverted) {
    testing::Random random(5);
    const ArcChain chain = any_chain(random);
    ConvertOptions options;
    options.trim = Interval{0.25 * chain.breaks().back(), 0.75 * chain.breaks().back()};
    options.reverse = true;
    options.scale = -2;
    EXPECT_NE(convert(chain, options).curve.shape<ArcChain>(), nullptr);
    options.as = Form::arcs;
    EXPECT_NE(convert(chain, options).curve.shape<ArcChain>(), nullptr);
    options.as = Form::cubic;
    options.tolerance = absolute(1e-6);
    const Conversion cubic = convert(chain, options);
    EXPECT_EQ(cubic.report.status, Status::met);
    EXPECT_LE(cubic.report.max_error, 1e-6);
}

TEST(SvgPicture, OfArcsShowsTheWholeOfThem) {
    // Three quarters of the unit circle from (1, 0): the box is the whole circle's.
    const ArcChain chain(Points({1, 0, 0, -1}, 2), {std::tan(3 * std::acos(-1.0) / 8)});
    const std::string picture = svg_picture(chain);
    const std::size_t at = picture.find("viewBox=\"") + 9;
    std::string_view box = std::string_view(picture).substr(at, picture.find('"', at) - at);
    for (const double side : {-1.08, -1.08, 2.16, 2.16}) {
        const std::size_t end = std::min(box.find(' '), box.size());
        EXPECT_NEAR(parse_number(box.substr(0, end)).value(), side, 1e-12);
        box.remove_prefix(std::min(end + 1, box.size()));
    }
    EXPECT_NE(picture.find(" A "), std::string::npos);
}

}  // namespace arc_chain_law_test
}  // namespace batten
