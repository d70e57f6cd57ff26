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

/// `weight_exponent` as `--weight-exponent`, a list `knots_values` beside the choice `knots` as
/// `--knots`.
std::string flag_of_field(std::string name) {
    if (name.ends_with("_values")) name.resize(name.rfind("_values"));
    return "--" + batten::cli::flag_name(name);
}

bool is_field(const batten::Operation& operation, const std::string& name) {
    return name == "columns" ||
           std::any_of(operation.fields.begin(), operation.fields.end(),
                       [&](const batten::Field& field) { return field.name == name; });
}

/// Text with the fields among its words as flags: all of them, or only those that no sentence has
/// for words of its own.
std::string with_flags(const std::string& text, const batten::Operation& operation,
                       bool are_all_fields) {
    std::string typed;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" ,;:", start), text.size());
        const std::string word = text.substr(start, end - start);
        const bool is_name = are_all_fields || word.find('_') != std::string::npos;
        typed += is_name && is_field(operation, word) ? flag_of_field(word) : word;
        if (end < text.size()) typed += text[end];
        start = end + 1;
    }
    return typed;
}

/// Whether a place is a field, or several with commas between them.
bool are_fields(const std::string& place, const batten::Operation& operation) {
    std::size_t start = 0;
    while (true) {
        const std::size_t end = std::min(place.find(", ", start), place.size());
        if (!is_field(operation, place.substr(start, end - start))) return false;
        if (end == place.size()) return true;
        start = end + 2;
    }
}

/// Options are shown as they are typed.
batten::Error as_typed(const batten::Error& error, const batten::Operation& operation) {
    const std::string rule = with_flags(error.rule(), operation, false);
    std::string place = error.place();
    const bool is_option = error.code().starts_with("option.");
    if (are_fields(place, operation)) {
        // A field of one plain word may be what else the error is about.
        const bool is_asked = is_option || error.code().ends_with(".options") ||
                              place.find('_') != std::string::npos;
        if (is_asked) place = with_flags(place, operation, true);
    } else if (is_option) {
        place = flag_of_field(place);
    }
    return {error.code(), place, error.value(), rule, error.rows()};
}

int run_operation(const batten::cli::Command& command) {
    using namespace batten::cli;
    require_form(command);
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
