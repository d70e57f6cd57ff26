#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "batten/io/files.hpp"

namespace batten {

/// Bytes that stay where they are and are read piece by piece: those of a file of any size, or of a
/// source in memory.
class StoredBytes {
public:
    /// Throws `file.missing`, `file.directory`, or `file.unreadable`, which no file that can be
    /// read again from its start gives (a pipe is none).
    explicit StoredBytes(const std::string& path);
    explicit StoredBytes(Source source);

    /// What errors call them.
    const std::string& name() const { return source_.name; }
    std::uint64_t size() const { return size_; }

    /// Copies the bytes from `offset` on into `out`; how many there were. Throws `file.unreadable`.
    std::size_t read(std::uint64_t offset, std::span<char> out);
    /// The first bytes under the same name, by which forms are told apart. Throws `file.empty` with
    /// `rule` where there are none, and what read() throws.
    Source head(const char* rule);

private:
    Source source_;                        ///< without bytes where there is a file
    std::unique_ptr<std::ifstream> file_;
    std::uint64_t size_;
};

}  // namespace batten
