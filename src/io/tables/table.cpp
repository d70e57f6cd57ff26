#include "batten/io/table.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten {
namespace {

constexpr std::string_view npy_magic = "\x93NUMPY";

/// Every way to name a column of the table, for the rule of an error.
std::string choices(const Table& table) {
    const std::string last = '#' + std::to_string(table.columns());
    if (table.names.empty()) return "the file has no header: #1 to " + last;
    std::string text = "the columns are";
    constexpr std::size_t most_shown = 20;
    for (std::size_t k = 0; k < std::min(table.names.size(), most_shown); ++k) {
        text += (k > 0 ? ", " : " ") + table.label(static_cast<int>(k));
    }
    return text + (table.names.size() > most_shown ? ", ... " : "") + " (or #1 to " + last + ")";
}

std::optional<int> named_column(const Table& table, std::string_view name) {
    const auto found = std::find(table.names.begin(), table.names.end(), name);
    if (found == table.names.end()) return std::nullopt;
    if (std::find(found + 1, table.names.end(), name) != table.names.end()) {
        throw Error("table.ambiguous-column", table.source, std::string(name),
                    "two columns have this name: pick by #k");
    }
    return static_cast<int>(found - table.names.begin());
}

/// Why a cell holds no finite number.
Error bad_cell(const Table& table, int column, const BadCell& bad) {
    const bool is_from_file = !table.line_of_row.empty();
    const std::string row = is_from_file ? std::to_string(table.line_of_row[bad.row])
                                         : std::to_string(bad.row);
    const std::string place = table.source + " row " + row + ", column " + table.label(column);
    const std::string text = bad.text.empty() ? "an empty cell" : utf8::shown(bad.text);
    const std::optional<double> x = parse_number(bad.text);
    if (!x) {
        const bool has_comma = bad.text.find(',') != std::string::npos;
        return {"table.not-a-number", place, text,
                has_comma ? "a number is needed here, with a decimal point"
                          : "a number is needed here",
                {bad.row}};
    }
    const bool has_digits = bad.text.find_first_of("0123456789") != std::string::npos;
    if (std::isinf(*x) && has_digits) {
        return {"number.overflow", place, text, "numbers must lie within the range of a double",
                {bad.row}};
    }
    return {"points.not-finite", place, format_number(*x), "coordinates must be finite",
            {bad.row}};
}

void require_good(const Table& table, int column) {
    const std::optional<BadCell>& bad = table.bad[static_cast<std::size_t>(column)];
    if (bad) throw bad_cell(table, column, *bad);
}

std::vector<double> column_of(const Table& table, int column) {
    std::vector<double> values(table.cells.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = table.cells(i, column);
    return values;
}

}  // namespace

std::string Table::label(int column) const {
    const std::size_t k = static_cast<std::size_t>(column);
    if (k < names.size() && !names[k].empty()) return utf8::printable(names[k]);
    return '#' + std::to_string(column + 1);
}

double Table::mark_bad(std::size_t column, std::optional<double> x, BadCell cell) {
    const bool has_digits = cell.text.find_first_of("0123456789") != std::string::npos;
    const bool is_infinite = x && *x > 0 && std::isinf(*x) && !has_digits;
    if (!bad[column]) bad[column] = cell;
    unusable.resize(bad.size());
    if (!is_infinite && !unusable[column]) unusable[column] = std::move(cell);
    return is_infinite ? *x : 0;
}

TableFormat table_format(const Source& source) {
    const std::string suffix = suffix_of(source.name);
    const tables::Lines lines(source.bytes);
    if (suffix == "npy") return TableFormat::npy;
    if (suffix == "json") return TableFormat::json;
    if (suffix == "csv" || suffix == "tsv" || suffix == "txt") return TableFormat::text;
    if (suffix == "dat") {
        return is_aerofoil(lines, tables::Title::any) ? TableFormat::aerofoil : TableFormat::text;
    }
    const std::string_view bytes = source.bytes;
    if (bytes.substr(0, npy_magic.size()) == npy_magic) return TableFormat::npy;
    const std::string_view text = trimmed(utf8::without_byte_order_mark(bytes));
    if (!text.empty() && (text[0] == '[' || text[0] == '{')) return TableFormat::json;
    return is_aerofoil(lines, tables::Title::not_two_words) ? TableFormat::aerofoil
                                                            : TableFormat::text;
}

Table parse_table(const Source& source, TableFormat format) {
    if (trimmed(source.bytes).empty()) throw tables::no_rows(source.name);
    switch (format) {
        case TableFormat::npy: return tables::read_npy(source.bytes, source.name);
        case TableFormat::json: return tables::read_json(source.bytes, source.name);
        case TableFormat::aerofoil:
            return tables::read_aerofoil(tables::Lines(source.bytes), source.name);
        case TableFormat::text: break;
    }
    return tables::read_rows(tables::Lines(source.bytes), source.name);
}

Table read_table(const std::string& path) { return parse_table(read_source(path)); }

int column_index(const Table& table, std::string_view pick) {
    pick = trimmed(pick);
    if (const std::optional<int> named = named_column(table, pick)) return *named;
    if (!pick.empty() && pick[0] == '#') {
        const std::optional<long long> k = parse_integer(pick.substr(1));
        if (k && *k >= 1 && *k <= table.columns()) return static_cast<int>(*k - 1);
    }
    throw Error("table.unknown-column", table.source, utf8::shown(pick),
                choices(table));
}

std::vector<int> coordinate_columns(const Table& table, std::string_view picks) {
    std::vector<int> columns;
    if (!trimmed(picks).empty()) {
        std::vector<std::string_view> names;
        tables::split(picks, ',', names);
        for (const std::string_view name : names) columns.push_back(column_index(table, name));
    } else if (table.columns() == 2 || table.columns() == 3) {
        for (int k = 0; k < table.columns(); ++k) columns.push_back(k);
    } else {
        for (const char* name : {"x", "y", "z"}) {
            if (const std::optional<int> named = named_column(table, name)) {
                columns.push_back(*named);
            }
        }
    }
    if (columns.size() == 2 || columns.size() == 3) return columns;
    const bool none_picked = trimmed(picks).empty();
    throw Error("table.columns", table.source,
                none_picked ? std::to_string(table.columns()) + " columns" : utf8::shown(picks),
                "pick two or three columns as coordinates; " + choices(table));
}

std::vector<double> column_values(const Table& table, int column) {
    require_good(table, column);
    return column_of(table, column);
}

std::vector<double> column_errors(const Table& table, int column) {
    const std::size_t k = static_cast<std::size_t>(column);
    if (k < table.unusable.size() && table.unusable[k]) {
        const Error error = bad_cell(table, column, *table.unusable[k]);
        if (error.code() != "points.not-finite") throw error;
        throw Error(error.code(), error.place(), error.value(),
                    "errors must be numbers above 0 (inf: no weight)", error.rows());
    }
    return column_of(table, column);
}

Points points_of(const Table& table, const std::vector<int>& columns) {
    for (const int column : columns) require_good(table, column);
    Points points(table.cells.size(), static_cast<int>(columns.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < columns.size(); ++k) {
            points(i, static_cast<int>(k)) = table.cells(i, columns[k]);
        }
    }
    return points;
}

Points read_points(const std::string& path, std::string_view picks) {
    Table table = read_table(path);
    const std::vector<int> columns = coordinate_columns(table, picks);
    if (columns.size() != static_cast<std::size_t>(table.columns()) ||
        !std::is_sorted(columns.begin(), columns.end())) {
        return points_of(table, columns);
    }
    for (const int column : columns) require_good(table, column);
    return std::move(table.cells);
}

Error tables::no_rows(const std::string& source) {
    return {"file.empty", source, "no rows", "the file must hold rows of numbers"};
}

}  // namespace batten
