#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/io/table.hpp"

namespace batten::tables {

/// Most columns of one table.
constexpr std::size_t most_columns = 65'536;

/// The lines of a text, whichever of LF, CR LF and CR ends them; a byte order mark is skipped.
class Lines {
public:
    explicit Lines(std::string_view text);

    /// Steps to the next line; false after the last one.
    bool next();
    std::string_view text() const { return line_; }
    /// From 1.
    int number() const { return number_; }
    /// How many bytes are left.
    std::size_t left() const { return rest_.size(); }
    /// About how many lines are left, judged by the next ones.
    std::size_t estimate() const;

private:
    std::string_view rest_, line_;
    char end_;
    int number_ = 0;
};

/// The character between the cells of this line: `;`, tab, `,`, or a blank for any run of blanks.
char separator_of(std::string_view line);

/// The cells of a line without the blanks and quotes around them; false where a quote does not
/// close, or is not followed by a separator.
bool split(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// A cell as text: two quotes inside quotes are one.
std::string cell_text(std::string_view cell);

/// Columns of numbers in text form, from the next line on.
Table read_rows(Lines lines, const std::string& source);

/// An aerofoil: a title line, then the points.
Table read_aerofoil(Lines lines, const std::string& source);

/// Which first lines are titles: two words could also be the header of two columns.
enum class Title { any, not_two_words };

/// Whether the text is a title line and rows of two numbers between blanks.
bool is_aerofoil(Lines lines, Title title);

Table read_json(std::string_view bytes, const std::string& source);
Table read_npy(std::string_view bytes, const std::string& source);

/// The error `file.empty`.
Error no_rows(const std::string& source);

}  // namespace batten::tables
