#include "batten/io/table_stream.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "io/tables/npy_grid.hpp"

namespace batten {

/// The rows of one form of table, where they lie.
class TableStream::Blocks {
public:
    explicit Blocks(StoredBytes stored) : bytes(std::move(stored)) {}
    virtual ~Blocks() = default;
    virtual std::optional<Table> next() = 0;
    virtual void restart() = 0;

    StoredBytes bytes;
    std::uint64_t at = 0;  ///< what lies before is read
};

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 23;

int line_number(std::uint64_t line) {
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min(line, most));
}

/// `error`, its row counted from the start of the file.
Error shifted(const Error& error, const std::string& source, std::uint64_t shift) {
    const std::string before = source + " row ";
    if (!error.place().starts_with(before)) return error;
    const std::string place = error.place().substr(before.size());
    const std::size_t end = std::min(place.find_first_not_of("0123456789"), place.size());
    const std::optional<long long> row = parse_integer(place.substr(0, end));
    if (!row) return error;
    return error.at(before + std::to_string(static_cast<std::uint64_t>(*row) + shift) +
                    place.substr(end));
}

class NpyBlocks : public TableStream::Blocks {
public:
    explicit NpyBlocks(StoredBytes stored) : Blocks(std::move(stored)) {
        header_ = tables::stored_npy_grid(bytes);
        if (header_.is_fortran) {
            throw Error("table.streamed", bytes.name(), "an array in Fortran order",
                        "read in blocks are text columns and .npy in C order");
        }
        at = header_.end;
    }

    void restart() override {
        at = header_.end;
        row_ = 0;
    }

    std::optional<Table> next() override {
        const std::size_t columns = header_.shape[1];
        const std::size_t width = columns * header_.width;
        const std::size_t count =
            std::min(header_.shape[0] - row_, std::max<std::size_t>(1, block_bytes / width));
        if (count == 0) return std::nullopt;
        raw_.resize(count * width);
        bytes.read(at, raw_);
        Table table;
        table.source = bytes.name();
        table.bad.resize(columns);
        table.cells = Points(count, static_cast<int>(columns));
        const std::span<double> cells = table.cells.coordinates();
        tables::npy_numbers(header_, raw_.data(), cells);
        for (std::size_t i = 0; i < count; ++i) {
            table.line_of_row.push_back(line_number(row_ + i + 1));
            for (std::size_t k = 0; k < columns; ++k) {
                double& x = cells[i * columns + k];
                if (!std::isfinite(x)) x = table.mark_bad(k, x, {i, format_number(x)});
            }
        }
        row_ += count;
        at += raw_.size();
        return table;
    }

private:
    tables::NpyHeader header_;
    std::size_t row_ = 0;
    std::vector<char> raw_;
};

/// Blocks end at the ends of lines; each is read behind the lines above the first row, which name
/// the columns.
class TextBlocks : public TableStream::Blocks {
public:
    using Blocks::Blocks;

    void restart() override {
        at = lines_ = 0;
        rest_.clear();
    }

    std::optional<Table> next() override {
        while (true) {
            const std::string lines = whole_lines();
            if (lines.empty()) return std::nullopt;
            const std::uint64_t before = lines_;
            lines_ += static_cast<std::uint64_t>(std::count(lines.begin(), lines.end(), '\n'));
            if (before == 0) return first_block(lines);
            if (has_rows(lines)) return block(lines, before);
        }
    }

private:
    /// The next lines, the last of the file also without an end; empty where there are none.
    std::string whole_lines() {
        std::string text = std::exchange(rest_, {});
        while (true) {
            const std::size_t old = text.size();
            text.resize(old + block_bytes);
            const std::size_t count = bytes.read(at, std::span(text).subspan(old));
            text.resize(old + count);
            at += count;
            if (count == 0) return text;
            const std::size_t end = text.rfind('\n');
            if (end == std::string::npos) continue;
            rest_ = text.substr(end + 1);
            text.resize(end + 1);
            return text;
        }
    }

    static bool has_rows(std::string_view lines) {
        while (!lines.empty()) {
            const std::size_t end = std::min(lines.find('\n'), lines.size() - 1);
            const std::string_view line = trimmed(lines.substr(0, end + 1));
            if (!line.empty() && line[0] != '#') return true;
            lines.remove_prefix(end + 1);
        }
        return false;
    }

    Table first_block(const std::string& lines) {
        Table table = parse_table({bytes.name(), lines}, TableFormat::text);
        std::size_t end = 0;
        head_lines_ = table.line_of_row.empty() ? 0 : table.line_of_row.front() - 1;
        for (int k = 0; k < head_lines_; ++k) end = lines.find('\n', end) + 1;
        head_ = lines.substr(0, end);
        return table;
    }

    Table block(const std::string& lines, std::uint64_t before) const {
        const std::uint64_t shift = before - static_cast<std::uint64_t>(head_lines_);
        Table table = parsed(lines, shift);
        table.notes.clear();
        for (int& line : table.line_of_row) {
            line = line_number(static_cast<std::uint64_t>(line) + shift);
        }
        return table;
    }

    Table parsed(const std::string& lines, std::uint64_t shift) const {
        try {
            return parse_table({bytes.name(), head_ + lines}, TableFormat::text);
        } catch (const Error& error) {
            throw shifted(error, bytes.name(), shift);
        }
    }

    std::string rest_, head_;
    int head_lines_ = 0;
    std::uint64_t lines_ = 0;
};

std::unique_ptr<TableStream::Blocks> blocks_of(StoredBytes bytes) {
    switch (table_format(bytes.head("the file must hold a table"))) {
        case TableFormat::npy: return std::make_unique<NpyBlocks>(std::move(bytes));
        case TableFormat::text: return std::make_unique<TextBlocks>(std::move(bytes));
        default: break;
    }
    throw Error("table.streamed", bytes.name(), "another form",
                "read in blocks are text columns and .npy in C order");
}

}  // namespace

TableStream::TableStream(StoredBytes bytes) : blocks_(blocks_of(std::move(bytes))) {}
TableStream::~TableStream() = default;
TableStream::TableStream(TableStream&&) noexcept = default;
TableStream& TableStream::operator=(TableStream&&) noexcept = default;

const std::string& TableStream::name() const { return blocks_->bytes.name(); }
std::optional<Table> TableStream::next() { return blocks_->next(); }
void TableStream::restart() { blocks_->restart(); }
std::size_t TableStream::done() const { return static_cast<std::size_t>(blocks_->at); }
std::size_t TableStream::size() const { return static_cast<std::size_t>(blocks_->bytes.size()); }

}  // namespace batten
