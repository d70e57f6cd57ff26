#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "batten/base/error.hpp"
#include "command_line.hpp"
#include "exit_status.hpp"
#include "inputs.hpp"
#include "outputs.hpp"
#include "places.hpp"
#include "progress_line.hpp"
#include "run_job.hpp"
#include "summary.hpp"
#include "vocabulary.hpp"

namespace {

/// Options are shown as they are typed: `option.range: weight_exponent` becomes
/// `--weight-exponent`, a list `knots_values` beside the choice `knots` `--knots`.
batten::Error as_typed(const batten::Error& error, const batten::Operation& operation) {
    std::string place = error.place();
    const bool is_field =
        place == "columns" || std::any_of(operation.fields.begin(), operation.fields.end(),
                                          [&](const batten::Field& f) { return f.name == place; });
    const bool is_option = error.code().starts_with("option.") ||
                           (is_field && error.code().ends_with(".options"));
    if (!is_option) return error;
    if (place.ends_with("_values")) place.resize(place.rfind("_values"));
    return error.at("--" + batten::cli::flag_name(place));
}

int run_operation(const batten::cli::Command& command) {
    using namespace batten::cli;
    require_places({&command});
    const std::vector<batten::Input> inputs = read_inputs(command);
    const std::vector<batten::Setting> settings = read_settings(command, inputs);
    const batten::Outcome outcome = [&] {
        ProgressLine line(command);
        return command.operation->run(inputs, settings, line.progress());
    }();

    write(render(command, outcome));
    if (!command.quiet) std::cerr << summary(*command.operation, outcome);
    return outcome.status == batten::Status::met ? done : missed;
}

int run(int argc, char** argv) {
    const batten::cli::Parsed parsed = batten::cli::parse(argc, argv);
    if (!parsed.runs()) return parsed.exit_status;
    const batten::cli::Command& command = parsed.command;
    if (!command.operation) return batten::cli::run_job(command);
    try {
        return run_operation(command);
    } catch (const batten::Error& error) {
        throw as_typed(error, *command.operation);
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const batten::Error& error) {
        std::cerr << "batten: error: " << error.what() << '\n';
        return batten::cli::bad_input;
    } catch (const std::bad_alloc&) {
        std::cerr << "batten: out of memory\n";
    } catch (const std::exception& trouble) {
        std::cerr << "batten: internal error: " << trouble.what() << '\n';
    }
    return batten::cli::failed;
}
    require_form(command);
