#include "api/field_text.hpp"

#include <cmath>
#include <numbers>

#include "batten/base/text.hpp"

namespace batten::api {
namespace {

constexpr double degree = std::numbers::pi / 180;

[[noreturn]] void refuse(const Slot& slot, std::string value, std::string rule) {
    throw Error("option.value", slot.name, std::move(value), std::move(rule));
}

/// `x` where the slot's limits accept it.
double checked(double x, const Slot& slot) {
    if (slot.limits.accept(x)) return x;
    if (std::isnan(x)) throw Error("option.range", slot.name, "nan", "must be a number");
    const auto [lo, hi, lo_open] = slot.limits;
    std::string rule;
    if (lo > -std::numeric_limits<double>::infinity()) {
        rule = (lo_open ? "must be more than " : "must be at least ") + format_number(lo);
    }
    if (hi < std::numeric_limits<double>::infinity()) {
        rule += (rule.empty() ? "must be at most " : " and at most ") + format_number(hi);
    }
    if (rule.empty()) rule = "must be a number";
    throw Error("option.range", slot.name, format_number(x), rule);
}

double number(std::string_view text, const Slot& slot) {
    const std::optional<double> x = parse_number(text);
    if (!x) refuse(slot, std::string(text), "must be a number");
    return checked(*x, slot);
}

int whole(std::string_view text, const Slot& slot) {
    const std::optional<long long> x = parse_integer(text);
    if (!x) refuse(slot, std::string(text), "must be a whole number");
    if (*x < std::numeric_limits<int>::min() || *x > std::numeric_limits<int>::max()) {
        throw Error("option.range", slot.name, std::string(text), "must fit 32 bits");
    }
    checked(static_cast<double>(*x), slot);
    return static_cast<int>(*x);
}

/// A number in data units, or with `r` behind it a share.
Tolerance tolerance(std::string_view text, const Slot& slot) {
    text = trimmed(text);
    const bool share = !text.empty() && text.back() == 'r';
    if (share) text.remove_suffix(1);
    const double value = number(text, slot);
    return share ? relative(value) : absolute(value);
}

std::vector<std::string_view> split(std::string_view text, char mark) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = text.find(mark);
        parts.push_back(trimmed(text.substr(0, end)));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return parts;
}

/// The two halves of `text` around `mark`.
std::pair<std::string_view, std::string_view> halves(std::string_view text, char mark,
                                                     const Slot& slot, const char* rule) {
    const std::vector<std::string_view> parts = split(text, mark);
    if (parts.size() != 2) refuse(slot, std::string(text), rule);
    return {parts[0], parts[1]};
}

}  // namespace

const std::string& text_of(const Argument& argument, const Slot& slot) {
    const std::string* text = std::get_if<std::string>(&argument);
    if (!text) refuse(slot, "an array", "takes a single value here");
    return *text;
}

void read(const Argument& argument, bool& out, const Slot& slot) {
    const std::string& text = text_of(argument, slot);
    if (text == "true") {
        out = true;
    } else if (text == "false") {
        out = false;
    } else {
        refuse(slot, text, "must be true or false");
    }
}

void read(const Argument& argument, int& out, const Slot& slot) {
    out = whole(text_of(argument, slot), slot);
}

void read(const Argument& argument, double& out, const Slot& slot) {
    out = number(text_of(argument, slot), slot);
}

void read(const Argument& argument, std::string& out, const Slot& slot) {
    out = text_of(argument, slot);
}

void read(const Argument& argument, Tolerance& out, const Slot& slot) {
    out = tolerance(text_of(argument, slot), slot);
}

void read(const Argument& argument, Angle& out, const Slot& slot) {
    out.radians = number(text_of(argument, slot), slot) * degree;
}

void read(const Argument& argument, AutoNumber& out, const Slot& slot) {
    const std::string_view text = trimmed(text_of(argument, slot));
    out.value = text == "auto" ? std::nullopt : std::optional(number(text, slot));
}

void read(const Argument& argument, IndexRange& out, const Slot& slot) {
    const auto [from, to] =
        halves(text_of(argument, slot), ',', slot, "must be two indices FROM,TO");
    out = {whole(from, slot), whole(to, slot)};
}

void read(const Argument& argument, Interval& out, const Slot& slot) {
    const auto [lo, hi] = halves(text_of(argument, slot), ',', slot, "must be two numbers A,B");
    out = {number(lo, slot), number(hi, slot)};
}

void read(const Argument& argument, std::vector<int>& out, const Slot& slot) {
    out.clear();
    for (const std::string_view part : split(text_of(argument, slot), ',')) {
        out.push_back(whole(part, slot));
    }
}

void read(const Argument& argument, std::vector<double>& out, const Slot& slot) {
    if (const auto* numbers = std::get_if<std::vector<double>>(&argument)) {
        for (const double x : *numbers) checked(x, slot);
        out = *numbers;
        return;
    }
    if (const auto* rows = std::get_if<Points>(&argument)) {
        if (rows->dim() != 1) refuse(slot, "a table", "must be a single column of numbers");
        out.assign(rows->coordinates().begin(), rows->coordinates().end());
        for (const double x : out) checked(x, slot);
        return;
    }
    out.clear();
    for (const std::string_view part : split(text_of(argument, slot), ',')) {
        out.push_back(number(part, slot));
    }
}

void read(const Argument& argument, CoordinateRows& out, const Slot& slot) {
    const auto* rows = std::get_if<Points>(&argument);
    out.width = rows ? rows->dim() : 1;
    if (!rows) return read(argument, out.numbers, slot);
    out.numbers.assign(rows->coordinates().begin(), rows->coordinates().end());
    for (const double x : out.numbers) checked(x, slot);
}

/// Limits are those of one error of all: of many, the operation knows which may be what.
void read(const Argument& argument, Errors& out, const Slot& slot) {
    out = {};
    if (const auto* text = std::get_if<std::string>(&argument)) {
        const std::optional<double> x = parse_number(*text);
        if (x) out.all = std::isfinite(slot.limits.lo) ? checked(*x, slot) : *x;
        else out.column = trimmed(*text);
        if (!out.is_given()) refuse(slot, *text, "must be a number, a column or a file");
        return;
    }
    if (const auto* rows = std::get_if<Points>(&argument)) {
        out.each.assign(rows->coordinates().begin(), rows->coordinates().end());
        out.width = static_cast<std::size_t>(rows->dim());
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&argument)) {
        out.each = *numbers;
    }
    if (out.each.empty()) refuse(slot, "no numbers", "must be one error of all, or one of each");
}

void read(const Argument& argument, std::vector<Tolerance>& out, const Slot& slot) {
    out.clear();
    if (const auto* text = std::get_if<std::string>(&argument)) {
        for (const std::string_view part : split(*text, ',')) out.push_back(tolerance(part, slot));
        return;
    }
    std::vector<double> numbers;
    read(argument, numbers, slot);
    for (const double x : numbers) out.push_back(absolute(x));
}

void read(const Argument& argument, std::vector<FixedTangent>& out, const Slot& slot) {
    out.clear();
    for (const std::string_view part : split(text_of(argument, slot), ',')) {
        const auto [index, angle] =
            halves(part, ':', slot, "must be INDEX:DEGREES, for example 0:90");
        out.push_back({whole(index, {slot.name, at_least(0)}),
                       Angle{number(angle, {slot.name, between(-1e6, 1e6)}) * degree}});
    }
}

void read(const Argument& argument, Points& out, const Slot& slot) {
    if (const auto* column = std::get_if<std::vector<double>>(&argument)) {
        out = Points(*column, 1);
        return;
    }
    const Points* rows = std::get_if<Points>(&argument);
    if (!rows) refuse(slot, "not a table", "must be a file of numbers");
    out = *rows;
}

void read(const Argument& argument, std::variant<Points, Curve>& out, const Slot& slot) {
    if (const Points* rows = std::get_if<Points>(&argument)) {
        out = *rows;
    } else if (const Curve* curve = std::get_if<Curve>(&argument)) {
        out = *curve;
    } else {
        refuse(slot, "neither points nor a curve", "must be a file of points or a curve");
    }
}

Value shown(bool x) { return x; }
Value shown(int x) { return x; }
Value shown(double x) { return x; }
Value shown(const std::string& x) { return x; }
Value shown(const Tolerance& x) {
    if (!x.is_relative) return x.value;
    return format_number(x.value) + "r";
}
Value shown(const Angle& x) { return x.radians / degree; }
Value shown(const AutoNumber& x) { return x.value ? Value(*x.value) : Value("auto"); }
Value shown(const Errors& x) {
    if (x.all) return *x.all;
    if (!x.column.empty()) return x.column;
    return x.each.empty() ? Value() : Value(std::to_string(x.each.size()) + " numbers");
}
Value shown(const IndexRange& x) { return ValueList{x.from, x.to}; }
Value shown(const Interval& x) { return ValueList{x.lo, x.hi}; }
Value shown(const std::vector<int>& x) { return ValueList(x.begin(), x.end()); }
Value shown(const std::vector<double>& x) { return Value(x); }
Value shown(const Coordinates& x) { return Value(x.numbers); }
Value shown(const std::vector<Tolerance>& x) {
    ValueList list;
    for (const Tolerance& each : x) list.push_back(shown(each));
    return list;
}
Value shown(const std::vector<FixedTangent>& x) {
    ValueList list;
    for (const FixedTangent& fixed : x) {
        list.push_back(std::to_string(fixed.index) + ":" +
                       format_number(fixed.angle.radians / degree));
    }
    return list;
}
Value shown(const Points& x) {
    return x.empty() ? Value() : Value(std::to_string(x.size()) + " rows");
}
Value shown(const std::variant<Points, Curve>& x) {
    const Points* rows = std::get_if<Points>(&x);
    return rows ? shown(*rows) : Value("a curve");
}

Spelling spelling(const bool&) { return {FieldKind::flag, ""}; }
Spelling spelling(const int&) { return {FieldKind::integer, "N"}; }
Spelling spelling(const double&) { return {FieldKind::number, "NUMBER"}; }
Spelling spelling(const std::string&) { return {FieldKind::text, "TEXT"}; }
Spelling spelling(const Tolerance&) { return {FieldKind::tolerance, "TOLERANCE"}; }
Spelling spelling(const Angle&) { return {FieldKind::number, "DEGREES"}; }
Spelling spelling(const AutoNumber&) { return {FieldKind::text, "NUMBER|auto"}; }
Spelling spelling(const Errors&) { return {FieldKind::errors, "NUMBER|COLUMN|FILE", true}; }
Spelling spelling(const IndexRange&) { return {FieldKind::list, "FROM,TO"}; }
Spelling spelling(const Interval&) { return {FieldKind::list, "A,B"}; }
Spelling spelling(const std::vector<int>&) { return {FieldKind::list, "I,…"}; }
Spelling spelling(const std::vector<double>&) { return {FieldKind::list, "X,…|FILE", true}; }
Spelling spelling(const Coordinates&) { return {FieldKind::list, "X,…|FILE", true}; }
Spelling spelling(const std::vector<Tolerance>&) { return {FieldKind::list, "S,…|FILE", true}; }
Spelling spelling(const std::vector<FixedTangent>&) { return {FieldKind::list, "I:DEGREES,…"}; }
Spelling spelling(const Points&) { return {FieldKind::table, "FILE", true}; }
Spelling spelling(const std::variant<Points, Curve>&) { return {FieldKind::shape, "FILE", true}; }

}  // namespace batten::api
