#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/json.hpp"
#include "io/tables/utf8.hpp"

namespace batten {
namespace {

constexpr std::size_t page_width = 100;
constexpr std::size_t no_limit = static_cast<std::size_t>(-1);

void append_text(std::string& out, std::string_view text) {
    out += '"';
    while (!text.empty()) {
        const std::size_t length = utf8::length(text);
        if (text[0] == '"' || text[0] == '\\') {
            out += '\\';
            out += text[0];
        } else if (length > 0) {
            out += text.substr(0, length);
        } else if (static_cast<unsigned char>(text[0]) < 0x20) {
            constexpr char figures[] = "0123456789abcdef";
            out += "\\u00";
            out += figures[text[0] >> 4];
            out += figures[text[0] & 15];
        } else {
            utf8::append(out, 0xFFFD);
        }
        text.remove_prefix(length > 0 ? length : 1);
    }
    out += '"';
}

void append_number(std::string& out, double x) {
    if (!std::isfinite(x)) {
        throw Error("number.overflow", "output", format_number(x),
                    "results must lie within the range of a double");
    }
    out += format_number(x);
}

void append_scalar(std::string& out, const Value& value) {
    if (const bool* truth = value.truth()) {
        out += *truth ? "true" : "false";
    } else if (const long long* whole = value.integer()) {
        out += std::to_string(*whole);
    } else if (const double* real = value.real()) {
        append_number(out, *real);
    } else if (const std::string* text = value.text()) {
        append_text(out, *text);
    } else {
        out += "null";
    }
}

/// Appends the one-line form; gives up, with false, once `out` is longer than `limit`.
bool append_line(std::string& out, const Value& value, std::size_t limit) {
    const char* joint = "";
    if (const ValueList* list = value.list()) {
        out += '[';
        for (const Value& entry : *list) {
            out += joint;
            joint = ", ";
            if (!append_line(out, entry, limit)) return false;
        }
        out += ']';
    } else if (const ValueMap* map = value.map()) {
        out += '{';
        for (const auto& [key, entry] : *map) {
            out += joint;
            joint = ", ";
            append_text(out, key);
            out += ": ";
            if (!append_line(out, entry, limit)) return false;
        }
        out += '}';
    } else {
        append_scalar(out, value);
    }
    return out.size() <= limit;
}

bool is_scalar(const Value& value) { return !value.list() && !value.map(); }

void append_page(std::string& out, const Value& value, std::size_t indent);

void start_line(std::string& out, std::size_t indent) {
    out += '\n';
    out.append(indent, ' ');
}

/// Scalars side by side as far as the page is wide, everything else on a line of its own.
void append_list(std::string& out, const ValueList& list, std::size_t indent) {
    out += '[';
    std::size_t line_start = out.size();
    bool side_by_side = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
        std::string entry;
        append_page(entry, list[i], indent + 2);
        const bool fits = out.size() - line_start + entry.size() + 2 <= page_width;
        if (side_by_side && is_scalar(list[i]) && fits) {
            out += ' ';
        } else {
            line_start = out.size() + 1;
            start_line(out, indent + 2);
        }
        out += entry;
        if (i + 1 < list.size()) out += ',';
        side_by_side = is_scalar(list[i]);
    }
    start_line(out, indent);
    out += ']';
}

void append_map(std::string& out, const ValueMap& map, std::size_t indent) {
    out += '{';
    for (std::size_t i = 0; i < map.size(); ++i) {
        start_line(out, indent + 2);
        append_text(out, map[i].first);
        out += ": ";
        append_page(out, map[i].second, indent + 2);
        if (i + 1 < map.size()) out += ',';
    }
    start_line(out, indent);
    out += '}';
}

void append_page(std::string& out, const Value& value, std::size_t indent) {
    if (is_scalar(value)) return append_scalar(out, value);
    const std::size_t start = out.size();
    const std::size_t used = std::max(start - (out.rfind('\n') + 1), indent) + 1;
    const bool is_whole_page = indent == 0 && value.map() && !value.map()->empty();
    if (!is_whole_page && used < page_width) {
        if (append_line(out, value, start + page_width - used)) return;
        out.resize(start);
    }
    if (const ValueList* list = value.list()) {
        append_list(out, *list, indent);
    } else {
        append_map(out, *value.map(), indent);
    }
}

}  // namespace

std::string dump_json(const Value& value, JsonStyle style) {
    std::string out;
    if (style == JsonStyle::one_line) {
        append_line(out, value, no_limit);
    } else {
        append_page(out, value, 0);
        out += '\n';
    }
    return out;
}

}  // namespace batten
