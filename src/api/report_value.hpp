#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/interval.hpp"
#include "batten/base/value.hpp"

/// From a report struct's `visit_fields` to the tree every face shows.
namespace batten::api {

inline Value report_value(double x) { return x; }
inline Value report_value(int x) { return x; }
inline Value report_value(std::size_t x) { return x; }
inline Value report_value(bool x) { return x; }
inline Value report_value(const std::string& x) { return x; }
inline Value report_value(const Interval& x) { return ValueList{x.lo, x.hi}; }

template <NamedEnum E>
Value report_value(E x) {
    return name_of(x);
}

struct AnyField {
    void operator()(const char*, const auto&, const char*) const {}
};
template <class T>
concept ReportStruct = requires(const T& report) { visit_fields(report, AnyField{}); };

template <class T>
Value report_value(const std::optional<T>& x);
template <class T>
Value report_value(const std::vector<T>& list);
template <class T, std::size_t N>
Value report_value(const std::array<T, N>& list);
template <ReportStruct Report>
Value report_value(const Report& report);

template <class T>
Value report_value(const std::optional<T>& x) {
    return x ? report_value(*x) : Value();
}

template <class T>
Value report_value(const std::vector<T>& list) {
    ValueList values;
    for (const T& x : list) values.push_back(report_value(x));
    return values;
}

template <class T, std::size_t N>
Value report_value(const std::array<T, N>& list) {
    ValueList values;
    for (const T& x : list) values.push_back(report_value(x));
    return values;
}

template <ReportStruct Report>
Value report_value(const Report& report) {
    ValueMap map;
    visit_fields(report, [&](const char* name, const auto& member, const char*) {
        map.emplace_back(name, report_value(member));
    });
    return map;
}

}  // namespace batten::api
