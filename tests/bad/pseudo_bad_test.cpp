#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "batten/base/error.hpp"
#include "batten/make/pseudo_segment.hpp"

namespace batten {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The id and place of what `call` throws.
template <class Call>
std::string thrown_by(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.code() + ' ' + error.place();
    }
    return "nothing";
}

TEST(PseudoSegment, RefusesWhatIsNoSegment) {
    EXPECT_EQ(thrown_by([] { measure({nan, 0, 1, 1}); }), "pseudo.angle theta0");
    EXPECT_EQ(thrown_by([] { measure({0, infinity, 1, 1}); }), "pseudo.angle theta1");
    EXPECT_EQ(thrown_by([] { measure({0, 0, 0, 1}); }), "pseudo.magnitude r0");
    EXPECT_EQ(thrown_by([] { measure({0, 0, 1, -1}); }), "pseudo.magnitude r1");
    EXPECT_EQ(thrown_by([] { measure({0, 0, nan, 1}); }), "pseudo.magnitude r0");
    EXPECT_EQ(thrown_by([] { measure({0, 0, 1, infinity}); }), "pseudo.magnitude r1");
}

TEST(PseudoSegment, RefusesCusps) {
    EXPECT_EQ(thrown_by([] { measure({0, 0, 4, 4}); }), "pseudo.cusp segment");
    EXPECT_EQ(thrown_by([] { measure({std::acos(-1.0), 0, 1, 1}); }), "pseudo.cusp segment");
}

TEST(LeastSegment, RefusesAnglesThatAreNone) {
    EXPECT_EQ(thrown_by([] { least_pseudo_segment(nan, 0); }), "pseudo.angle theta0");
    EXPECT_EQ(thrown_by([] { pseudo_minima(0, -infinity); }), "pseudo.angle theta1");
}

}  // namespace
}  // namespace batten
