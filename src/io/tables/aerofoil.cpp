#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/write_points.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::tables {
namespace {

/// Whether the line is nothing but `count` numbers between blanks.
bool is_numbers(std::string_view line, std::size_t count) {
    std::vector<std::string_view> cells;
    if (!split(line, ' ', cells) || cells.size() != count) return false;
    for (const std::string_view cell : cells) {
        if (!parse_number(cell)) return false;
    }
    return true;
}

bool next_filled(Lines& lines) {
    while (lines.next()) {
        if (!trimmed(lines.text()).empty()) return true;
    }
    return false;
}

bool is_count(double x) { return x >= 2 && x == std::floor(x) && x < 1e9; }

/// The numbers of points on both sides, where the first row holds these: they add up to what
/// follows, or stand apart from it.
bool has_counts(const Table& table) {
    const Points& rows = table.cells;
    if (rows.size() < 2 || table.bad[0] || table.bad[1]) return false;
    if (!is_count(rows(0, 0)) || !is_count(rows(0, 1))) return false;
    const bool stands_apart = table.line_of_row[1] > table.line_of_row[0] + 1;
    return stands_apart || rows(0, 0) + rows(0, 1) == static_cast<double>(rows.size() - 1);
}

/// Lednicer's two blocks, both from the nose, turned into Selig's one outline: from the tail over
/// the upper side to the nose and back along the lower side.
void join_sides(Table& table) {
    const Points given = table.cells;
    const std::vector<int> lines = table.line_of_row;
    const std::size_t upper = static_cast<std::size_t>(given(0, 0));
    const std::size_t lower = static_cast<std::size_t>(given(0, 1));
    if (upper + lower + 1 != given.size()) {
        throw Error("aerofoil.counts", table.source + " row " + std::to_string(lines[0]),
                    std::to_string(upper) + " + " + std::to_string(lower) + " points",
                    std::to_string(given.size() - 1) + " points follow: the counts must add up");
    }
    const bool one_nose = given(1, 0) == given(upper + 1, 0) && given(1, 1) == given(upper + 1, 1);
    table.cells = Points(2);
    table.line_of_row.clear();
    const auto add = [&](std::size_t row) {
        table.cells.push_back(given[row]);
        table.line_of_row.push_back(lines[row]);
    };
    for (std::size_t row = upper; row >= 1; --row) add(row);
    for (std::size_t row = upper + (one_nose ? 2 : 1); row < given.size(); ++row) add(row);
    table.notes.push_back("Lednicer's order turned into Selig's: tail, upper side, nose, lower side");
}

}  // namespace

bool is_aerofoil(Lines lines, Title title) {
    if (!next_filled(lines)) return false;
    const std::string_view first = trimmed(lines.text());
    if (first[0] == '#' || is_numbers(first, 2) || first == "x y") return false;
    std::vector<std::string_view> words;
    const bool two_words = split(first, separator_of(first), words) && words.size() == 2;
    if (title == Title::not_two_words && two_words) return false;
    return next_filled(lines) && is_numbers(lines.text(), 2);
}

Table read_aerofoil(Lines lines, const std::string& source) {
    next_filled(lines);
    const std::string title = utf8::printable(trimmed(lines.text()));
    Table table = read_rows(lines, source);
    if (table.columns() == 2 && has_counts(table)) join_sides(table);
    if (table.names.empty()) table.names = coordinate_names(table.columns());
    table.notes.insert(table.notes.begin(), "aerofoil: " + title);
    return table;
}

}  // namespace batten::tables
