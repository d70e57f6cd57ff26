#include "summary.hpp"

#include <algorithm>

#include "batten/base/text.hpp"

namespace batten::cli {
namespace {

constexpr std::size_t most_shown = 6;

/// What a person reads; the report has all digits.
constexpr int digits = 7;

std::string brief(const Value& value);

/// The first few numbers of a list, and how many there are; of a table that alone.
std::string brief(const ValueList& list) {
    if (list.empty()) return "none";
    if (list[0].list() || (list.size() > 1 && list[0].map())) return std::to_string(list.size()) + " in the report";
    std::string text;
    for (std::size_t i = 0; i < std::min(list.size(), most_shown); ++i) {
        text += (i > 0 ? ", " : "") + brief(list[i]);
    }
    if (list.size() > most_shown) text += ", … (" + std::to_string(list.size()) + ")";
    return text;
}

std::string brief(const ValueMap& map) {
    std::string text;
    for (const auto& [key, value] : map) {
        text += (text.empty() ? "" : ", ") + key + " " + brief(value);
    }
    return text;
}

std::string brief(const Value& value) {
    if (value.is_null()) return "none";
    if (const bool* truth = value.truth()) return *truth ? "yes" : "no";
    if (const long long* whole = value.integer()) return std::to_string(*whole);
    if (const double* x = value.real()) return format_brief(*x, digits);
    if (const std::string* text = value.text()) return *text;
    if (const ValueList* list = value.list()) return brief(*list);
    return brief(*value.map());
}

}  // namespace

std::string summary(const Operation& operation, const Outcome& outcome) {
    std::string text = std::string(operation.name) + ": " + std::string(name_of(outcome.status)) + '\n';
    const ValueMap* report = outcome.report.map();
    if (!report) return text;
    std::size_t width = 0;
    for (const auto& [key, value] : *report) width = std::max(width, key.size());
    for (const auto& [key, value] : *report) {
        if (value.is_null()) continue;
        if (key == "notes") {
            for (const Value& note : *value.list()) text += "  note: " + *note.text() + '\n';
        } else {
            text += "  " + key + std::string(width - key.size() + 2, ' ') + brief(value) + '\n';
        }
    }
    return text;
}

}  // namespace batten::cli
