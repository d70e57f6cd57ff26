#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

#include "shared.hpp"

namespace batten::testing {

/// The content of a file of ../shared: after SKIP_UNLESS_SHARED(name).
inline nlohmann::json shared_json(std::string_view name) {
    return nlohmann::json::parse(read_text(shared_file(name).value()));
}

/// The content of a file of this checkout.
inline nlohmann::json source_json(std::string_view name) {
    return nlohmann::json::parse(read_text(source_file(name)));
}

}  // namespace batten::testing
