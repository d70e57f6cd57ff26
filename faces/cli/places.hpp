#pragma once

#include <string>
#include <vector>

#include "batten/io/files.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// Looks at the places where commands will write before any of them runs. Throws `output.twice`
/// where two texts would go to one place, `output.is-input` where a file that is read would be
/// lost, and `file.unwritable`.
void require_places(const std::vector<const Command*>& commands);

/// Writes the files, all or none, then what goes to standard output (`-`). Throws
/// `file.unwritable`.
void write(const std::vector<FileToWrite>& texts);

}  // namespace batten::cli
