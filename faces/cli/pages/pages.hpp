#pragma once

#include <string>

/// Pages about the command, all made from its vocabulary.
namespace batten::cli {

/// The manual page, in the language of troff's man macros.
std::string man_page();

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace batten::cli
