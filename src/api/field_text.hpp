#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/error.hpp"
#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/curve.hpp"

/// How each type of option is typed by a person, read back, and shown.
///
/// Per type T: `describe<T>` says what to type, `read(argument, out, place)` fills a T or throws
/// `option.value`, `shown(value)` is the tree for the report's `options`, which reads back.
namespace batten::api {

/// Where a setting stands and which numbers it may hold.
struct Slot {
    std::string name;
    Limits limits;
};

/// Coordinates, and how many stand in a row of the table they come from; in a list 1.
struct CoordinateRows : Coordinates {
    int width = 1;
    bool operator==(const CoordinateRows&) const = default;
};

void read(const Argument& argument, bool& out, const Slot& slot);
void read(const Argument& argument, int& out, const Slot& slot);
void read(const Argument& argument, double& out, const Slot& slot);
void read(const Argument& argument, std::string& out, const Slot& slot);
void read(const Argument& argument, Tolerance& out, const Slot& slot);
void read(const Argument& argument, Angle& out, const Slot& slot);
void read(const Argument& argument, AutoNumber& out, const Slot& slot);
void read(const Argument& argument, CoordinateRows& out, const Slot& slot);
void read(const Argument& argument, Errors& out, const Slot& slot);
void read(const Argument& argument, IndexRange& out, const Slot& slot);
void read(const Argument& argument, Interval& out, const Slot& slot);
void read(const Argument& argument, std::vector<int>& out, const Slot& slot);
void read(const Argument& argument, std::vector<double>& out, const Slot& slot);
void read(const Argument& argument, std::vector<Tolerance>& out, const Slot& slot);
void read(const Argument& argument, std::vector<FixedTangent>& out, const Slot& slot);
void read(const Argument& argument, Points& out, const Slot& slot);
void read(const Argument& argument, std::variant<Points, Curve>& out, const Slot& slot);

Value shown(bool x);
Value shown(int x);
Value shown(double x);
Value shown(const std::string& x);
Value shown(const Tolerance& x);
Value shown(const Angle& x);
Value shown(const AutoNumber& x);
Value shown(const Coordinates& x);
Value shown(const Errors& x);
Value shown(const IndexRange& x);
Value shown(const Interval& x);
Value shown(const std::vector<int>& x);
Value shown(const std::vector<double>& x);
Value shown(const std::vector<Tolerance>& x);
Value shown(const std::vector<FixedTangent>& x);
Value shown(const Points& x);
Value shown(const std::variant<Points, Curve>& x);

/// Kind and spelling of each type, for help texts.
struct Spelling {
    FieldKind kind;
    std::string_view takes;
    bool takes_file = false;
};
Spelling spelling(const bool&);
Spelling spelling(const int&);
Spelling spelling(const double&);
Spelling spelling(const std::string&);
Spelling spelling(const Tolerance&);
Spelling spelling(const Angle&);
Spelling spelling(const AutoNumber&);
Spelling spelling(const Coordinates&);
Spelling spelling(const Errors&);
Spelling spelling(const IndexRange&);
Spelling spelling(const Interval&);
Spelling spelling(const std::vector<int>&);
Spelling spelling(const std::vector<double>&);
Spelling spelling(const std::vector<Tolerance>&);
Spelling spelling(const std::vector<FixedTangent>&);
Spelling spelling(const Points&);
Spelling spelling(const std::variant<Points, Curve>&);

/// The text of an argument. Throws `option.value` where it is something else.
const std::string& text_of(const Argument& argument, const Slot& slot);

template <NamedEnum E>
void read(const Argument& argument, E& out, const Slot& slot) {
    const std::string& text = text_of(argument, slot);
    std::string words;
    for (const Named<E>& word : names_of(E{})) {
        if (word.name == text) {
            out = word.value;
            return;
        }
        words += (words.empty() ? "" : ", ") + std::string(word.name);
    }
    throw Error("option.choice", slot.name, text, "must be one of " + words);
}

template <NamedEnum E>
Value shown(E value) {
    return name_of(value);
}

template <NamedEnum E>
Spelling spelling(const E&) {
    return {FieldKind::choice, ""};
}

template <class T>
void read(const Argument& argument, std::optional<T>& out, const Slot& slot) {
    T value{};
    read(argument, value, slot);
    out = std::move(value);
}

template <class T>
Value shown(const std::optional<T>& x) {
    return x ? shown(*x) : Value();
}

template <class T>
Spelling spelling(const std::optional<T>&) {
    return spelling(T{});
}

}  // namespace batten::api
