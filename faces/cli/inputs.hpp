#pragma once

#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// What the command's operation works on, read from its files.
std::vector<Input> read_inputs(const Command& command);

/// The command's options, files among them read: a list may be a FILE, a choice a column of the
/// input.
std::vector<Setting> read_settings(const Command& command, const std::vector<Input>& inputs);

}  // namespace batten::cli
