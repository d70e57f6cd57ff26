#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "batten/base/text.hpp"
#include "batten/io/dxf.hpp"
#include "batten/shape/arc_chain.hpp"
#include "curves.hpp"

namespace batten {
namespace dxf_test {

using Pair = std::pair<int, std::string>;

/// The pairs of a DXF file; fails unless they are complete.
std::vector<Pair> pairs_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        EXPECT_NE(end, std::string::npos);
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    EXPECT_EQ(lines.size() % 2, 0u);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        pairs.emplace_back(static_cast<int>(parse_integer(lines[i]).value()), lines[i + 1]);
    }
    return pairs;
}

/// The entities, each from its `0` pair on.
std::vector<std::vector<Pair>> entities_of(const std::string& text) {
    std::vector<std::vector<Pair>> entities;
    bool inside = false;
    for (const Pair& pair : pairs_of(text)) {
        if (pair == Pair{2, "ENTITIES"}) inside = true;
        if (pair == Pair{0, "ENDSEC"}) inside = false;
        if (!inside || pair.first == 2) continue;
        if (pair.first == 0) entities.emplace_back();
        entities.back().push_back(pair);
    }
    return entities;
}

std::vector<double> numbers(const std::vector<Pair>& entity, int code) {
    std::vector<double> result;
    for (const Pair& pair : entity) {
        if (pair.first == code) result.push_back(parse_number(pair.second).value());
    }
    return result;
}

const ArcChain half_round(Points({0, 0, 2, 0, 2, 2, 0, 2}, 2), {0, 1, 0});

TEST(Dxf, WritesAChainAsOnePolylineWithBulges) {
    const auto entities = entities_of(dxf(Curve(half_round)));
    ASSERT_EQ(entities.size(), 1u);
    EXPECT_EQ(entities[0][0], (Pair{0, "LWPOLYLINE"}));
    EXPECT_EQ(numbers(entities[0], 10), (std::vector<double>{0, 2, 2, 0}));
    EXPECT_EQ(numbers(entities[0], 20), (std::vector<double>{0, 0, 2, 2}));
    EXPECT_EQ(numbers(entities[0], 42), std::vector<double>{1});
    EXPECT_EQ(numbers(entities[0], 70), std::vector<double>{0});
}

TEST(Dxf, WritesR12WithoutAnythingNewer) {
    DxfOptions options;
    options.version = DxfVersion::r12;
    const std::string text = dxf(Curve(half_round), options);
    for (const Pair& pair : pairs_of(text)) {
        EXPECT_NE(pair.first, 100);  // subclass markers came with R13
        EXPECT_NE(pair.second, "LWPOLYLINE");
    }
    const auto entities = entities_of(text);
    ASSERT_EQ(entities.size(), 6u);
    EXPECT_EQ(entities.front()[0].second, "POLYLINE");
    EXPECT_EQ(entities.back()[0].second, "SEQEND");
    EXPECT_EQ(numbers(entities[2], 42), std::vector<double>{1});
}

TEST(Dxf, WritesArcsCounterClockwise) {
    DxfOptions options;
    options.arcs = DxfArcs::separate;
    for (const double bulge : {std::sqrt(2) - 1, 1 - std::sqrt(2)}) {
        // A quarter of the circle round (0, 0) or (1, 1), turning left or right.
        const auto entities =
            entities_of(dxf(Curve(ArcChain(Points({1, 0, 0, 1}, 2), {bulge})), options));
        ASSERT_EQ(entities.size(), 1u);
        EXPECT_EQ(entities[0][0].second, "ARC");
        const double middle = bulge > 0 ? 0 : 1;
        EXPECT_NEAR(numbers(entities[0], 10)[0], middle, 1e-15);
        EXPECT_NEAR(numbers(entities[0], 20)[0], middle, 1e-15);
        EXPECT_NEAR(numbers(entities[0], 40)[0], 1, 1e-15);
        EXPECT_NEAR(numbers(entities[0], 50)[0], bulge > 0 ? 0 : 180, 1e-13);
        EXPECT_NEAR(numbers(entities[0], 51)[0], bulge > 0 ? 90 : 270, 1e-13);
    }
}

TEST(Dxf, WritesCubicPiecesAsOneSplineThroughTheirControlPoints) {
    const Curve piece = testing::bezier({0, 0, 1, 2, 3, 2.5, 4, 0});
    const auto entities = entities_of(dxf(piece));
    ASSERT_EQ(entities.size(), 1u);
    EXPECT_EQ(entities[0][0].second, "SPLINE");
    EXPECT_EQ(numbers(entities[0], 71), std::vector<double>{3});
    EXPECT_EQ(numbers(entities[0], 40), (std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1}));
    const std::vector<double> x = numbers(entities[0], 10), y = numbers(entities[0], 20);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(x[i], (std::vector{0., 1., 3., 4.})[i], 1e-14);
        EXPECT_NEAR(y[i], (std::vector{0., 2., 2.5, 0.})[i], 1e-14);
    }
}

}  // namespace dxf_test
}  // namespace batten
