#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "batten/base/error.hpp"
#include "batten/make/pseudo_segment.hpp"
#include "errors.hpp"

namespace batten {
namespace pseudo_bad_test {

using testing::code_and_place_of;
using testing::inf;
using testing::nan;

TEST(PseudoSegment, RefusesWhatIsNoSegment) {
    EXPECT_EQ(code_and_place_of([] { measure({nan, 0, 1, 1}); }), "pseudo.angle theta0");
    EXPECT_EQ(code_and_place_of([] { measure({0, inf, 1, 1}); }), "pseudo.angle theta1");
    EXPECT_EQ(code_and_place_of([] { measure({0, 0, 0, 1}); }), "pseudo.magnitude r0");
    EXPECT_EQ(code_and_place_of([] { measure({0, 0, 1, -1}); }), "pseudo.magnitude r1");
    EXPECT_EQ(code_and_place_of([] { measure({0, 0, nan, 1}); }), "pseudo.magnitude r0");
    EXPECT_EQ(code_and_place_of([] { measure({0, 0, 1, inf}); }), "pseudo.magnitude r1");
}

TEST(PseudoSegment, RefusesCusps) {
    EXPECT_EQ(code_and_place_of([] { measure({0, 0, 4, 4}); }), "pseudo.cusp segment");
    EXPECT_EQ(code_and_place_of([] { measure({std::acos(-1.0), 0, 1, 1}); }), "pseudo.cusp segment");
}

TEST(LeastSegment, RefusesAnglesThatAreNone) {
    EXPECT_EQ(code_and_place_of([] { least_pseudo_segment(nan, 0); }), "pseudo.angle theta0");
    EXPECT_EQ(code_and_place_of([] { pseudo_minima(0, -inf); }), "pseudo.angle theta1");
}

}  // namespace pseudo_bad_test
}  // namespace batten
