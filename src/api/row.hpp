#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "api/options_binding.hpp"
#include "api/report_value.hpp"
#include "batten/api/operation.hpp"

/// What the rows of the operations table are made with.
namespace batten::api {

/// Name, help, and what goes in and out.
struct Head {
    std::string_view name;
    std::string_view help;
    InputKind input;
    OutputKind output;
    bool many_inputs = false;
};

/// A row from an options struct and `run(inputs, options) -> Outcome`; the outcome's options are
/// filled in here.
template <class Options, class Run>
Operation row(Head head, Run run) {
    return {head.name,
            head.help,
            head.input,
            head.many_inputs,
            head.output,
            describe<Options>(),
            [run = std::move(run)](std::span<const Input> inputs,
                                   const std::vector<Setting>& settings) {
                const Options options = options_from<Options>(settings);
                Outcome outcome = run(inputs, options);
                outcome.options = options_value(options);
                return outcome;
            }};
}

/// The one curve of the inputs. Throws `input.kind`, `input.count`.
const Curve& curve_input(std::span<const Input> inputs);

/// The one table of the inputs. Throws `input.kind`, `input.count`.
const PointsInput& points_input(std::span<const Input> inputs);

/// The coordinates of a points input.
Points points_of(const PointsInput& input);

/// `error` with the file's name, and the lines of its rows where it names any.
Error with_lines(const Error& error, const PointsInput& input);

/// Runs `work`; an error about points is told by the file's name and lines.
template <class Work>
auto naming_lines(const PointsInput& input, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const Error& error) {
        throw with_lines(error, input);
    }
}

/// The rows of the table, one function each, in the folder's files of the same name.
Operation interpolate_row();
Operation measure_row();
Operation evaluate_row();
Operation compare_row();
Operation convert_row();
Operation draw_row();
Operation coons_row();
Operation fair_row();
Operation log_aesthetic_row();

}  // namespace batten::api
