#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/io/dxf.hpp"
#include "batten/io/gcode.hpp"
#include "batten/make/densify.hpp"
#include "batten/shape/arc_chain.hpp"
#include "curves.hpp"
#include "errors.hpp"

namespace batten {
namespace dxf_bad_test {

using testing::code_of;
using testing::nan;

TEST(DxfBad, InputIsNamed) {
    const Curve piece = testing::bezier({0, 0, 1, 2, 3, 2.5, 4, 0});
    const Curve one = testing::polyline(Points({0, 1, 3}, 1));
    EXPECT_EQ(code_of([&] { dxf(one); }), "curve.dimension");
    DxfOptions options;
    options.version = DxfVersion::r12;
    EXPECT_EQ(code_of([&] { dxf(piece, options); }), "dxf.needs-r2000");
    DensifyOptions high;
    high.degree = 5;
    const Points points({0, 0, 1, 1, 2, 0, 3, 1, 4, 0, 5, 1}, 2);
    EXPECT_EQ(code_of([&] { dxf(densify(points, high).curve); }), "curve.not-exact");
    for (const char* layer : {"", "a b", "a\n0", "1234567890123456789012345678901_"}) {
        options = {};
        options.layer = layer;
        EXPECT_EQ(code_of([&] { dxf(piece, options); }), "dxf.layer") << layer;
    }
}

TEST(GcodeBad, InputIsNamed) {
    const ArcChain chain(Points({0, 0, 1, 0, 2, 1}, 2), {0, 0.2});
    const auto code = [&](const GcodeOptions& options, const std::vector<double>& feeds = {}) {
        return code_of([&] { gcode(chain, options, feeds); });
    };
    EXPECT_EQ(code({}), "none");
    for (const double feed : {0.0, -1.0, nan}) EXPECT_EQ(code({.feed = feed}), "option.range");
    EXPECT_EQ(code({.decimals = -1}), "option.range");
    EXPECT_EQ(code({.decimals = 10}), "option.range");
    EXPECT_EQ(code({.z = nan}), "option.range");
    EXPECT_EQ(code({}, {100}), "gcode.feeds");
    EXPECT_EQ(code({}, {100, 0}), "option.range");
    const ArcChain huge(Points({0, 0, 1e14, 0}, 2), {0});
    EXPECT_EQ(code_of([&] { gcode(huge); }), "gcode.too-large");
}

}  // namespace dxf_bad_test
}  // namespace batten
