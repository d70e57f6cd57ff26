#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "batten/base/error.hpp"

namespace batten::cli {
namespace {

constexpr const char* footer =
    "Every verb reads one input (- for standard input) and writes curves as JSON, points as CSV,\n"
    "to standard output or to -o FILE. Verbs read what other verbs write:\n"
    "  batten interpolate points.csv | batten measure -\n"
    "Exit status: 0 done, 2 bad input, 3 the result misses what was asked, 1 anything else.";

/// The text of one operation's options as they are typed, by field.
struct Typed {
    const Operation* operation;
    CLI::App* verb;
    std::vector<std::vector<std::string>> values;
};

std::string description(const Field& field) {
    std::string text = field.help;
    if (!field.default_text.empty()) text += " [" + field.default_text + "]";
    return text;
}

void add_field(Typed& typed, std::size_t index) {
    const Field& field = typed.operation->fields[index];
    const std::string flag = "--" + flag_name(field.name);
    CLI::Option* option = nullptr;
    if (field.kind == FieldKind::flag) {
        option = typed.verb->add_flag_callback(
            flag, [&typed, index] { typed.values[index] = {"true"}; }, description(field));
    } else {
        option = typed.verb->add_option(flag, typed.values[index], description(field));
        // One word at a time; lists may be given piece by piece, of others the last one counts.
        option->type_name(field.takes)->expected(1)->multi_option_policy(
            field.kind == FieldKind::list ? CLI::MultiOptionPolicy::TakeAll
                                          : CLI::MultiOptionPolicy::TakeLast);
    }
    option->group("Options");
}

void add_common(CLI::App& verb, const Operation& operation, Command& command) {
    const char* const what = operation.input == InputKind::points ? "POINTS"
                             : operation.input == InputKind::curve ? "CURVE"
                             : operation.input == InputKind::grid ? "GRID"
                             : operation.input == InputKind::surface ? "SURFACE"
                                                                   : "POINTS|CURVE";
    CLI::Option* input = verb.add_option("input", command.inputs, "the file to read, - for standard input");
    input->required()->type_name(what);
    if (!operation.many_inputs) input->expected(1);
    const std::string group = "Input and output";
    verb.add_option("-o,--output", command.output, "write the result to this file, its form by suffix")
        ->type_name("FILE")->group(group);
    verb.add_option("--format", command.format, "the form to write: json, csv, svg, npy, dxf, gcode")
        ->type_name("NAME")->group(group);
    verb.add_option("--report", command.report, "write the report as JSON, - for standard output")
        ->type_name("FILE")->group(group);
    verb.add_option("--draw", command.drawing, "draw what was done")
        ->type_name("FILE.svg")->group(group);
    verb.add_option("--columns", command.columns, "columns that hold the coordinates: names or #k, k from 1")
        ->type_name("X,Y[,Z]")->group(group);
    verb.add_option("--progress", command.progress, "progress of long work on standard error [auto]")
        ->type_name("WHEN")->check(CLI::IsMember({"auto", "always", "never"}))->group(group);
    verb.add_flag("--quiet", command.quiet, "no summary on standard error")->group(group);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ",") + part;
    return text;
}

}  // namespace

std::string flag_name(const std::string& field) {
    std::string name = field;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

Parsed parse(int argc, const char* const* argv) {
    Parsed parsed;
    Command& command = parsed.command;
    CLI::App app("Batten: fair curves through points, and how good they are.", "batten");
    app.footer(footer);
    app.set_version_flag("--version", std::string(version()), "print the version");
    app.set_help_flag("-h,--help", "print this help");
    app.require_subcommand(1);

    // Reserved once: the options point into these.
    std::vector<Typed> verbs(operations().size());
    for (std::size_t i = 0; i < verbs.size(); ++i) {
        const Operation& operation = operations()[i];
        CLI::App* verb = app.add_subcommand(std::string(operation.name), std::string(operation.help));
        verbs[i] = {&operation, verb, std::vector<std::vector<std::string>>(operation.fields.size())};
        add_common(*verb, operation, command);
        for (std::size_t k = 0; k < operation.fields.size(); ++k) add_field(verbs[i], k);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
        if (stop.get_exit_code() == 0) {
            parsed.exit_status = app.exit(stop);
            return parsed;
        }
        throw Error("usage", "command line", argc > 1 ? argv[1] : "nothing", stop.what());
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
