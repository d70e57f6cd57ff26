#include "io/tables/utf8.hpp"

namespace batten::utf8 {

std::size_t length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto follows = [&](std::size_t i) { return i < text.size() && (byte(i) & 0xC0) == 0x80; };
    const unsigned first = byte(0);
    if (first < 0x80) return first < 0x20 ? 0 : 1;
    if (first < 0xC2 || first > 0xF4 || !follows(1)) return 0;
    if (first < 0xE0) return 2;
    // The second byte rules out overlong forms, surrogates and what lies beyond U+10FFFF.
    const unsigned second = byte(1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || !follows(2)) {
        return 0;
    }
    if (first < 0xF0) return 3;
    if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F) || !follows(3)) {
        return 0;
    }
    return 4;
}

void append(std::string& text, char32_t point) {
    const auto add = [&text](char32_t byte) { text += static_cast<char>(byte); };
    const auto add_rest = [&](int shift) { add(0x80 | ((point >> shift) & 0x3F)); };
    if (point < 0x80) {
        add(point);
    } else if (point < 0x800) {
        add(0xC0 | (point >> 6));
        add_rest(0);
    } else if (point < 0x10000) {
        add(0xE0 | (point >> 12));
        add_rest(6);
        add_rest(0);
    } else {
        add(0xF0 | (point >> 18));
        add_rest(12);
        add_rest(6);
        add_rest(0);
    }
}

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t size = length(text);
        if (size > 0 && text[0] != '\x7F') {
            result += text.substr(0, size);
        } else {
            append(result, 0xFFFD);
        }
        text.remove_prefix(size > 0 ? size : 1);
    }
    return result;
}

std::string shown(std::string_view text) {
    return text.empty() ? "''" : printable(text.substr(0, 40));
}

std::string shown(char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (0x20 <= byte && byte < 0x7F) return {'\'', c, '\''};
    constexpr char figures[] = "0123456789ABCDEF";
    return std::string("byte 0x") + figures[byte >> 4] + figures[byte & 15];
}

}  // namespace batten::utf8
