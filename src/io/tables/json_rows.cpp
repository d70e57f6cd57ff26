#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/json.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::tables {
namespace {

Error not_rows(const std::string& place, const Value& found) {
    const char* kind = found.map()     ? "a map"
                       : found.list()  ? "an empty list"
                       : found.text()  ? "a text"
                       : found.is_null() ? "null"
                                         : "a single value";
    return {"table.not-rows", place, kind, "points are a list of lists of numbers: [[x, y], ...]"};
}

}  // namespace

Table read_json(std::string_view bytes, const std::string& source) {
    const Value tree = parse_json(bytes, source);
    const ValueList* rows = tree.list();
    if (!rows) throw not_rows(source, tree);
    if (rows->empty()) throw no_rows(source);
    Table table;
    table.source = source;
    std::vector<double> values;
    std::size_t columns = 0;
    for (const Value& entry : *rows) {
        table.line_of_row.push_back(static_cast<int>(table.line_of_row.size()) + 1);
        const std::string place = source + " row " + std::to_string(table.line_of_row.back());
        const ValueList* row = entry.list();
        if (!row || row->empty()) throw not_rows(place, entry);
        if (columns == 0) {
            columns = row->size();
            table.bad.resize(columns);
        }
        if (row->size() != columns) {
            throw Error("table.ragged", place, std::to_string(row->size()) + " columns",
                        "every row must have " + std::to_string(columns) + " columns, like row 1");
        }
        for (std::size_t k = 0; k < columns; ++k) {
            const Value& cell = (*row)[k];
            values.push_back(cell.is_number()
                                 ? cell.number()
                                 : table.mark_bad(k, std::nullopt,
                                                  {table.line_of_row.size() - 1,
                                                   dump_json(cell, JsonStyle::one_line)}));
        }
    }
    table.cells = Points(std::move(values), static_cast<int>(columns));
    return table;
}

}  // namespace batten::tables
