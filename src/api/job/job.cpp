#include "batten/api/job.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "batten/api/argument.hpp"
#include "batten/io/surface_file.hpp"

namespace batten {
namespace {

Error entry_error(const std::string& place, const std::string& key, const std::string& rule) {
    return Error("job.entry", place + ", " + key, "something else", rule);
}

const std::string& text_at(const Step& step, const std::string& key, const Value& value) {
    const std::string* text = value.text();
    if (!text || text->empty()) throw entry_error(step.place, key, "must be a text");
    return *text;
}

/// The text entries of a step and where they go.
struct TextEntry {
    const char* key;
    std::string Step::*member;
};
constexpr std::array<TextEntry, 6> text_entries{{{"name", &Step::name},
                                                 {"columns", &Step::columns},
                                                 {"output", &Step::output},
                                                 {"format", &Step::format},
                                                 {"report", &Step::report},
                                                 {"draw", &Step::draw}}};

const Operation& operation_at(const Value& map, const std::string& place) {
    const Value* name = map.find("operation");
    const std::string* text = name ? name->text() : nullptr;
    const Operation* operation = text ? find_operation(*text) : nullptr;
    if (operation) return *operation;
    std::string words;
    for (const Operation& each : operations()) {
        words += (words.empty() ? "" : ", ") + std::string(each.name);
    }
    throw Error("job.operation", place + ", operation", text ? *text : "not given",
                "must be one of " + words);
}

const Field& field_at(const Step& step, const std::string& name) {
    for (const Field& field : step.operation->fields) {
        if (field.name == name) return field;
    }
    throw Error("option.unknown", step.place + ", " + name, "given",
                std::string(step.operation->name) + " has no such option");
}

/// Whether a text may name a column of the input: a sibling list `x_values` stands beside `x`.
bool takes_column(const Operation& operation, const Field& field) {
    return std::any_of(operation.fields.begin(), operation.fields.end(), [&](const Field& other) {
        return other.name == field.name + "_values";
    });
}

/// Whether a value means itself, and not a file or a column of the input.
bool stands_for_itself(const Operation& operation, const Field& field, const Value& value) {
    if (!value.text()) return true;
    const auto& words = field.choices;
    if (words.empty()) return !field.takes_file;
    return !takes_column(operation, field) ||
           std::find(words.begin(), words.end(), *value.text()) != words.end();
}

void check_option(const Step& step, const Field& field, const Value& value) {
    try {
        step.operation->check({{field.name, argument_of(field, value)}});
    } catch (const Error& error) {
        throw inside(step, error);
    }
}

/// The step before that is called so, or none. Throws where it is this one or a later one.
std::optional<EarlierStep> step_called(const std::string& text, const Step& step,
                                       const std::vector<Step>& before,
                                       const std::set<std::string>& names) {
    if (names.count(text) == 0) return std::nullopt;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].name == text) return EarlierStep{i};
    }
    throw Error("job.name", step.place, text, "must be a step before this one");
}

void read_options(Step& step, const Value& options, const std::vector<Step>& before,
                  const std::set<std::string>& names) {
    if (!options.map()) throw entry_error(step.place, "options", "must be a map");
    for (const auto& [name, value] : *options.map()) {
        const Field& field = field_at(step, name);
        if (value.is_null()) continue;
        StepOption option = value;
        if (field.takes_file && value.text()) {
            if (const auto earlier = step_called(*value.text(), step, before, names)) {
                option = *earlier;
            }
        } else if (stands_for_itself(*step.operation, field, value)) {
            check_option(step, field, value);
        }
        step.options.emplace_back(&field, std::move(option));
    }
}

bool takes_result_of(const Operation& operation, const Operation& before) {
    switch (before.output) {
        case OutputKind::curve: return takes_curve(operation.input);
        case OutputKind::rows: return takes_rows(operation.input);
        case OutputKind::curves: return takes_curve(operation.input) || takes_rows(operation.input);
        case OutputKind::surface: return takes_surface(operation.input);
        default: return false;
    }
}

StepInput named_input(const Step& step, const std::string& text, const std::vector<Step>& before,
                      const std::set<std::string>& names) {
    const std::optional<EarlierStep> earlier = step_called(text, step, before, names);
    if (!earlier) return text;
    const Operation& maker = *before[earlier->index].operation;
    if (!takes_result_of(*step.operation, maker)) {
        throw Error("job.input", step.place + ", input", text,
                    std::string(step.operation->name) + " does not take what " +
                        std::string(maker.name) + " makes");
    }
    return *earlier;
}

StepInput input_at(const Step& step, const Value& value, const std::vector<Step>& before,
                   const std::set<std::string>& names) {
    if (value.text()) return named_input(step, text_at(step, "input", value), before, names);
    if (!value.list() && !value.map()) {
        throw entry_error(step.place, "input",
                          "must be a file, a step's name, rows, a curve or a surface");
    }
    const InputKind taken = step.operation->input;
    const bool is_taken = is_surface(value) ? takes_surface(taken)
                          : value.map()     ? takes_curve(taken)
                                            : takes_rows(taken);
    if (!is_taken) {
        throw Error("job.input", step.place + ", input",
                    is_surface(value) ? "a surface" : value.map() ? "a curve" : "points",
                    std::string(step.operation->name) + " does not take these");
    }
    try {
        return input_of(value, "input", *step.operation, step.columns);
    } catch (const Error& error) {
        throw inside(step, error);
    }
}

void read_inputs(Step& step, const Value& map, const std::vector<Step>& before,
                 const std::set<std::string>& names) {
    const Value* one = map.find("input");
    const Value* many = map.find("inputs");
    if (one && many) {
        throw Error("job.key", step.place, "input and inputs", "must be one of them");
    }
    if (one) step.inputs.push_back(input_at(step, *one, before, names));
    if (many) {
        if (!many->list()) throw entry_error(step.place, "inputs", "must be a list");
        for (const Value& each : *many->list()) {
            step.inputs.push_back(input_at(step, each, before, names));
        }
    }
    const bool takes_none = step.operation->input == InputKind::none;
    if (takes_none ? !step.inputs.empty()
                   : step.inputs.empty() || (step.inputs.size() > 1 && !step.operation->many_inputs)) {
        throw Error("job.input", step.place, std::to_string(step.inputs.size()) + " inputs",
                    takes_none ? "this operation takes no input"
                    : step.operation->many_inputs ? "this operation takes at least one input"
                                                  : "this operation takes one input");
    }
}

void read_texts(Step& step, const Value& map) {
    for (const auto& pair : *map.map()) {
        const std::string& key = pair.first;
        const Value& value = pair.second;
        const auto entry = std::find_if(text_entries.begin(), text_entries.end(),
                                        [&](const TextEntry& each) { return each.key == key; });
        if (entry != text_entries.end()) {
            step.*entry->member = text_at(step, key, value);
        } else if (key != "operation" && key != "input" && key != "inputs" && key != "options") {
            throw Error("job.key", step.place, key,
                        "keys are operation, input, inputs, options, columns, output, format, "
                        "report, draw, name");
        }
    }
}

Step step_of(const Value& map, const std::string& place, const std::vector<Step>& before,
             const std::set<std::string>& names) {
    if (!map.map()) throw Error("job.entry", place, "something else", "a step must be a map");
    Step step;
    step.place = place;
    read_texts(step, map);
    step.operation = &operation_at(map, place);
    read_inputs(step, map, before, names);
    if (const Value* options = map.find("options")) read_options(step, *options, before, names);
    return step;
}

/// All names; each once.
std::set<std::string> names_in(const ValueList& steps, const std::string& place) {
    std::set<std::string> names;
    for (const Value& step : steps) {
        const Value* name = step.find("name");
        if (name && name->text() && !names.insert(*name->text()).second) {
            throw Error("job.name", place, *name->text(), "each step must have a name of its own");
        }
    }
    return names;
}

void require_different_places(const std::vector<Step>& steps) {
    std::set<std::string> places;
    for (const Step& step : steps) {
        for (const std::string* path : {&step.output, &step.report, &step.draw}) {
            if (!path->empty() && !places.insert(*path).second) {
                throw Error("output.twice", step.place, *path,
                            "must be written by one step only");
            }
        }
    }
}

}  // namespace

std::vector<Step> job_of(const Value& tree, const std::string& place) {
    const Value* list = tree.find("steps");
    if (list && tree.map()->size() > 1) {
        throw Error("job.key", place, "keys beside steps", "steps must be the only key");
    }
    if (!list) list = &tree;
    const bool is_alone = list->map() != nullptr;
    if (!is_alone && !list->list()) {
        throw Error("job.entry", place, "something else", "a job must be a map or a list of maps");
    }
    const ValueList maps = is_alone ? ValueList{*list} : *list->list();
    if (maps.empty()) throw Error("job.empty", place, "no step", "must have at least one");
    const std::set<std::string> names = names_in(maps, place);
    std::vector<Step> steps;
    for (const Value& map : maps) {
        const std::string number = is_alone ? "" : " step " + std::to_string(steps.size() + 1);
        steps.push_back(step_of(map, place + number, steps, names));
    }
    require_different_places(steps);
    return steps;
}

Error inside(const Step& step, const Error& error) {
    return {error.code(), step.place + ", " + error.place(), error.value(), error.rule(),
            error.rows()};
}

}  // namespace batten
