#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/json.hpp"
#include "io/tables/utf8.hpp"

namespace batten {
namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// A recursive descent through the grammar of [RFC8259]. Its own, and not a library's, for exact
/// numbers in any locale, the sign of -0, and the place of every mistake.
class JsonReader {
public:
    JsonReader(std::string_view text, std::string_view place, JsonLimits limits)
        : text_(utf8::without_byte_order_mark(text)), place_(place), limits_(limits) {}

    Value document() {
        Value result = value(0);
        blanks();
        if (at_ < text_.size()) fail("the text must end after its one value");
        return result;
    }

private:
    Value value(int depth) {
        blanks();
        if (++values_ > limits_.values) {
            throw error("json.too-large", "more than " + std::to_string(limits_.values),
                        "at most " + std::to_string(limits_.values) + " values are read");
        }
        switch (next()) {
            case '[': return list(depth + 1);
            case '{': return map(depth + 1);
            case '"': return string();
            case 't': return word("true", true);
            case 'f': return word("false", false);
            case 'n': return word("null", nullptr);
            default: return number();
        }
    }

    Value list(int depth) {
        enter(depth);
        ValueList entries;
        if (take(']')) return entries;
        do {
            entries.push_back(value(depth));
        } while (more(']', "a list goes on with , or ends with ]"));
        return entries;
    }

    Value map(int depth) {
        enter(depth);
        ValueMap entries;
        std::unordered_set<std::string> keys;
        if (take('}')) return entries;
        do {
            blanks();
            const std::size_t start = at_;
            if (next() != '"') fail("a key in double quotes is needed here");
            std::string key = string();
            if (!keys.insert(key).second) {
                at_ = start;
                throw error("json.duplicate-key", utf8::shown(key), "a key may stand only once in a map");
            }
            if (!take(':')) fail("a key is followed by :");
            entries.emplace_back(std::move(key), value(depth));
        } while (more('}', "a map goes on with , or ends with }"));
        return entries;
    }

    void enter(int depth) {
        if (depth > limits_.depth) {
            throw error("json.too-deep", "more than " + std::to_string(limits_.depth),
                        "at most " + std::to_string(limits_.depth) +
                            " lists and maps may lie inside one another");
        }
        ++at_;
    }

    /// Whether another entry follows; otherwise the list or map has ended.
    bool more(char end, const char* rule) {
        if (take(',')) return true;
        if (!take(end)) fail(rule);
        return false;
    }

    Value word(std::string_view spelling, Value meaning) {
        if (text_.substr(at_, spelling.size()) != spelling) fail("a value is needed here");
        at_ += spelling.size();
        return meaning;
    }

    Value number() {
        const std::size_t start = at_;
        if (next() == '-') ++at_;
        if (!is_digit(next())) {
            at_ = start;
            fail("a value is needed here");
        }
        const bool leading_zero = next() == '0';
        if (digits() > 1 && leading_zero) fail("a number may not start with 0");
        bool is_whole = true;
        if (next() == '.') {
            ++at_;
            is_whole = false;
            if (digits() == 0) fail("digits are needed after the point");
        }
        if (next() == 'e' || next() == 'E') {
            ++at_;
            is_whole = false;
            if (next() == '+' || next() == '-') ++at_;
            if (digits() == 0) fail("digits are needed in the exponent");
        }
        const std::string_view spelling = text_.substr(start, at_ - start);
        if (is_whole && spelling != "-0") {
            if (const auto whole = parse_integer(spelling)) return *whole;
        }
        const double real = *parse_number(spelling);
        if (!std::isfinite(real)) {
            at_ = start;
            throw error("number.overflow", std::string(spelling.substr(0, 40)),
                        "numbers must lie within the range of a double");
        }
        return real;
    }

    std::size_t digits() {
        const std::size_t start = at_;
        while (is_digit(next())) ++at_;
        return at_ - start;
    }

    std::string string() {
        ++at_;
        std::string result;
        while (next() != '"') {
            const std::size_t start = at_;
            while (at_ < text_.size() && plain(text_[at_])) ++at_;
            result.append(text_, start, at_ - start);
            if (at_ == text_.size()) fail("a text ends with a double quote");
            if (next() == '"') break;
            if (next() == '\\') {
                escape(result);
            } else if (const std::size_t length = utf8::length(text_.substr(at_))) {
                result.append(text_, at_, length);
                at_ += length;
            } else {
                fail("a text must be UTF-8, without control characters");
            }
        }
        ++at_;
        return result;
    }

    static bool plain(char c) {
        return c != '"' && c != '\\' && static_cast<unsigned char>(c) >= 0x20 &&
               static_cast<unsigned char>(c) < 0x80;
    }

    void escape(std::string& result) {
        constexpr std::string_view letters = "\"\\/bfnrt";
        constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
        ++at_;
        const std::size_t known = letters.find(next());
        if (at_ < text_.size() && known != std::string_view::npos) {
            result += meanings[known];
            ++at_;
            return;
        }
        if (next() != 'u') fail("no such escape sequence");
        ++at_;
        char32_t point = unit();
        if (0xD800 <= point && point < 0xDC00 && text_.substr(at_, 2) == "\\u") {
            at_ += 2;
            const char32_t low = unit();
            if (low < 0xDC00 || low > 0xDFFF) fail("half of a surrogate pair");
            point = 0x10000 + ((point - 0xD800) << 10) + (low - 0xDC00);
        }
        if (0xD800 <= point && point < 0xE000) fail("half of a surrogate pair");
        utf8::append(result, point);
    }

    /// The four hexadecimal digits of an escape.
    char32_t unit() {
        char32_t unit = 0;
        for (int i = 0; i < 4; ++i, ++at_) {
            constexpr std::string_view figures = "0123456789abcdefABCDEF";
            const std::size_t figure = at_ < text_.size() ? figures.find(text_[at_])
                                                          : std::string_view::npos;
            if (figure == std::string_view::npos) fail("four hexadecimal digits are needed here");
            unit = unit * 16 + static_cast<char32_t>(figure < 16 ? figure : figure - 6);
        }
        return unit;
    }

    void blanks() {
        while (next() == ' ' || next() == '\t' || next() == '\n' || next() == '\r') ++at_;
    }
    bool take(char c) {
        blanks();
        if (next() != c) return false;
        ++at_;
        return true;
    }
    /// The next character; a zero byte, which no rule accepts, at the end.
    char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    Error error(std::string code, std::string value, std::string rule) const {
        const std::string_view before = text_.substr(0, at_);
        const auto line = std::count(before.begin(), before.end(), '\n') + 1;
        const std::size_t column = at_ - (before.rfind('\n') + 1) + 1;
        return {std::move(code),
                std::string(place_) + " line " + std::to_string(line) + ", column " +
                    std::to_string(column),
                std::move(value), std::move(rule)};
    }
    [[noreturn]] void fail(std::string rule) const {
        throw error("json.syntax", at_ < text_.size() ? utf8::shown(text_[at_]) : "end of text",
                    std::move(rule));
    }

    std::string_view text_, place_;
    JsonLimits limits_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
};

}  // namespace

Value parse_json(std::string_view text, std::string_view place, JsonLimits limits) {
    return JsonReader(text, place, limits).document();
}

}  // namespace batten
