#include "batten/base/error.hpp"

#include <utility>

namespace batten {
namespace {

/// An error says everything, also of a text that was left empty.
std::string said(std::string text, const char* otherwise) {
    return text.empty() ? otherwise : std::move(text);
}

}  // namespace

Error::Error(std::string code, std::string place, std::string value, std::string rule,
             std::vector<std::size_t> rows)
    : std::runtime_error(code + ": " + said(place, "an empty name") + ": " +
                         said(value, "an empty text") + ": " + rule),
      code_(std::move(code)),
      place_(said(std::move(place), "an empty name")),
      value_(said(std::move(value), "an empty text")),
      rule_(std::move(rule)),
      rows_(std::move(rows)) {}

}  // namespace batten
