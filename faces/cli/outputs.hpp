#pragma once

#include <vector>

#include "batten/api/operation.hpp"
#include "batten/io/files.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// Throws `output.format` where the operation never writes what the command asks for.
void require_form(const Command& command);

/// Everything the command asked to be written, already in its final form: so that nothing is
/// written when one of them cannot be; `-` is standard output. Throws `output.format`.
std::vector<FileToWrite> render(const Command& command, const Outcome& outcome);

}  // namespace batten::cli
