#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "batten/base/error.hpp"
#include "batten/io/json.hpp"
#include "random.hpp"

namespace batten {
namespace json_io_test {

using testing::Random;

bool accepts(const std::string& text) {
    try {
        parse_json(text, "text");
        return true;
    } catch (const Error&) {
        return false;
    }
}

/// Accepted texts with a few characters changed: some still are JSON, most are not.
TEST(JsonReader, AcceptsWhatNlohmannJsonAcceptsAndNothingElse) {
    const std::string seeds[] = {
        R"({"alpha": [1, -2.5e3, 0.5E-7, true], "beta": {"gamma": null, "delta": "\u00e9\ud83d\ude00\n"}})",
        R"([[0, -0, 1e5], [], {}, "", " ", false])", "[\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\"]"};
    const std::string letters = "{}[]\",:\\/0123456789.eE+-truefalsn \n\t\x01\x7F\x80\xC3\xED\xF4\xFF";
    Random random(1);
    int accepted = 0;
    for (int i = 0; i < 12000; ++i) {
        std::string text = seeds[i % 3];
        for (int edits = random.whole(1, 3); edits > 0; --edits) {
            const auto at = static_cast<std::size_t>(
                random.whole(0, static_cast<int>(text.size()) - 1));
            const char letter =
                letters[static_cast<std::size_t>(random.whole(0, static_cast<int>(letters.size()) - 1))];
            if (random.whole(0, 2) == 0) {
                text.erase(at, 1);
            } else if (random.whole(0, 1) == 0) {
                text.insert(at, 1, letter);
            } else {
                text[at] = letter;
            }
        }
        const bool ours = accepts(text);
        accepted += ours;
        EXPECT_EQ(ours, nlohmann::json::accept(text)) << text;
    }
    EXPECT_GT(accepted, 1000);
    EXPECT_LT(accepted, 10000);
}

TEST(JsonReader, ReadsTheNumbersThatNlohmannJsonReads) {
    Random random(2);
    for (int i = 0; i < 5000; ++i) {
        std::string text;
        for (int digits = random.whole(1, 25); digits > 0; --digits) {
            text += static_cast<char>('0' + random.whole(text.empty() ? 1 : 0, 9));
        }
        if (random.whole(0, 1) == 1) text.insert(1, ".");
        if (text.back() == '.') text += '5';
        if (random.whole(0, 1) == 1) text += 'e' + std::to_string(random.whole(-340, 280));
        EXPECT_EQ(parse_json(text, "text").number(), nlohmann::json::parse(text).get<double>())
            << text;
    }
}

TEST(JsonWriter, WritesWhatNlohmannJsonReads) {
    const Value value(ValueMap{{"text \"\\\n", "\x01 \xC3\xA9"}, {"list", ValueList{1, -0.5, nullptr}}});
    const nlohmann::json copy = nlohmann::json::parse(dump_json(value));
    EXPECT_EQ(copy["text \"\\\n"], "\x01 \xC3\xA9");
    EXPECT_EQ(copy["list"], nlohmann::json::parse("[1, -0.5, null]"));
}

}  // namespace json_io_test
}  // namespace batten
