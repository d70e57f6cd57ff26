#pragma once

#include <string>

#include "batten/api/operation.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// A text and where it goes: a file, or `-` for standard output.
struct Written {
    std::string path;
    std::string text;
};

/// Everything the command asked to be written, already in its final form: so that nothing is
/// written when one of them cannot be. Throws `output.format`.
std::vector<Written> render(const Command& command, const Outcome& outcome);

void write(const Written& written);

}  // namespace batten::cli
