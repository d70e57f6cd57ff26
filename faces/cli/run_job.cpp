#include "run_job.hpp"

#include <iostream>
#include <optional>
#include <utility>

#include "batten/api/argument.hpp"
#include "batten/api/job.hpp"
#include "batten/io/files.hpp"
#include "batten/io/json.hpp"
#include "exit_status.hpp"
#include "inputs.hpp"
#include "outputs.hpp"
#include "places.hpp"
#include "progress_line.hpp"
#include "summary.hpp"

namespace batten::cli {
namespace {

/// A step whose files are read; what comes from steps before it is still missing.
struct Prepared {
    const Step* step;
    Command command;
    std::vector<std::optional<Input>> inputs;
    std::vector<std::optional<Argument>> arguments;  ///< one an option
};

/// Runs `work`; its errors tell the place inside the job.
template <class Work>
auto inside_step(const Step& step, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const Error& error) {
        throw inside(step, error);
    }
}

Command command_of(const Step& step, const Command& run) {
    Command command;
    command.operation = step.operation;
    command.step = step.place;
    command.job = run.job;
    for (const StepInput& input : step.inputs) {
        if (const auto* path = std::get_if<std::string>(&input)) command.inputs.push_back(*path);
    }
    for (const auto& [field, option] : step.options) {
        const Value* value = std::get_if<Value>(&option);
        const std::string* text = value ? value->text() : nullptr;
        if (text) command.options.emplace_back(field, *text);
    }
    command.output = step.output;
    command.format = step.format;
    command.report = step.report;
    command.drawing = step.draw;
    command.columns = step.columns;
    command.progress = run.progress;
    command.quiet = run.quiet;
    return command;
}

std::optional<Input> prepared_input(const Command& command, const StepInput& input) {
    if (const std::string* path = std::get_if<std::string>(&input)) {
        return read_input(*path, command);
    }
    if (const Input* given = std::get_if<Input>(&input)) return *given;
    return std::nullopt;
}

/// Whether what a text means depends on the input: it may be a column of it, or points beside it.
bool depends_on_input(const Field& field) {
    return field.kind == FieldKind::choice || field.kind == FieldKind::errors ||
           field.kind == FieldKind::shape;
}

/// The argument, or nothing where it waits for a step before: its result, or a column of it.
std::optional<Argument> prepared_argument(const Prepared& prepared, const Field& field,
                                          const StepOption& option) {
    const Value* value = std::get_if<Value>(&option);
    if (!value) return std::nullopt;
    const std::string* text = value->text();
    if (!text) return batten::argument_of(field, *value);
    std::vector<Input> inputs;
    for (const std::optional<Input>& input : prepared.inputs) {
        if (!input && depends_on_input(field)) return std::nullopt;
        if (input) inputs.push_back(*input);
    }
    return argument_of(prepared.command, field, *text, inputs);
}

Prepared prepare(const Step& step, const Command& run) {
    Prepared prepared{&step, command_of(step, run), {}, {}};
    require_form(prepared.command);
    for (const StepInput& input : step.inputs) {
        prepared.inputs.push_back(prepared_input(prepared.command, input));
    }
    std::vector<Setting> known;
    for (const auto& [field, option] : step.options) {
        prepared.arguments.push_back(prepared_argument(prepared, *field, option));
        if (prepared.arguments.back()) known.push_back({field->name, *prepared.arguments.back()});
    }
    step.operation->check(known);
    return prepared;
}

Outcome outcome_of(const Prepared& prepared, const std::vector<Step>& steps,
                   const std::vector<Outcome>& before) {
    const Step& step = *prepared.step;
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < step.inputs.size(); ++i) {
        const auto* earlier = std::get_if<EarlierStep>(&step.inputs[i]);
        inputs.push_back(earlier ? input_of(before[earlier->index],
                                            steps[earlier->index].name,
                                            *step.operation, step.columns)
                                 : *prepared.inputs[i]);
    }
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < step.options.size(); ++i) {
        const auto& [field, option] = step.options[i];
        const auto* earlier = std::get_if<EarlierStep>(&option);
        Argument argument = prepared.arguments[i] ? *prepared.arguments[i]
                            : earlier ? batten::argument_of(before[earlier->index],
                                                            steps[earlier->index].name)
                                      : argument_of(prepared.command, *field,
                                                    *std::get<Value>(option).text(), inputs);
        settings.push_back({field->name, std::move(argument)});
    }
    ProgressLine line(prepared.command);
    return step.operation->run(inputs, settings, line.progress());
}

}  // namespace

int run_job(const Command& command) {
    const Source source = read_source(command.job);
    const std::vector<Step> steps = job_of(parse_json(source.bytes, source.name), source.name);
    std::vector<Prepared> prepared;
    for (const Step& step : steps) {
        prepared.push_back(inside_step(step, [&] { return prepare(step, command); }));
        prepared.back().command.keeps_result = prepared.size() < steps.size();
    }
    std::vector<const Command*> commands;
    for (const Prepared& each : prepared) commands.push_back(&each.command);
    require_places(commands);
    std::vector<Outcome> outcomes;
    for (const Prepared& each : prepared) {
        outcomes.push_back(
            inside_step(*each.step, [&] { return outcome_of(each, steps, outcomes); }));
    }
    std::vector<FileToWrite> files;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (FileToWrite& file : inside_step(
                 steps[i], [&] { return render(prepared[i].command, outcomes[i]); })) {
            files.push_back(std::move(file));
        }
    }
    write(files);
    int status = done;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (!command.quiet) std::cerr << summary(*steps[i].operation, outcomes[i]);
        if (outcomes[i].status != Status::met) status = missed;
    }
    return status;
}

}  // namespace batten::cli
