#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/io/files.hpp"

namespace batten {

/// A cell that holds no finite number, as it was written.
struct BadCell {
    std::size_t row = 0;
    std::string text;
};

/// Columns of numbers, whatever file they came from.
///
/// A cell without a finite number is no trouble until somebody asks for its column: a column of
/// labels may stand beside the numbers.
struct Table {
    std::string source;                       ///< what errors call the file
    std::vector<std::string> names;           ///< one a column, or none
    Points cells;                             ///< rows x columns; bad cells hold 0, or +inf
    std::vector<int> line_of_row;             ///< from 1: where each row stands in its file;
                                              ///< empty where there is none: rows from 0 then
    std::vector<std::optional<BadCell>> bad;  ///< the first one of each column
    /// The first one that is not +inf either; columns beyond its end have none.
    std::vector<std::optional<BadCell>> unusable;
    std::vector<std::string> notes;           ///< what a reader of the result should know

    int columns() const { return cells.dim(); }
    /// The name of a column, or `#k` with k from 1.
    std::string label(int column) const;
    /// Notes that a cell holds no finite number but `x`, or none at all; what `cells` is to hold.
    double mark_bad(std::size_t column, std::optional<double> x, BadCell cell);
};

enum class TableFormat {
    text,       ///< columns by comma, semicolon, tab or blanks
    npy,        ///< NumPy array, versions 1 to 3
    json,       ///< [[x, y], ...]
    aerofoil,   ///< .dat, in the order of Selig or Lednicer
};

/// The format by the suffix of the source's name, and by its content where that tells nothing.
TableFormat table_format(const Source& source);

/// The table in `source`, read as docs/formats.md says. Pure: no file is touched.
///
/// Throws, with the row (line of the file, from 1) where there is one: `file.empty`,
/// `table.ragged`, `table.quote`, `table.encoding`, `table.too-wide`, `table.not-rows`, the `json.`
/// errors of parse_json, `npy.header`, `npy.type`, `npy.shape`, `npy.truncated`,
/// `aerofoil.counts`.
/// Cost: linear.
Table parse_table(const Source& source, TableFormat format);
inline Table parse_table(const Source& source) { return parse_table(source, table_format(source)); }

/// The table in a file (`-` is standard input).
Table read_table(const std::string& path);

/// The column that `pick` means, from 0: a name of the header, or `#k` with k from 1. Throws
/// `table.unknown-column`, or `table.ambiguous-column` where two columns have that name.
int column_index(const Table& table, std::string_view pick);

/// The columns that hold the coordinates: two or three picked by `picks` (`x,y` or `#1,#4,#2`). By
/// default all columns of a table that has two or three, and else those named x, y and, if there
/// is one, z. Throws `table.columns` where this gives none, and what column_index throws.
std::vector<int> coordinate_columns(const Table& table, std::string_view picks = {});

/// The numbers of one column. Throws `points.not-finite`, `number.overflow` or
/// `table.not-a-number` at the first cell without a finite number.
std::vector<double> column_values(const Table& table, int column);

/// The same where +inf means something: errors of samples without weight.
std::vector<double> column_errors(const Table& table, int column);

/// Points whose coordinates stand in these columns. Throws what column_values throws.
Points points_of(const Table& table, const std::vector<int>& columns);

/// The points in a file (`-` is standard input): `read_points("shape.csv")`.
Points read_points(const std::string& path, std::string_view picks = {});

}  // namespace batten
