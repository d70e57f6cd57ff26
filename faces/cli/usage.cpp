#include "usage.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "vocabulary.hpp"

namespace batten::cli {
namespace {

/// Letters to insert, drop or change until one word is the other.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t corner = row[0]++;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t changed = corner + (a[i] == b[k] ? 0 : 1);
            corner = row[k + 1];
            row[k + 1] = std::min({changed, row[k] + 1, row[k + 1] + 1});
        }
    }
    return row.back();
}

std::vector<std::string> names_of(const std::vector<Verb>& verbs) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs) names.push_back(verb.name);
    return names;
}

std::vector<std::string> flags_of(const CLI::App& verb) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : verb.get_options()) {
        for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    }
    return flags;
}

std::string help_of(const CLI::App& verb) {
    return "`batten " + verb.get_name() + " --help` lists the options";
}

/// The first word that looks like an option and is none; or empty.
std::string unknown_option(const CLI::App& verb, const std::vector<std::string>& words) {
    const std::vector<std::string> known = flags_of(verb);
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        const bool is_option = name.size() > 2 && name.compare(0, 2, "--") == 0;
        if (is_option && std::find(known.begin(), known.end(), name) == known.end()) return name;
    }
    return {};
}

Error extra_word(const CLI::App& verb, const std::string& word) {
    if (word.size() > 1 && word.front() == '-') {
        return {"option.unknown", verb.get_name(), word, help_of(verb)};
    }
    return {"input.count", verb.get_name(), word, "takes one input"};
}

/// A word of the command line that is an option of the verb, and whether a value follows.
struct KnownOption {
    const CLI::Option* option;
    bool takes_next;
};

std::optional<KnownOption> known_option(const CLI::App& verb, const std::string& word) {
    const std::size_t mark = word.find('=');
    for (const CLI::Option* option : verb.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            if (word.substr(0, mark) != "--" + name) continue;
            const bool takes_value = option->get_items_expected_min() > 0;
            return KnownOption{option, takes_value && mark == std::string::npos};
        }
        for (const std::string& letter : option->get_snames()) {
            if (word != "-" + letter) continue;
            return KnownOption{option, option->get_items_expected_min() > 0};
        }
    }
    return std::nullopt;
}

/// The words behind the verb that are neither options nor their values.
std::vector<std::string> inputs_among(const CLI::App& verb, const std::vector<std::string>& words) {
    std::vector<std::string> inputs;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::optional<KnownOption> known = known_option(verb, words[i]);
        if (!known) inputs.push_back(words[i]);
        else if (known->takes_next) ++i;
    }
    return inputs;
}

/// `--degree: 1 required TEXT missing` and the like begin with the option's name.
Error wrong_option(const CLI::App& verb, const CLI::ParseError& stop,
                   const std::vector<std::string>& words) {
    std::string name = stop.what();
    name = name.substr(0, name.find(':'));
    if (name == "input") {
        const std::vector<std::string> inputs = inputs_among(verb, words);
        return {"input.count", verb.get_name(), inputs.size() > 1 ? inputs[1] : words.back(),
                "takes one input"};
    }
    const bool is_choice = dynamic_cast<const CLI::ValidationError*>(&stop) != nullptr;
    if (!is_choice) return {"option.value", name, "nothing", "a value must follow"};
    const auto found = std::find(words.begin(), words.end(), name);
    const std::string value = found == words.end() || found + 1 == words.end() ? "" : *(found + 1);
    return {"option.choice", name, value, help_of(verb)};
}

}  // namespace

std::string guess(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    std::size_t least = std::min<std::size_t>(3, word.size());
    for (const std::string& each : known) {
        const std::size_t letters = distance(word, each);
        if (letters < least) {
            least = letters;
            best = each;
        }
    }
    return best.empty() ? "" : "; did you mean " + best + "?";
}

void require_values(const CLI::App& app, const std::vector<std::string>& words) {
    const std::vector<const CLI::App*> verbs = app.get_subcommands([&](const CLI::App* each) {
        return !words.empty() && each->get_name() == words.front();
    });
    const CLI::App* const verb = verbs.empty() ? nullptr : verbs.front();
    for (std::size_t i = 1; verb && i < words.size(); ++i) {
        const std::optional<KnownOption> known = known_option(*verb, words[i]);
        if (!known || !known->takes_next) continue;
        if (i + 1 < words.size() && known_option(*verb, words[i + 1])) {
            throw Error("option.value", words[i], "nothing",
                        "a value must follow, not " + words[i + 1]);
        }
        ++i;
    }
}

Error usage_error(const CLI::App& app, const CLI::ParseError& stop,
                  const std::vector<std::string>& words) {
    const char* const help = "`batten --help` lists the commands";
    if (words.empty()) return {"command.missing", "command line", "nothing", help};
    const std::vector<CLI::App*> parsed = app.get_subcommands();
    const std::vector<std::string> known = names_of(verbs());
    if (std::find(known.begin(), known.end(), words.front()) == known.end() || parsed.empty()) {
        return {"command.unknown", "command line", words.front(), help + guess(words.front(), known)};
    }
    const CLI::App& verb = *parsed.front();
    if (const std::string option = unknown_option(verb, words); !option.empty()) {
        return {"option.unknown", verb.get_name(), option,
                help_of(verb) + guess(option, flags_of(verb))};
    }
    if (dynamic_cast<const CLI::RequiredError*>(&stop)) {
        return {"input.missing", verb.get_name(), "nothing",
                "must be given a file, or - for standard input"};
    }
    const std::vector<std::string> extra = verb.remaining();
    if (dynamic_cast<const CLI::ExtrasError*>(&stop) && !extra.empty()) {
        return extra_word(verb, extra.front());
    }
    return wrong_option(verb, stop, words);
}

}  // namespace batten::cli
