#pragma once

#include <cstdlib>

#include "batten/base/error.hpp"

/// What every reader promises, whatever bytes it is given.
namespace batten::fuzz {

inline void require(bool promise) {
    if (!promise) std::abort();
}

/// An error says everything.
inline void check_error(const Error& error) {
    require(!error.code().empty() && !error.place().empty() && !error.value().empty() &&
            !error.rule().empty());
}

}  // namespace batten::fuzz
