#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "batten/base/text.hpp"
#include "io/draw/axes/ticks.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "random.hpp"

namespace batten::testing {
namespace ticks_test {

using namespace drawing;

std::vector<std::string> labels_of(const AxisTicks& axis) {
    std::vector<std::string> labels;
    for (const Tick& tick : axis.ticks) {
        if (!tick.label.empty()) labels.push_back(tick.label);
    }
    return labels;
}

using Labels = std::vector<std::string>;

TEST(LinearTicks, AreRoundNumbersWithAsManyDecimalsAsTheStep) {
    EXPECT_EQ(labels_of(linear_ticks({-1.2, 1.1}, 0.4)),
              (Labels{"−1.0", "−0.5", "0.0", "0.5", "1.0"}));
    EXPECT_EQ(labels_of(linear_ticks({0, 10}, 1.9)), (Labels{"0", "2", "4", "6", "8", "10"}));
    EXPECT_EQ(labels_of(linear_ticks({-90, 20}, 50)), (Labels{"−50", "0"}));
    EXPECT_EQ(labels_of(linear_ticks({0.21, 0.29}, 0.02)),
              (Labels{"0.22", "0.24", "0.26", "0.28"}));
}

TEST(LinearTicks, NoteAPowerOfTenThatWouldMakeLabelsLong) {
    const AxisTicks large = linear_ticks({0, 3.2e7}, 1e7);
    EXPECT_EQ(labels_of(large), (Labels{"0", "1", "2", "3"}));
    EXPECT_EQ(large.note, "×10⁷");
    const AxisTicks small = linear_ticks({-1e-300, 2.5e-300}, 1e-300);
    EXPECT_EQ(labels_of(small), (Labels{"−1", "0", "1", "2"}));
    EXPECT_EQ(small.note, "×10⁻³⁰⁰");
}

TEST(LinearTicks, NoteAnOffsetThatWouldMakeLabelsLong) {
    const AxisTicks high = linear_ticks({1e9 - 4e-4, 1e9 + 1e-3}, 5e-4);
    EXPECT_EQ(labels_of(high), (Labels{"0.0000", "0.0005", "0.0010"}));
    EXPECT_EQ(high.note, "+ 1×10⁹");
    const AxisTicks low = linear_ticks({-12345.6785, -12345.6768}, 1e-3);
    EXPECT_EQ(labels_of(low), (Labels{"0.000", "0.001"}));
    EXPECT_EQ(low.note, "− 12345.678");
    const AxisTicks both = linear_ticks({1e9, 1e9 + 4e-6}, 1e-6);
    EXPECT_EQ(labels_of(both), (Labels{"0", "1", "2", "3", "4"}));
    EXPECT_EQ(both.note, "×10⁻⁶ + 1×10⁹");
}

/// The number a label and its note stand for; the note is made of what the tests above show.
double meaning(std::string label, const std::string& note) {
    const auto ascii = [](std::string text) {
        const std::pair<const char*, const char*> signs[] = {
            {"−", "-"}, {"×10", "e"}, {"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
            {"³", "3"}, {"⁴", "4"},   {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
        for (const auto& [sign, plain] : signs) {
            for (std::size_t at; (at = text.find(sign)) != std::string::npos;) {
                text.replace(at, std::string(sign).size(), plain);
            }
        }
        return text;
    };
    const std::string plain = ascii(note);
    const std::size_t sign = plain.find_first_of("+-", plain.starts_with("e-") ? 2 : 0);
    const std::string power = plain.starts_with("e") ? plain.substr(0, plain.find(' ')) : "";
    double value = *parse_number(ascii(label) + power);
    if (sign != std::string::npos) {
        const double offset = *parse_number(plain.substr(sign + 2));
        value += plain[sign] == '-' ? -offset : offset;
    }
    return value;
}

TEST(LinearTicks, LabelsMeanWhereTheyStandAndAreShort) {
    Random random(11);
    for (int trial = 0; trial < 3000; ++trial) {
        const double width = std::pow(10, random.within(-250, 250));
        const double farness = std::pow(10, random.within(-3, 11));
        const double lo = random.within(-1, 1) * farness * width;
        const Interval shown{lo, lo + width};
        const AxisTicks axis = linear_ticks(shown, random.within(0.05, 0.3) * width);
        ASSERT_GE(axis.ticks.size(), 1u);
        for (const Tick& tick : axis.ticks) {
            EXPECT_TRUE(shown.contains(tick.at));
            EXPECT_LE(letters_of(tick.label).size(), 7u) << tick.label;
            const double size = std::max(std::fabs(shown.lo), std::fabs(shown.hi));
            EXPECT_NEAR(meaning(tick.label, axis.note), tick.at, 1e-15 * size + 1e-9 * width)
                << tick.label << ' ' << axis.note;
        }
    }
}

TEST(LogTicks, ArePowersOfTen) {
    const AxisTicks wide = log_ticks({-16.2, 0.3}, 1.6);
    EXPECT_EQ(labels_of(wide).front(), "10⁻¹⁶");
    EXPECT_EQ(labels_of(wide).back(), "10⁰");
    EXPECT_EQ(wide.step, 2);
    EXPECT_EQ(labels_of(log_ticks({-1.3, 2.4}, 0.9)), (Labels{"0.1", "1", "10", "100"}));
}

TEST(LogTicks, AreFinerWhereThereIsRoom) {
    EXPECT_EQ(labels_of(log_ticks({0.1, 1.5}, 0.25)), (Labels{"2", "5", "10", "20"}));
    const AxisTicks narrow = log_ticks({std::log10(3.0), std::log10(4.4)}, 0.04);
    EXPECT_EQ(labels_of(narrow), (Labels{"3.0", "3.5", "4.0"}));
    EXPECT_NEAR(narrow.ticks[1].at, std::log10(3.5), 1e-15);
}

TEST(ShortNumber, HasThreeDigits) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(127.43), "127");
    EXPECT_EQ(short_number(-0.012345), "−0.0123");
    EXPECT_EQ(short_number(1480.2), "1480");
    EXPECT_EQ(short_number(9.996), "10");
    EXPECT_EQ(short_number(1.2345e9), "1.23×10⁹");
    EXPECT_EQ(short_number(4e-310), "4×10⁻³¹⁰");
}

}  // namespace ticks_test
}  // namespace batten::testing
