#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "batten/io/stored_bytes.hpp"
#include "batten/io/table.hpp"

namespace batten {

/// The rows of a table in a file, read in blocks from the first to the last and never held: text
/// columns, or `.npy` in C order.
///
/// Memory: one block, some 8 MB of the file.
class TableStream {
public:
    /// Throws `table.streamed` for a table in another form, `file.empty`, what parse_table throws of
    /// a NumPy header.
    explicit TableStream(StoredBytes bytes);
    ~TableStream();
    TableStream(TableStream&&) noexcept;
    TableStream& operator=(TableStream&&) noexcept;

    const std::string& name() const;
    /// The next rows, with the lines of the file where they stand; nothing behind the last one.
    /// Throws what parse_table throws, `file.unreadable`.
    std::optional<Table> next();
    /// Back to the first row.
    void restart();
    /// How many bytes of the file lie behind, and how many there are.
    std::size_t done() const;
    std::size_t size() const;

    class Blocks;

private:
    std::unique_ptr<Blocks> blocks_;
};

}  // namespace batten
