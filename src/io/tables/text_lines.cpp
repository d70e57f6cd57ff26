#include <algorithm>

#include "batten/base/text.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::tables {
namespace {

constexpr std::string_view blanks = " \t";

/// `at` moved over blanks; over spaces only where a tab is the separator.
std::size_t after_blanks(std::string_view line, std::size_t at, char separator) {
    while (at < line.size() && (line[at] == ' ' || (line[at] == '\t' && separator != '\t'))) ++at;
    return at;
}

/// The quote that closes the one before `at`; two quotes together do not.
std::size_t closing_quote(std::string_view line, std::size_t at) {
    while (true) {
        at = line.find('"', at);
        if (at == std::string_view::npos || line.substr(at, 2) != "\"\"") return at;
        at += 2;
    }
}

std::size_t find_separator(std::string_view line, std::size_t at, char separator) {
    const std::size_t found =
        separator == ' ' ? line.find_first_of(blanks, at) : line.find(separator, at);
    return std::min(found, line.size());
}

}  // namespace

Lines::Lines(std::string_view text)
    : rest_(utf8::without_byte_order_mark(text)),
      end_(rest_.find('\n') == std::string_view::npos ? '\r' : '\n') {}

bool Lines::next() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find(end_), rest_.size());
    line_ = rest_.substr(0, end);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    return true;
}

std::size_t Lines::estimate() const {
    const std::string_view sample = rest_.substr(0, 1 << 14);
    if (sample.empty()) return 0;
    const auto ends = static_cast<double>(std::count(sample.begin(), sample.end(), end_));
    return static_cast<std::size_t>(ends * static_cast<double>(rest_.size()) /
                                    static_cast<double>(sample.size()));
}

char separator_of(std::string_view line) {
    line = trimmed(line);
    char best = ' ';
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == ';') return c;
        if (c == '\t' || (c == ',' && best == ' ')) best = c;
    }
    return best;
}

bool split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    line = separator == '\t' ? line : trimmed(line);
    for (std::size_t at = 0;; ++at) {
        at = after_blanks(line, at, separator);
        if (at < line.size() && line[at] == '"') {
            const std::size_t close = closing_quote(line, at + 1);
            if (close == std::string_view::npos) return false;
            cells.push_back(line.substr(at + 1, close - at - 1));
            const std::size_t end = find_separator(line, close + 1, separator);
            if (!trimmed(line.substr(close + 1, end - close - 1)).empty()) return false;
            at = end;
        } else {
            const std::size_t end = find_separator(line, at, separator);
            cells.push_back(trimmed(line.substr(at, end - at)));
            at = end;
        }
        if (at == line.size()) return true;
    }
}

std::string cell_text(std::string_view cell) {
    std::string text(cell);
    for (std::size_t at = text.find("\"\""); at != std::string::npos;
         at = text.find("\"\"", at + 1)) {
        text.erase(at, 1);
    }
    return text;
}

}  // namespace batten::tables
