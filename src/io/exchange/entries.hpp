#pragma once

#include <string>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/points.hpp"
#include "batten/base/value.hpp"

/// Reading a curve file's maps.
namespace batten::exchange {

/// What errors say of an entry.
std::string shown(const Value* value);

/// The entries of a curve's map, with errors that name them.
class Entries {
public:
    Entries(const Value& tree, std::string place) : tree_(tree), place_(std::move(place)) {}

    std::string place(const std::string& entry) const { return place_ + ", entry " + entry; }

    bool has(const char* key) const { return tree_.find(key) != nullptr; }

    bool truth(const char* key) const {
        const Value* value = tree_.find(key);
        if (!value) return false;
        if (!value->truth()) throw wrong(key, value, "true or false is needed here");
        return *value->truth();
    }
    int whole(const char* key) const {
        const Value* value = tree_.find(key);
        const long long* number = value ? value->integer() : nullptr;
        if (!number || *number < 0 || *number > 1'000'000) {
            throw wrong(key, value, "a whole number is needed here");
        }
        return static_cast<int>(*number);
    }
    const ValueList& list(const char* key) const {
        const Value* value = tree_.find(key);
        if (!value || !value->list()) throw wrong(key, value, "a list is needed here");
        return *value->list();
    }
    double number(const char* key) const {
        const Value* value = tree_.find(key);
        if (!value || !value->is_number()) throw wrong(key, value, number_rule);
        return value->number();
    }
    /// The map under `key`.
    Entries inside(const char* key) const {
        const Value* value = tree_.find(key);
        if (!value || !value->map()) throw wrong(key, value, "a map is needed here");
        return {*value, place(key)};
    }
    std::vector<double> numbers(const char* key) const {
        std::vector<double> result;
        for (const Value& value : list(key)) {
            if (!value.is_number()) throw wrong(at(key, result.size()), &value, number_rule);
            result.push_back(value.number());
        }
        return result;
    }
    /// Appends `count` numbers from the list `value`, which stands at `entry`.
    void append_row(std::vector<double>& to, const Value& value, std::size_t count,
                    const std::string& entry) const {
        const ValueList* row = value.list();
        if (!row || row->size() != count) {
            throw wrong(entry, &value,
                        "a list of " + std::to_string(count) + " numbers is needed here");
        }
        for (const Value& cell : *row) {
            if (!cell.is_number()) throw wrong(entry, &cell, number_rule);
            to.push_back(cell.number());
        }
    }
    /// Rows of the curve's dimension.
    Points points(const char* key) const {
        const ValueList& rows = list(key);
        const ValueList* first = rows.empty() ? nullptr : rows[0].list();
        const std::size_t stated = has("dimension") ? static_cast<std::size_t>(whole("dimension"))
                                   : first          ? first->size()
                                                    : 0;
        if (rows.empty() || stated == 0) {
            throw wrong(key, tree_.find(key), "a list of points [x, y, ...] is needed here");
        }
        std::vector<double> values;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            append_row(values, rows[i], stated, at(key, i));
        }
        return {std::move(values), static_cast<int>(stated)};
    }

    static std::string at(const std::string& key, std::size_t index) {
        return key + '[' + std::to_string(index) + ']';
    }
    Error wrong(const std::string& entry, const Value* value, std::string rule) const {
        return {"curve.entry", place(entry), shown(value), std::move(rule)};
    }

private:
    static constexpr const char* number_rule = "a number is needed here";

    const Value& tree_;
    std::string place_;
};

/// Throws `curve.entry`.
void require_size(const Entries& entries, const char* key, std::size_t size, std::size_t needed);

}  // namespace batten::exchange
