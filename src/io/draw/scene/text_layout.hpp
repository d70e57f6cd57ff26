#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace batten::drawing {

/// The UTF-8 letters of `text`; a byte that begins none is given as U+FFFD.
std::vector<std::string_view> letters_of(std::string_view text);

/// About how wide `text` is in pixels, a little more than most sans-serif fonts need.
double text_width(std::string_view text, double size);

/// `text` in lines no wider than `width`, broken at blanks; a word too long for a line is broken
/// anywhere.
std::vector<std::string> wrapped(std::string_view text, double size, double width);

/// `text`, cut short with an ellipsis where it is wider than `width`.
std::string shortened(std::string_view text, double size, double width);

}  // namespace batten::drawing
