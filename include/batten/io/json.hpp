#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "batten/base/value.hpp"

namespace batten {

/// The most that is read as JSON: it keeps a hostile text from eating the memory, of which a value
/// takes about 50 bytes.
struct JsonLimits {
    int depth = 64;  ///< lists and maps inside one another
    std::size_t values = 5'000'000;
};

/// The tree that `text` spells [RFC8259]. `place` is what errors call the text.
///
/// A number without point and exponent becomes whole where it fits in 64 bits; every other number
/// is the nearest double. `-0` keeps its sign. A byte order mark is skipped.
///
/// Throws `json.syntax` with line and column (from 1; columns count bytes), also where the text is
/// not UTF-8; `json.duplicate-key`; `json.too-deep` and `json.too-large` beyond the limits;
/// `number.overflow` for a number beyond a double. Cost: linear.
Value parse_json(std::string_view text, std::string_view place, JsonLimits limits = {});

enum class JsonStyle {
    readable,  ///< two blanks of indentation, 100 columns; what is short stays on one line
    one_line,
};

/// `value` as JSON text, with a line end after the readable style. Numbers in their shortest form
/// that reads back to the same double; bytes that are not UTF-8 become U+FFFD.
///
/// Law: parse_json(dump_json(v)) is v (whole reals come back as whole numbers).
/// Throws `number.overflow` for a number that is not finite. Cost: linear.
std::string dump_json(const Value& value, JsonStyle style = JsonStyle::readable);

}  // namespace batten
