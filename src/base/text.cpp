#define FMT_HEADER_ONLY 1
#include "batten/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace batten {
namespace {

std::string_view without_plus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

#if defined(__cpp_lib_to_chars)
/// Stands for an exponent that no integer holds: more than any text has digits.
constexpr long long max_shift = std::numeric_limits<long long>::max() / 2;

/// What a number is that no double can hold: 0 where it is too small, inf where it is too large.
/// That is told by the decimal place of its first digit other than 0.
double beyond_range(std::string_view text) {
    const bool negative = text[0] == '-';
    text.remove_prefix(negative ? 1 : 0);
    const std::size_t mark = std::min(text.find_first_of("eE"), text.size());
    const std::string_view digits = text.substr(0, mark);
    const long long point = static_cast<long long>(std::min(digits.find('.'), digits.size()));
    const long long first = static_cast<long long>(digits.find_first_of("123456789"));
    const bool falls = text.substr(mark).substr(0, 2).find('-') != std::string_view::npos;
    const long long shift = mark == text.size() ? 0
                                                : parse_integer(text.substr(mark + 1))
                                                      .value_or(falls ? -max_shift : max_shift);
    const double size = point - first + shift > 0 ? std::numeric_limits<double>::infinity() : 0;
    return negative ? -size : size;
}
#endif

}  // namespace

std::string format_number(double x) {
    if (std::isnan(x)) return "nan";
    if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
    return fmt::format("{}", x);
}

std::string format_fixed(double x, int decimals) {
    std::string text = fmt::format("{:.{}f}", x, decimals);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string format_brief(double x, int digits) {
    constexpr int most_decimals = 22;  // 10^22 is a double
    if (x == 0 || !std::isfinite(x)) return format_number(x);
    const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::fabs(x))));
    if (decimals > most_decimals) return format_number(x);
    if (decimals <= 0) return format_number(std::round(x));
    const double power = std::pow(10.0, decimals);
    return format_number(std::round(x * power) / power);
}

std::string_view trimmed(std::string_view text) {
    const std::string_view blanks = " \t\r\n\f\v";
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> parse_number(std::string_view text) {
    text = without_plus(trimmed(text));
    if (text.empty()) return std::nullopt;
    double x = 0;
#if defined(__cpp_lib_to_chars)
    const char* const end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, x);
    if (read.ptr != end) return std::nullopt;
    if (read.ec == std::errc::result_out_of_range) return beyond_range(text);
    if (read.ec != std::errc()) return std::nullopt;
#else
    // musl's strtod, which emscripten uses, knows no locale.
    const std::string copy(text);
    char* end = nullptr;
    x = std::strtod(copy.c_str(), &end);
    if (end != copy.c_str() + copy.size()) return std::nullopt;
#endif
    return x;
}

std::optional<long long> parse_integer(std::string_view text) {
    text = without_plus(trimmed(text));
    long long value = 0;
    const char* const end = text.data() + text.size();
    const std::from_chars_result read = std::from_chars(text.data(), end, value);
    if (text.empty() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return value;
}

}  // namespace batten
