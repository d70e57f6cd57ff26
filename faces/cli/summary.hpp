#pragma once

#include <string>

#include "batten/api/operation.hpp"

namespace batten::cli {

/// The report for people: one line a number, the long lists cut short.
std::string summary(const Operation& operation, const Outcome& outcome);

}  // namespace batten::cli
