#pragma once

#include <string>

#include "vocabulary.hpp"

namespace batten::cli {

/// The help of the command, and that of one verb, in lines of at most `width` columns.
std::string help_text(std::size_t width);
std::string help_text(const Verb& verb, std::size_t width);

/// How wide standard output is: 80 to 100 columns on a terminal, else 100.
std::size_t help_width();

}  // namespace batten::cli
