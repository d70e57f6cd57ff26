#include <algorithm>
#include <optional>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/svg_path.hpp"

namespace batten {
namespace {

/// Steps through the tags of an SVG picture; comments and CDATA hold none.
class TagReader {
public:
    explicit TagReader(std::string_view text) : rest_(text) {}

    /// The text between the name of the next `path` tag and its end.
    std::optional<std::string_view> next_path() {
        while (true) {
            const std::size_t open = rest_.find('<');
            if (open == std::string_view::npos) return std::nullopt;
            rest_.remove_prefix(open);
            if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>")) continue;
            const std::string_view tag = rest_.substr(0, tag_end());
            rest_.remove_prefix(tag.size());
            const std::size_t name_end = std::min(tag.find_first_of(" \t\r\n"), tag.size());
            if (tag.substr(0, name_end) == "<path") return tag.substr(name_end);
        }
    }

private:
    bool skip(std::string_view opening, std::string_view closing) {
        if (rest_.substr(0, opening.size()) != opening) return false;
        const std::size_t end = rest_.find(closing, opening.size());
        rest_.remove_prefix(std::min(end == std::string_view::npos ? end : end + closing.size(),
                                     rest_.size()));
        return true;
    }
    /// Where the tag ends; a `>` inside quotes does not end it.
    std::size_t tag_end() const {
        char quote = '\0';
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            const char c = rest_[i];
            if (quote == '\0' && c == '>') return i;
            if (c == quote) {
                quote = '\0';
            } else if (quote == '\0' && (c == '"' || c == '\'')) {
                quote = c;
            }
        }
        return rest_.size();
    }

    std::string_view rest_;
};

/// The value of attribute `name` among the attributes of a tag.
std::optional<std::string_view> attribute(std::string_view text, std::string_view name) {
    while (true) {
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const std::string_view found = trimmed(text.substr(0, equals));
        const std::size_t open = text.find_first_of("\"'", equals);
        if (open == std::string_view::npos) return std::nullopt;
        const std::size_t close = text.find(text[open], open + 1);
        if (close == std::string_view::npos) return std::nullopt;
        if (found == name) return text.substr(open + 1, close - open - 1);
        text.remove_prefix(close + 1);
    }
}

}  // namespace

std::string_view first_svg_path(std::string_view picture, const std::string& place) {
    TagReader tags(picture);
    while (const std::optional<std::string_view> path = tags.next_path()) {
        if (const auto data = attribute(*path, "d")) return *data;
    }
    throw Error("svg.no-path", place, "no path", "the picture must hold a path element with data d");
}

}  // namespace batten
