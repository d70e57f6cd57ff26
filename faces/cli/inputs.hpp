#pragma once

#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// What the command's operation works on, read from its files.
std::vector<Input> read_inputs(const Command& command);

/// One of them.
Input read_input(const std::string& path, const Command& command);

/// What a text typed for an option means; see read_settings.
Argument argument_of(const Command& command, const Field& field, const std::string& text,
                     const std::vector<Input>& inputs);

/// The command's options, files among them read: a list may be a FILE, a choice a column of the
/// input.
std::vector<Setting> read_settings(const Command& command, const std::vector<Input>& inputs);

}  // namespace batten::cli
