#include <exception>
#include <iostream>
#include <new>

#include "batten/base/error.hpp"
#include "command_line.hpp"
#include "inputs.hpp"
#include "outputs.hpp"
#include "progress_line.hpp"
#include "summary.hpp"

namespace {

constexpr int done = 0, failed = 1, bad_input = 2, missed = 3;

/// Options are shown as they are typed: `option.range: weight_exponent` becomes
/// `--weight-exponent`.
std::string place_of(const batten::Error& error) {
    if (error.code().rfind("option.", 0) != 0) return error.place();
    return "--" + batten::cli::flag_name(error.place());
}

int run(int argc, char** argv) {
    using namespace batten::cli;
    const Parsed parsed = parse(argc, argv);
    if (!parsed.runs()) return parsed.exit_status;
    const Command& command = parsed.command;

    const std::vector<batten::Input> inputs = read_inputs(command);
    const std::vector<batten::Setting> settings = read_settings(command, inputs);
    const batten::Outcome outcome = [&] {
        ProgressLine line(command);
        return command.operation->run(inputs, settings, line.progress());
    }();

    for (const Written& written : render(command, outcome)) write(written);
    if (!command.quiet) std::cerr << summary(*command.operation, outcome);
    return outcome.status == batten::Status::met ? done : missed;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const batten::Error& error) {
        std::cerr << "batten: error: " << error.code() << ": " << place_of(error) << ": "
                  << error.value() << ": " << error.rule() << '\n';
        return bad_input;
    } catch (const std::bad_alloc&) {
        std::cerr << "batten: out of memory\n";
    } catch (const std::exception& trouble) {
        std::cerr << "batten: internal error: " << trouble.what() << '\n';
    }
    return failed;
}
