#include "io/draw/scene/text_layout.hpp"

#include <algorithm>

namespace batten::drawing {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Bytes of the UTF-8 letter that begins `text`, 0 where none does (also for overlong forms,
/// surrogates and the two noncharacters that XML forbids).
std::size_t letter_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t count = first < 0x80 ? 1
                              : first >= 0xC2 && first < 0xE0 ? 2
                              : first >= 0xE0 && first < 0xF0 ? 3
                              : first >= 0xF0 && first < 0xF5 ? 4
                                                              : 0;
    if (count == 0 || text.size() < count) return 0;
    unsigned code = count == 1 ? first : first & (0x7Fu >> count);
    for (std::size_t i = 1; i < count; ++i) {
        if ((byte(i) & 0xC0u) != 0x80u) return 0;
        code = (code << 6) | (byte(i) & 0x3Fu);
    }
    const bool forbidden = (count == 3 && code < 0x800) || (code >= 0xD800 && code < 0xE000) ||
                           code == 0xFFFE || code == 0xFFFF || (count == 4 && code < 0x10000) ||
                           code > 0x10FFFF;
    return forbidden ? 0 : count;
}

/// Widths in ems of DejaVu Sans, the widest of the fonts asked for, by class of letter.
double letter_width(std::string_view letter) {
    if (letter.size() > 1) return letter.size() == 2 ? 0.62 : 0.84;
    if (std::string_view(" .,:;'|!ijl()[]ft").find(letter) != std::string_view::npos) return 0.37;
    if (std::string_view("mwMWOQ@%&<>=+").find(letter) != std::string_view::npos) return 0.9;
    const char c = letter[0];
    return c >= 'A' && c <= 'Z' ? 0.7 : 0.62;
}

}  // namespace

std::vector<std::string_view> letters_of(std::string_view text) {
    std::vector<std::string_view> result;
    while (!text.empty()) {
        const std::size_t count = letter_length(text);
        result.push_back(count > 0 ? text.substr(0, count) : replacement);
        text.remove_prefix(std::max<std::size_t>(count, 1));
    }
    return result;
}

double text_width(std::string_view text, double size) {
    double ems = 0;
    for (const std::string_view letter : letters_of(text)) ems += letter_width(letter);
    return ems * size;
}

std::string shortened(std::string_view text, double size, double width) {
    if (text_width(text, size) <= width) return std::string(text);
    constexpr std::string_view ellipsis = "\u2026";
    std::string result;
    double used = text_width(ellipsis, size);
    for (const std::string_view letter : letters_of(text)) {
        used += size * letter_width(letter);
        if (used > width) break;
        result += letter;
    }
    return result.append(ellipsis);
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
    std::vector<std::string> lines;
    std::string line, word;
    const auto end_word = [&] {
        const std::string longer = line.empty() ? word : line + ' ' + word;
        if (line.empty() || text_width(longer, size) <= width) {
            line = longer;
        } else {
            lines.push_back(line);
            line = word;
        }
        word.clear();
    };
    for (const std::string_view letter : letters_of(text)) {
        if (letter == " " || letter == "\n") {
            end_word();
            continue;
        }
        if (!word.empty() && text_width(word + std::string(letter), size) > width) end_word();
        word += letter;
    }
    end_word();
    if (!line.empty()) lines.push_back(line);
    return lines;
}

}  // namespace batten::drawing
