#pragma once

#include <map>
#include <string>
#include <vector>

#include "batten/api/operation.hpp"

namespace batten::cli {

/// What a person typed, checked against the operations table for its form only.
struct Command {
    const Operation* operation = nullptr;
    std::vector<std::string> inputs;
    /// Per option of the operation, as typed; repeated options are joined by commas.
    std::vector<std::pair<const Field*, std::string>> options;

    std::string output;   ///< -o, empty for standard output
    std::string format;   ///< --format, empty for the suffix of -o
    std::string report;   ///< --report, empty for none
    std::string drawing;  ///< --draw, empty for none
    std::string columns;  ///< --columns, empty for the first two or three
    std::string progress = "auto";
    bool quiet = false;
    std::string job;            ///< the job file of `run`, which has no operation
    bool keeps_result = false;  ///< a step before a job's last writes no output but what it names
};

/// Either a command, or the exit status of `--help`, `--version` and the like, already printed.
struct Parsed {
    Command command;
    int exit_status = -1;
    bool runs() const { return exit_status < 0; }
};

/// Throws `usage` errors as `Error`.
Parsed parse(int argc, const char* const* argv);

}  // namespace batten::cli
