#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "help.hpp"
#include "usage.hpp"
#include "vocabulary.hpp"

namespace batten::cli {
namespace {

/// The text of one operation's options as they are typed, by field.
struct Typed {
    const Operation* operation;
    CLI::App* verb;
    std::vector<std::vector<std::string>> values;
};

void add_field(Typed& typed, std::size_t index) {
    const Field& field = typed.operation->fields[index];
    const std::string flag = "--" + flag_name(field.name);
    if (field.kind == FieldKind::flag) {
        typed.verb->add_flag_callback(flag, [&typed, index] { typed.values[index] = {"true"}; });
        return;
    }
    // One word at a time; lists may be given piece by piece, of others the last one counts.
    typed.verb->add_option(flag, typed.values[index])
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(field.kind == FieldKind::list ? CLI::MultiOptionPolicy::TakeAll
                                                            : CLI::MultiOptionPolicy::TakeLast);
}

void add_common(CLI::App& verb, const std::vector<CommonFlag>& flags, Command& command) {
    for (const auto& [flag, member] : flags) {
        const std::string names =
            (flag.letter ? std::string("-") + flag.letter + "," : "") + "--" + flag.name;
        if (const auto* truth = std::get_if<bool Command::*>(&member)) {
            verb.add_flag(names, command.**truth);
            continue;
        }
        CLI::Option* option = verb.add_option(names, command.*std::get<std::string Command::*>(member));
        if (!flag.choices.empty()) option->check(CLI::IsMember(flag.choices));
    }
}

void add_input(CLI::App& verb, const Operation& operation, Command& command) {
    if (verb_of(operation).input.empty()) return;
    CLI::Option* input = verb.add_option("input", command.inputs)->required();
    if (!operation.many_inputs) input->expected(1);
}

/// Help as help.hpp writes it.
void set_help(CLI::App& app, const std::string& text) {
    app.set_help_flag("-h,--help", "print this help");
    app.formatter_fn([text](const CLI::App*, std::string, CLI::AppFormatMode) { return text; });
}

CLI::App* add_verb(CLI::App& app, const Verb& verb) {
    CLI::App* added = app.add_subcommand(verb.name, verb.help);
    set_help(*added, help_text(verb, help_width()));
    return added;
}

void add_run(CLI::App& app, Command& command) {
    CLI::App* run = add_verb(app, run_verb());
    run->add_option("job", command.job)->required()->expected(1);
    add_common(*run, run_flags(), command);
}

/// Whether `word` is the field's value: a number where it takes one, one of its choices, or what
/// may be meant for one, a plain word and no file.
bool is_meant_for(const Field& field, const std::string& word) {
    if (field.choices.empty()) return parse_number(word).has_value();
    const auto& words = field.choices;
    if (std::find(words.begin(), words.end(), word) != words.end()) return true;
    const bool is_plain = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string::npos;
    return is_plain && !word.empty() && !std::filesystem::exists(word);
}

/// The words typed, with a bare option's meaning written out: `--robust` is `--robust reject`
/// unless one of its words follows.
std::vector<std::string> written_out(int argc, const char* const* argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const Operation* operation = words.empty() ? nullptr : find_operation(words.front());
    if (!operation) return words;
    for (const Field& field : operation->fields) {
        if (field.bare.empty()) continue;
        const std::string flag = "--" + flag_name(field.name);
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i] != flag) continue;
            const bool has_word = i + 1 < words.size() && is_meant_for(field, words[i + 1]);
            if (!has_word) words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, field.bare);
        }
    }
    return words;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
    return text;
}

}  // namespace

Parsed parse(int argc, const char* const* argv) {
    Parsed parsed;
    Command& command = parsed.command;
    CLI::App app(about, "batten");
    app.set_version_flag("--version", std::string(version()), "print the version");
    set_help(app, help_text(help_width()));
    app.require_subcommand(1);

    // Reserved once: the options point into these.
    std::vector<Typed> verbs(operations().size());
    for (std::size_t i = 0; i < verbs.size(); ++i) {
        const Operation& operation = operations()[i];
        CLI::App* verb = add_verb(app, verb_of(operation));
        verbs[i] = {&operation, verb, std::vector<std::vector<std::string>>(operation.fields.size())};
        add_input(*verb, operation, command);
        add_common(*verb, common_flags(operation), command);
        for (std::size_t k = 0; k < operation.fields.size(); ++k) add_field(verbs[i], k);
    }
    add_run(app, command);
    const std::vector<std::string> words = written_out(argc, argv);
    require_values(app, words);
    try {
        // CLI11 takes them from the end.
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ParseError& stop) {
        if (stop.get_exit_code() == 0) {
            parsed.exit_status = app.exit(stop);
            return parsed;
        }
        throw usage_error(app, stop, words);
    }
    for (const Typed& typed : verbs) {
        if (!typed.verb->parsed()) continue;
        command.operation = typed.operation;
        for (std::size_t k = 0; k < typed.values.size(); ++k) {
            if (typed.values[k].empty()) continue;
            command.options.emplace_back(&typed.operation->fields[k], joined(typed.values[k]));
        }
    }
    return parsed;
}

}  // namespace batten::cli
