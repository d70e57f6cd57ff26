#include "api/options_binding.hpp"

#include "batten/base/text.hpp"

namespace batten::api {

std::string default_text(const Value& value) {
    if (const std::string* text = value.text()) return *text;
    if (value.is_number()) return format_number(value.number());
    return {};
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
}

}  // namespace batten::api
