#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "batten/base/error.hpp"

namespace batten::cli {

/// What is wrong with the words typed, which `app` refused by `stop`: `command.missing`,
/// `command.unknown`, `input.missing`, `input.count`, `option.unknown`, `option.value` or
/// `option.choice`.
Error usage_error(const CLI::App& app, const CLI::ParseError& stop,
                  const std::vector<std::string>& words);

}  // namespace batten::cli
