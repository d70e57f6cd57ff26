#include "batten/base/error.hpp"

#include <utility>

namespace batten {

Error::Error(std::string code, std::string place, std::string value, std::string rule,
             std::vector<std::size_t> rows)
    : std::runtime_error(code + ": " + place + ": " + value + ": " + rule),
      code_(std::move(code)),
      place_(std::move(place)),
      value_(std::move(value)),
      rule_(std::move(rule)),
      rows_(std::move(rows)) {}

}  // namespace batten
