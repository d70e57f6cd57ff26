#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Private to the readers and writers: a namespace of its own keeps it out of the library's exports.
namespace batten::utf8 {

/// The length of the UTF-8 sequence `text` begins with [RFC3629]; 0 where it begins with none, or
/// with a control character below U+0020.
std::size_t length(std::string_view text);

/// Adds one code point, which is no surrogate.
void append(std::string& text, char32_t point);

/// `text` with U+FFFD in place of every byte that is not UTF-8 and of every control character: fit
/// to be shown on one line.
std::string printable(std::string_view text);

/// How an error shows a piece of its input: the first 40 bytes of it, `''` where it is empty.
std::string shown(std::string_view text);

/// How an error shows one byte of its input: `'x'`, or `byte 0x07` where it cannot be printed.
std::string shown(char c);

inline std::string_view without_byte_order_mark(std::string_view text) {
    return text.substr(text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0);
}

}  // namespace batten::utf8
