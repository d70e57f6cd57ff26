#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace batten {

/// Bytes, and the name that errors call them by. Everything that reads text or numbers takes a
/// `Source`, so that nothing else opens a file.
struct Source {
    std::string name;
    std::string bytes;
};

/// The most that is read from one file.
inline constexpr std::size_t most_bytes = std::size_t{1} << 30;

/// All bytes of the file at `path`, or of standard input where `path` is `-`.
///
/// Throws `file.missing`, `file.directory`, `file.unreadable`, or `file.too-large` beyond
/// `most_bytes`.
Source read_source(const std::string& path);

/// A file to be: where, and all that is in it.
struct FileToWrite {
    std::string path;
    std::string bytes;
};

/// Writes files that appear whole or not at all: a draft in the same folder takes the place of each
/// path once everything is in all of them. The permissions of a file that is replaced stay; a link
/// is followed; a device or a pipe is written to as it is, before any file changes.
///
/// Throws `file.unwritable`, which names the folder; then no file has changed.
void write_files(std::span<const FileToWrite> files);
inline void write_file(const std::string& path, std::string bytes) {
    const FileToWrite file{path, std::move(bytes)};
    write_files({&file, 1});
}

/// Throws what write_files would throw of this path, as far as can be told before: asked before
/// long work, whose result would be lost. Nothing stays changed.
void require_writable(const std::string& path);

/// What follows the last dot of the file's name, in lower case: `csv` of `out/Points.CSV`. Empty
/// where there is no dot.
std::string suffix_of(std::string_view path);

}  // namespace batten
