#include "io/draw/axes/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "batten/base/text.hpp"

namespace batten::drawing {
namespace {

constexpr const char* minus = "\u2212";
constexpr int most_digits = 5;
constexpr double shortest_log_axis = 0.8;  ///< decades

/// A whole number times a power of ten: decimal arithmetic without rounding.
struct Decimal {
    long long digits = 0;
    int exponent = 0;

    double value() const {
        // 10^-324 is no double, so the last step goes by division.
        return exponent < -300 ? static_cast<double>(digits) * power_of_ten(-300) /
                                     power_of_ten(-300 - exponent)
                               : static_cast<double>(digits) * power_of_ten(exponent);
    }
    /// The place of the leading digit.
    int magnitude() const {
        return static_cast<int>(std::to_string(std::llabs(digits)).size()) - 1 + exponent;
    }
};

std::string superscript(int exponent) {
    constexpr std::array<const char*, 10> digits{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                 "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = exponent < 0 ? "\u207b" : "";
    for (const char c : std::to_string(std::abs(exponent))) {
        text += digits[static_cast<std::size_t>(c - '0')];
    }
    return text;
}

std::string times_power(int exponent) { return "\u00d710" + superscript(exponent); }

/// In positional notation, with as many decimals as the exponent says.
std::string positional(Decimal x) {
    std::string text = std::to_string(std::llabs(x.digits));
    if (x.exponent > 0 && x.digits != 0) text.append(static_cast<std::size_t>(x.exponent), '0');
    if (x.exponent < 0) {
        const std::size_t decimals = static_cast<std::size_t>(-x.exponent);
        if (text.size() <= decimals) text.insert(0, decimals + 1 - text.size(), '0');
        text.insert(text.size() - decimals, ".");
    }
    return (x.digits < 0 ? minus : "") + text;
}

std::string shortest(Decimal x) {
    while (x.digits != 0 && x.digits % 10 == 0) x = {x.digits / 10, x.exponent + 1};
    if (std::abs(x.magnitude()) <= most_digits) return positional(x);
    const int magnitude = x.magnitude();
    return positional({x.digits, x.exponent - magnitude}) + times_power(magnitude);
}

/// The smallest of 1, 2, 5 times a power of ten that is not below `least`.
Decimal round_step(double least) {
    int exponent = static_cast<int>(std::floor(std::log10(least))) - 1;
    while (true) {
        for (const int digits : {1, 2, 5}) {
            const Decimal step{digits, exponent};
            if (step.value() >= least) return step;
        }
        ++exponent;
    }
}

/// The number with the most zeros at its end in lo ... hi, where both have one sign.
long long roundest(long long lo, long long hi) {
    long long block = 1'000'000'000'000'000'000;
    while (true) {
        const long long rest = lo % block;
        const long long above = rest == 0 ? lo : lo - rest + (lo > 0 ? block : 0);
        if (above <= hi && above != 0) return above;
        block /= 10;
    }
}

/// What all labels leave away so that they stay short: first an offset, then a power of ten.
struct Shortening {
    long long offset = 0;  ///< in units of the step's power of ten
    int exponent = 0;
};

Shortening shortening_of(Decimal first, Decimal last) {
    Shortening away;
    const auto largest = [&] {
        return Decimal{std::max(std::llabs(first.digits - away.offset),
                                std::llabs(last.digits - away.offset)),
                       first.exponent};
    };
    if (largest().magnitude() - first.exponent >= most_digits) {
        away.offset = roundest(first.digits, last.digits);
    }
    const int magnitude = largest().magnitude();
    const bool is_short = magnitude < most_digits && first.exponent > -most_digits;
    if (!is_short) away.exponent = magnitude;
    return away;
}

std::string power_label(int exponent, Interval shown) {
    const bool plain = shown.lo > -3 && shown.hi < 4;
    return plain ? positional({1, exponent}) : "10" + superscript(exponent);
}

/// Where an axis shows less than a power of ten: evenly spaced numbers.
AxisTicks crowded_log_ticks(Interval shown, double least_step) {
    const Interval values{std::pow(10, shown.lo), std::pow(10, shown.hi)};
    AxisTicks axis = linear_ticks(values, values.hi * -std::expm1(-least_step * std::log(10.0)));
    for (Tick& tick : axis.ticks) tick.at = std::log10(tick.at);
    return axis;
}

}  // namespace

std::string short_number(double x) {
    if (x == 0) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(std::fabs(x)))) - 2;
    const double digits = exponent < -300 ? x * power_of_ten(-300 - exponent) * power_of_ten(300)
                                          : x / power_of_ten(exponent);
    return shortest({std::llround(digits), exponent});
}

double power_of_ten(int exponent) {
    return *parse_number("1e" + std::to_string(exponent));
}

AxisTicks linear_ticks(Interval shown, double least_step) {
    const Decimal step = round_step(least_step);
    const double width = step.value();
    // A number at the very end is not lost to rounding.
    const double slack = 1e-9 * (0.5 * shown.hi / width - 0.5 * shown.lo / width);
    const long long first = static_cast<long long>(std::ceil(shown.lo / width - slack));
    const long long last = static_cast<long long>(std::floor(shown.hi / width + slack));
    AxisTicks axis{{}, {}, width};
    if (first > last) return axis;
    const Shortening away = shortening_of({first * step.digits, step.exponent},
                                          {last * step.digits, step.exponent});
    for (long long i = first; i <= last; ++i) {
        const Decimal at{i * step.digits, step.exponent};
        const Decimal label{at.digits - away.offset, at.exponent - away.exponent};
        axis.ticks.push_back({at.value(), positional(label)});
    }
    if (away.exponent != 0) axis.note = times_power(away.exponent);
    if (away.offset != 0) {
        const std::string sign = away.offset < 0 ? minus : "+";
        const Decimal size{std::llabs(away.offset), step.exponent};
        axis.note += (axis.note.empty() ? "" : " ") + sign + ' ' + shortest(size);
    }
    return axis;
}

AxisTicks log_ticks(Interval shown, double least_step) {
    if (shown.length() < shortest_log_axis) return crowded_log_ticks(shown, least_step);
    const int step = std::max(1, static_cast<int>(std::ceil(least_step)));
    const int lowest = static_cast<int>(std::floor(shown.lo));
    const int highest = static_cast<int>(std::floor(shown.hi));
    const bool labels_all = least_step <= std::log10(2.0);
    AxisTicks axis{{}, {}, static_cast<double>(step)};
    for (int power = lowest; power <= highest; ++power) {
        for (int digit = 1; digit < 10; ++digit) {
            const double at = power + std::log10(digit);
            if (!shown.contains(at) || (digit > 1 && step > 1)) continue;
            Tick tick{at, {}};
            if (digit == 1 && power % step == 0) tick.label = power_label(power, shown);
            if (labels_all && (digit == 2 || digit == 5)) {
                tick.label = std::abs(power) < 4 ? positional({digit, power})
                                                 : std::to_string(digit) + times_power(power);
            }
            axis.ticks.push_back(tick);
        }
    }
    return axis;
}

}  // namespace batten::drawing
