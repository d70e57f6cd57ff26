#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "api/options_binding.hpp"
#include "api/over_curves.hpp"
#include "api/report_value.hpp"
#include "batten/api/operation.hpp"
#include "batten/io/grid_stream.hpp"

/// What the rows of the operations table are made with.
namespace batten::api {

/// Name, help, and what goes in and out.
struct Head {
    std::string_view name;
    std::string_view help;
    InputKind input;
    OutputKind output;
    std::vector<std::string_view> more_forms = {};  ///< beside those of every output of its kind
    bool many_inputs = false;
    bool takes_jumps = false;  ///< curves with jumps too
};

/// The forms in which outputs of a kind are written, and `more`.
std::vector<std::string> forms_of(OutputKind kind, const std::vector<std::string_view>& more);

/// Throws `curve.jumps` where one of the curves given has jumps.
void require_no_jumps(std::span<const Input> inputs, const std::vector<Setting>& settings);

/// Runs it; several curves one by one where it takes one, or the one that the options name.
template <class Options>
Outcome run_on(std::span<const Input> inputs, const Options& options, const Head& head,
               Outcome (*run)(std::span<const Input>, const Options&)) {
    if (head.many_inputs) return run(with_single_curves(inputs), options);
    const auto run_one = [&](const Input& input) {
        return run(std::span(&input, 1), options);
    };
    if constexpr (requires { options.only; }) {
        if (options.only && inputs.size() == 1) return run_one(only_curve(inputs[0], *options.only));
    }
    const Input* several = takes_curve(head.input) ? several_curves(inputs) : nullptr;
    return several ? over_curves(*several, run_one) : run(inputs, options);
}

/// A row from an options struct and `run(inputs, options) -> Outcome`; the outcome's options are
/// filled in here, and options with a member `progress` get it.
template <class Options>
Operation row(Head head, Outcome (*run)(std::span<const Input>, const Options&)) {
    return {head.name,
            head.help,
            head.input,
            head.many_inputs,
            head.output,
            describe<Options>(),
            [run, head](std::span<const Input> inputs, const std::vector<Setting>& settings,
                        const Progress& progress) {
                if (!head.takes_jumps) require_no_jumps(inputs, settings);
                Options options = options_from<Options>(settings);
                if constexpr (requires { options.progress; }) options.progress = progress;
                Outcome outcome = run_on(inputs, options, head, run);
                outcome.options = options_value(options);
                return outcome;
            },
            [](const std::vector<Setting>& settings) { options_from<Options>(settings); },
            forms_of(head.output, head.more_forms)};
}

/// The one curve of the inputs. Throws `input.kind`, `input.count`.
const Curve& curve_input(std::span<const Input> inputs);

/// The one table of the inputs. Throws `input.kind`, `input.count`.
const PointsInput& points_input(std::span<const Input> inputs);

/// The one surface of the inputs. Throws `input.kind`, `input.count`.
const Surface& surface_input(std::span<const Input> inputs);

/// The one grid of the inputs, read where it is still a file. Throws `input.kind`, `input.count`,
/// and what parse_grid throws.
GridFile grid_input(std::span<const Input> inputs);

/// The same, to be read in blocks. Throws what GridStream throws.
GridStream grid_stream_input(std::span<const Input> inputs);

/// The same as rows of a table.
PointsInput rows_input(std::span<const Input> inputs);

/// The coordinates of a points input. Throws `points.not-finite`.
SharedPoints points_of(const PointsInput& input);

/// The numbers of one column of a table input, the memory given where they lie together there.
/// Throws what `column_values` throws.
SharedNumbers column_in(const PointsInput& input, int column);

/// The errors in one column of a table input, of which +inf (no weight) is one. Throws what
/// `column_errors` throws.
SharedNumbers errors_in(const PointsInput& input, int column);

/// What its coordinate columns are called: as in the file, else x, y, z.
std::vector<std::string> names_given(const PointsInput& input);

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
Operation densify_row();
Operation thin_row();
Operation arcs_row();
Operation measure_row();
Operation evaluate_row();
Operation fit_surface_row();
Operation contour_row();
Operation compare_row();
Operation convert_row();
Operation draw_row();
Operation sample_row();
Operation section_row();
Operation fit_row();
Operation coons_row();
Operation fair_row();
Operation fair_surface_row();
Operation log_aesthetic_row();

}  // namespace batten::api
