#pragma once

namespace batten::cli {

/// What the command tells the shell.
enum ExitStatus { done = 0, failed = 1, bad_input = 2, missed = 3 };

}  // namespace batten::cli
