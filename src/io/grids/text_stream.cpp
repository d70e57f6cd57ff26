#include <algorithm>
#include <limits>
#include <optional>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/grids/grid_cells.hpp"
#include "io/grids/stored_rows.hpp"
#include "io/tables/text_rows.hpp"
#include "io/tables/utf8.hpp"

namespace batten::grids {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 20;

bool holds(StoredBytes& bytes, char c) {
    std::string block(bytes_at_once, '\0');
    for (std::uint64_t offset = 0; offset < bytes.size(); offset += bytes_at_once) {
        block.resize(bytes.read(offset, block));
        if (block.find(c) != std::string::npos) return true;
    }
    return false;
}

/// Where a line lies.
struct StoredLine {
    std::uint64_t start = 0;
    std::size_t size = 0;
    int number = 0;  ///< from 1
};

/// The lines of stored bytes one after the other, whichever of LF, CR LF and CR ends them.
class StoredLines {
public:
    explicit StoredLines(StoredBytes& bytes) : bytes_(bytes) {
        end_ = holds(bytes, '\n') ? '\n' : '\r';
        fill();
        used_ = buffer_.size() - utf8::without_byte_order_mark(buffer_).size();
    }

    /// False after the last one.
    bool next() {
        std::size_t end = buffer_.find(end_, used_);
        while (end == std::string::npos && fill()) end = buffer_.find(end_, searched_);
        if (used_ == buffer_.size()) return false;
        const std::size_t last = std::min(end, buffer_.size());
        text_ = std::string_view(buffer_).substr(used_, last - used_);
        line_ = {offset_ + used_, text_.size(), line_.number + 1};
        used_ = std::min(last + 1, buffer_.size());
        return true;
    }
    const StoredLine& line() const { return line_; }
    std::string_view text() const { return text_; }

private:
    /// Reads on; what has been given away is forgotten.
    bool fill() {
        offset_ += used_;
        buffer_.erase(0, used_);
        used_ = 0;
        searched_ = buffer_.size();
        buffer_.resize(searched_ + bytes_at_once);
        const std::size_t count = bytes_.read(offset_ + searched_,
                                              {buffer_.data() + searched_, bytes_at_once});
        buffer_.resize(searched_ + count);
        return count > 0;
    }

    StoredBytes& bytes_;
    std::string buffer_;
    std::string_view text_;
    std::uint64_t offset_ = 0;  ///< of the buffer
    std::size_t used_ = 0, searched_ = 0;
    char end_ = '\n';
    StoredLine line_;
};

std::string_view without_return(std::string_view line) {
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

class TextRows : public StoredRows {
public:
    explicit TextRows(StoredBytes stored) : StoredRows(std::move(stored)) {
        StoredLines lines(bytes);
        while (lines.next()) {
            const std::string_view line = without_return(lines.text());
            if (trimmed(line).empty() || trimmed(line)[0] == '#') continue;
            if (!has_first_) take_first(line, lines.line().number);
            else take_row(line, lines.line());
        }
        if (!has_first_) {
            throw Error("file.empty", bytes.name(), "no rows", "the file must hold a grid");
        }
        turn();
    }

    void read(std::size_t first, std::span<double> z) override {
        const std::size_t width = y.size();
        for (std::size_t r = 0; r < z.size() / width; ++r) {
            const StoredLine& line = lines_[first + r];
            text_.resize(line.size);
            bytes.read(line.start, text_);
            split(without_return(text_), line.number);
            require_width(cells_.size(), width + 1, bytes.name(), line.number);
            for (std::size_t j = 0; j < width; ++j) {
                const CellPlace place{bytes.name(), line.number, y_order_[j] + 1};
                const std::optional<double> value = height(cells_[place.column], place);
                z[r * width + j] = value.value_or(std::numeric_limits<double>::quiet_NaN());
            }
        }
    }

private:
    void split(std::string_view line, int number) {
        if (tables::split(line, separator_, cells_)) return;
        throw Error("table.quote", bytes.name() + " row " + std::to_string(number),
                    utf8::shown(trimmed(line)),
                    "a quoted cell must end on its line, before the next separator");
    }

    void take_first(std::string_view line, int number) {
        has_first_ = true;
        separator_ = tables::separator_of(line);
        split(line, number);
        if (is_long_form({cells_.begin(), cells_.end()})) {
            throw not_streamed(bytes.name(), "rows x,y,f");
        }
        for (std::size_t j = 1; j < cells_.size(); ++j) {
            y.push_back(axis_number(cells_[j], {bytes.name(), number, j}));
        }
    }

    /// Its x only; the heights are looked at when they are read.
    void take_row(std::string_view line, const StoredLine& stored) {
        const std::size_t start = line.find_first_not_of(" \t");
        const bool is_quoted = line[start] == '"';
        split(is_quoted ? line : line.substr(0, line.find(separator_, start)), stored.number);
        x.push_back(axis_number(cells_.front(), {bytes.name(), stored.number, 0}));
        lines_.push_back(stored);
    }

    void turn() {
        const std::vector<std::size_t> order = rising(x, bytes.name(), "x");
        y_order_ = rising(y, bytes.name(), "y");
        x_is_turned = is_turned(order);
        y_is_turned = is_turned(y_order_);
        const auto turned = [](const auto& from, const std::vector<std::size_t>& by) {
            auto result = from;
            for (std::size_t i = 0; i < by.size(); ++i) result[i] = from[by[i]];
            return result;
        };
        x = turned(x, order);
        lines_ = turned(lines_, order);
        y = turned(y, y_order_);
    }

    std::vector<StoredLine> lines_;  ///< of the rows, x rising
    std::vector<std::size_t> y_order_;
    std::vector<std::string_view> cells_;
    std::string text_;
    char separator_ = ',';
    bool has_first_ = false;
};

}  // namespace

std::unique_ptr<StoredRows> text_rows(StoredBytes bytes) {
    return std::make_unique<TextRows>(std::move(bytes));
}

}  // namespace batten::grids
