#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How options and reports describe themselves.
///
/// Beside each options struct stands one `visit_fields(options, visit)` that calls, per member,
///     visit("weight_exponent", o.weight_exponent, between(-8, 8), "one sentence");
/// and beside each report struct one that calls
///     visit("length", r.length, "one sentence");
/// Every face (command line, job file, Python, page, docs) is made from these calls alone.
namespace batten {

/// Which numbers a field accepts. The bound `lo` itself is refused where `lo_open`.
struct Limits {
    double lo = -std::numeric_limits<double>::infinity();
    double hi = std::numeric_limits<double>::infinity();
    bool lo_open = false;

    constexpr bool accept(double x) const { return (lo_open ? lo < x : lo <= x) && x <= hi; }
};

inline constexpr Limits anything{};
constexpr Limits at_least(double lo) { return {lo}; }
constexpr Limits more_than(double lo) {
    return {lo, std::numeric_limits<double>::infinity(), true};
}
constexpr Limits between(double lo, double hi) { return {lo, hi}; }

/// One word of an enumeration's vocabulary. Beside the enumeration E stands
///     constexpr std::array<Named<E>, N> names_of(E);
template <class E>
struct Named {
    std::string_view name;
    E value;
};

template <class E>
concept NamedEnum = requires(E e) { names_of(e).size(); };

template <NamedEnum E>
constexpr std::string_view name_of(E value) {
    for (const Named<E>& word : names_of(value)) {
        if (word.value == value) return word.name;
    }
    return {};
}

/// A choice that may be named without a word: beside the enumeration stands
///     constexpr E bare_word(E);
/// which says what the name alone means.
template <class E>
concept BareEnum = NamedEnum<E> && requires(E e) { { bare_word(e) } -> std::same_as<E>; };

/// An angle: radians in memory and in reports, degrees where a person types it.
struct Angle {
    double radians = 0;
    bool operator==(const Angle&) const = default;
};

/// A number, or `auto`: found from the data.
struct AutoNumber {
    std::optional<double> value;
    bool operator==(const AutoNumber&) const = default;
};

/// Numbers, or places: rows of coordinates, one after another.
struct Coordinates {
    std::vector<double> numbers;
    bool operator==(const Coordinates&) const = default;
};

/// Errors of measurements, standard deviations: one of all, the name of a column, or one of each.
struct Errors {
    std::optional<double> all;
    std::string column;
    std::vector<double> each;
    std::size_t width = 1;  ///< how many of `each` stand in a row
    bool operator==(const Errors&) const = default;

    bool is_given() const { return all || !column.empty() || !each.empty(); }
};

/// The tangent direction at one point: `index` from 0, absolute angle.
struct FixedTangent {
    int index = 0;
    Angle angle;
    bool operator==(const FixedTangent&) const = default;
};

/// A run of points, both ends included; indices from 0.
struct IndexRange {
    int from = 0;
    int to = 0;
    bool operator==(const IndexRange&) const = default;
};

/// What became of the mathematics; each report says which and why. The names are permanent.
enum class Status {
    met,             ///< the result is what was asked
    not_met,         ///< the result exists, but misses a tolerance or a condition asked for
    not_converged,   ///< an iteration stopped before its own criterion: the best found is returned
    rank_deficient,  ///< some unknowns are not determined by the data; they are listed
};

constexpr std::array<Named<Status>, 4> names_of(Status) {
    return {{{"met", Status::met},
             {"not_met", Status::not_met},
             {"not_converged", Status::not_converged},
             {"rank_deficient", Status::rank_deficient}}};
}

}  // namespace batten
