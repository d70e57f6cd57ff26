#pragma once

#include "command_line.hpp"

namespace batten::cli {

/// Runs the steps of the command's job: all files are read before the first runs, and nothing is
/// written before all have run. Returns the exit status: `missed` if any step misses what was
/// asked.
int run_job(const Command& command);

}  // namespace batten::cli
