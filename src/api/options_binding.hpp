#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "api/field_text.hpp"
#include "batten/api/operation.hpp"
#include "batten/base/error.hpp"

/// From an options struct's `visit_fields` to fields, settings and trees.
namespace batten::api {

/// A default as help shows it: nothing for what is unset, off or empty.
std::string default_text(const Value& value);

template <class E>
std::vector<std::string> choices_of(const E& member) {
    std::vector<std::string> words;
    if constexpr (NamedEnum<E>) {
        for (const auto& word : names_of(member)) words.emplace_back(word.name);
    }
    return words;
}

template <class T>
std::vector<std::string> choices_of(const std::optional<T>&) {
    return choices_of(T{});
}

template <class E>
std::string bare_of(const E& member) {
    if constexpr (BareEnum<E>) return std::string(name_of(bare_word(member)));
    return {};
}

/// `a|b|c`.
std::string joined(const std::vector<std::string>& words);

template <class Options>
std::vector<Field> describe() {
    std::vector<Field> fields;
    const Options defaults;
    visit_fields(defaults, [&](const char* name, const auto& member, Limits limits,
                               const char* help) {
        const Spelling how = spelling(member);
        std::vector<std::string> choices = choices_of(member);
        fields.push_back({name, how.kind,
                          choices.empty() ? std::string(how.takes) : joined(choices), help,
                          default_text(shown(member)), limits, std::move(choices), how.takes_file,
                          bare_of(member)});
    });
    return fields;
}

/// The options that `settings` ask for. Throws `option.unknown` and what `read` throws.
///
/// A choice `x` with a sibling list `x_values` also takes the numbers themselves.
template <class Options>
Options options_from(const std::vector<Setting>& settings) {
    Options options;
    for (const Setting& setting : settings) {
        const bool numbers = !std::holds_alternative<std::string>(setting.value);
        bool known = false, is_choice = false;
        const auto try_set = [&](const std::string& wanted) {
            visit_fields(options, [&](const char* name, auto& member, Limits limits,
                                      const char*) {
                if (wanted != name) return;
                is_choice = spelling(member).kind == FieldKind::choice;
                if (is_choice && numbers) return;
                read(setting.value, member, Slot{name, limits});
                known = true;
            });
        };
        try_set(setting.name);
        if (!known && is_choice) try_set(setting.name + "_values");
        if (!known) {
            throw Error("option.unknown", setting.name, "given",
                        "this operation has no such option, or it takes a word");
        }
    }
    return options;
}

template <class Options>
Value options_value(const Options& options) {
    ValueMap map;
    visit_fields(options, [&](const char* name, const auto& member, Limits, const char*) {
        map.emplace_back(name, shown(member));
    });
    return map;
}

/// Throws `fit.options` where an option that is not among `used` differs from its default.
template <class Options>
void require_only(const Options& options, std::initializer_list<std::string_view> used,
                  const char* rule) {
    const Value defaults = options_value(Options{});
    const Value asked = options_value(options);
    for (const auto& [name, value] : *asked.map()) {
        const bool is_used = std::find(used.begin(), used.end(), name) != used.end();
        if (is_used || value == *defaults.find(name)) continue;
        const std::string text = default_text(value);
        throw Error("fit.options", name, text.empty() ? "given" : text, rule);
    }
}

}  // namespace batten::api
