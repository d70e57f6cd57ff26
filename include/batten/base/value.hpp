#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace batten {

class Value;
using ValueList = std::vector<Value>;
using ValueMap = std::vector<std::pair<std::string, Value>>;  ///< in the order they were added

/// A tree of nulls, truths, numbers, texts, lists and maps: what JSON can say. Reports, curve
/// files and job files are such trees, whatever face shows them.
class Value {
public:
    Value() = default;
    Value(std::nullptr_t) {}
    Value(bool x) : content_(x) {}
    Value(int x) : content_(static_cast<long long>(x)) {}
    Value(long long x) : content_(x) {}
    Value(std::size_t x) : content_(static_cast<long long>(x)) {}
    Value(double x) : content_(x) {}
    Value(const char* x) : content_(std::string(x)) {}
    Value(std::string_view x) : content_(std::string(x)) {}
    Value(std::string x) : content_(std::move(x)) {}
    Value(ValueList x) : content_(std::move(x)) {}
    Value(ValueMap x) : content_(std::move(x)) {}
    /// A list of numbers.
    explicit Value(const std::vector<double>& numbers)
        : content_(ValueList(numbers.begin(), numbers.end())) {}

    bool is_null() const { return std::holds_alternative<std::monostate>(content_); }
    const bool* truth() const { return std::get_if<bool>(&content_); }
    const long long* integer() const { return std::get_if<long long>(&content_); }
    const double* real() const { return std::get_if<double>(&content_); }
    const std::string* text() const { return std::get_if<std::string>(&content_); }
    const ValueList* list() const { return std::get_if<ValueList>(&content_); }
    const ValueMap* map() const { return std::get_if<ValueMap>(&content_); }
    ValueMap* map() { return std::get_if<ValueMap>(&content_); }

    bool is_number() const { return integer() || real(); }
    /// The number, whole or not. Call only where `is_number()`.
    double number() const { return integer() ? static_cast<double>(*integer()) : *real(); }
    /// The entry of a map under `key`, or null.
    const Value* find(std::string_view key) const {
        const ValueMap* entries = map();
        if (!entries) return nullptr;
        for (const auto& entry : *entries) {
            if (entry.first == key) return &entry.second;
        }
        return nullptr;
    }

    bool operator==(const Value&) const = default;

private:
    std::variant<std::monostate, bool, long long, double, std::string, ValueList, ValueMap>
        content_;
};

}  // namespace batten
