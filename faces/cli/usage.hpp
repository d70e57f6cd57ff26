#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "batten/base/error.hpp"

namespace batten::cli {

/// `; did you mean X?` where one of `known` is at most two letters away, and closer than nothing.
std::string guess(const std::string& word, const std::vector<std::string>& known);

/// Throws `option.value` where an option of the verb stands in the place of another's value.
void require_values(const CLI::App& app, const std::vector<std::string>& words);

/// What is wrong with the words typed, which `app` refused by `stop`: `command.missing`,
/// `command.unknown`, `input.missing`, `input.count`, `option.unknown`, `option.value` or
/// `option.choice`.
Error usage_error(const CLI::App& app, const CLI::ParseError& stop,
                  const std::vector<std::string>& words);

}  // namespace batten::cli
