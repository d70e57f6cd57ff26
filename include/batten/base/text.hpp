#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace batten {

/// The shortest text that reads back to the same double: the same bytes on every platform and in
/// every locale. `nan`, `inf` and `-inf` where it is not finite.
std::string format_number(double x);

/// `x` rounded to a fixed number of decimals, without trailing zeros and never `-0`.
std::string format_fixed(double x, int decimals);
/// The shortest text of x rounded to so many digits before and after the point, for people to read; no
/// digit before the point is lost.
std::string format_brief(double x, int digits);

/// The number that `text` is, whole and alone (blanks around it allowed), or nothing. Accepts
/// `1e-3`, `+.5`, `nan` and `inf`; independent of the locale.
std::optional<double> parse_number(std::string_view text);

/// The whole number that `text` is, or nothing.
std::optional<long long> parse_integer(std::string_view text);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace batten
