#include "io/tables/text_rows.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/tables/utf8.hpp"

namespace batten::tables {
namespace {

bool is_comment(std::string_view line) {
    const std::string_view text = trimmed(line);
    return !text.empty() && text[0] == '#';
}

/// The line without a remark at its end: a `#` after a blank, outside quotes.
std::string_view without_remark(std::string_view line) {
    if (line.find('#') == std::string_view::npos) return line;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') quoted = !quoted;
        const bool after_blank = i > 0 && (line[i - 1] == ' ' || line[i - 1] == '\t');
        if (line[i] == '#' && after_blank && !quoted) return line.substr(0, i);
    }
    return line;
}

bool is_number(std::string_view cell) { return parse_number(cell).has_value(); }

/// Names of columns: at least one word, and no number. What looks like a number is no word.
bool is_header(const std::vector<std::string_view>& cells) {
    const auto is_word = [](std::string_view cell) {
        return cell.find_first_not_of("0123456789+-.,") != std::string_view::npos;
    };
    return std::any_of(cells.begin(), cells.end(), is_word) &&
           std::none_of(cells.begin(), cells.end(), is_number);
}

std::vector<std::string> texts(const std::vector<std::string_view>& cells) {
    std::vector<std::string> result;
    for (const std::string_view cell : cells) result.push_back(cell_text(cell));
    return result;
}

class RowReader {
public:
    RowReader(const std::string& source, const Lines& lines)
        : expected_rows_(lines.estimate()), most_cells_(lines.left() / 2) {
        table_.source = source;
    }

    void add(std::string_view line, int number) {
        if (is_comment(line)) {
            if (rows_ == 0 && comment_.empty() && table_.names.empty()) {
                comment_ = trimmed(trimmed(line).substr(1));
            }
            return;
        }
        line = without_remark(line);
        if (trimmed(line).empty()) return;
        if (columns_ == 0) separator_ = separator_of(line);
        if (!split(line, separator_, cells_)) {
            throw Error("table.quote", place(number), utf8::shown(trimmed(line)),
                        "a quoted cell must end on its line, before the next separator");
        }
        if (columns_ == 0) {
            start(number);
            if (is_header(cells_)) {
                table_.names = texts(cells_);
                return;
            }
        }
        if (cells_.size() != static_cast<std::size_t>(columns_)) throw ragged(number);
        add_row(number);
    }

    Table finish() {
        if (rows_ == 0) throw no_rows(table_.source);
        table_.cells = Points(std::move(values_), columns_);
        if (table_.names.empty()) name_by_comment();
        return std::move(table_);
    }

private:
    void start(int number) {
        if (cells_.size() > most_columns) {
            throw Error("table.too-wide", place(number), std::to_string(cells_.size()) + " columns",
                        "at most " + std::to_string(most_columns) + " columns are read");
        }
        columns_ = static_cast<int>(cells_.size());
        first_line_ = number;
        table_.bad.resize(cells_.size());
        values_.reserve(std::min(expected_rows_ * cells_.size(), most_cells_));
        table_.line_of_row.reserve(expected_rows_);
    }

    void add_row(int number) {
        table_.line_of_row.push_back(number);
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            const std::optional<double> x = parse_number(cells_[k]);
            const bool is_good = x && std::isfinite(*x);
            const bool is_infinite = x && !is_good && *x > 0 &&
                                     cells_[k].find_first_of("0123456789") == std::string_view::npos;
            values_.push_back(is_good || is_infinite ? *x : 0);
            if (!is_good) note_bad(table_.bad[k], {rows_, cell_text(cells_[k]), is_infinite});
        }
        ++rows_;
    }

    /// The comment at the top serves as header where it has one name a column, however separated.
    void name_by_comment() {
        for (const char separator : {separator_of(comment_), separator_, ' '}) {
            if (split(comment_, separator, cells_) && is_header(cells_) &&
                cells_.size() == static_cast<std::size_t>(columns_)) {
                table_.names = texts(cells_);
                return;
            }
        }
    }

    std::string place(int number) const {
        return table_.source + " row " + std::to_string(number);
    }
    Error ragged(int number) const {
        return {"table.ragged", place(number), std::to_string(cells_.size()) + " columns",
                "every row must have " + std::to_string(columns_) + " columns, like row " +
                    std::to_string(first_line_)};
    }

    Table table_;
    std::vector<double> values_;
    std::vector<std::string_view> cells_;
    std::string_view comment_;
    std::size_t expected_rows_, most_cells_;
    std::size_t rows_ = 0;
    int columns_ = 0;
    int first_line_ = 0;
    char separator_ = ',';
};

}  // namespace

Table read_rows(Lines lines, const std::string& source) {
    RowReader reader(source, lines);
    while (lines.next()) {
        if (lines.text().find('\0') != std::string_view::npos) {
            throw Error("table.encoding", source + " row " + std::to_string(lines.number()),
                        "byte 0x00", "a table in text form must be UTF-8 or ASCII");
        }
        reader.add(lines.text(), lines.number());
    }
    return reader.finish();
}

}  // namespace batten::tables
