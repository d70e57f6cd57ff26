#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/error.hpp"
#include "batten/base/value.hpp"

namespace batten {

/// The result of a step before, counted from 0.
struct EarlierStep {
    std::size_t index;
};

/// A file's name, what an earlier step made, or the points or curve themselves.
using StepInput = std::variant<std::string, EarlierStep, Input>;

/// What an option is given: what stands in the job (a text is what a person would type), or what an
/// earlier step made.
using StepOption = std::variant<Value, EarlierStep>;

/// One operation of a job, with what the command line would say after its name.
struct Step {
    std::string name;
    std::string place;  ///< what errors call it: `job.json step 2`, or `job.json` where it is alone
    const Operation* operation = nullptr;
    std::vector<StepInput> inputs;
    std::vector<std::pair<const Field*, StepOption>> options;
    std::string columns, output, format, report, draw;
};

/// The steps of a job: a map with the keys `operation`, `input` (or `inputs`, a list), `options`,
/// `columns`, `output`, `format`, `report`, `draw` and `name`; a list of such maps; or a map whose
/// only key `steps` is that list. An input that is a text is an earlier step's name or else a file;
/// points and curves may also stand there themselves. Options that take a file do the same.
///
/// Everything is checked that can be without the files. Throws, with the place inside the job,
/// `job.empty`, `job.operation`, `job.key`, `job.entry`, `job.name`, `job.input`,
/// `job.output-twice`; the `option.` errors of the operation; what argument_of and input_of throw.
std::vector<Step> job_of(const Value& tree, const std::string& place);

/// `error` with its place inside the job in front.
Error inside(const Step& step, const Error& error);

}  // namespace batten
