#pragma once

#include <cstddef>
#include <string>
#include <string_view>

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

/// Writes a file that appears whole or not at all: a draft in the same folder takes the place of
/// `path` once everything is in it. The permissions of a file that is replaced stay; a link is
/// followed; a device or a pipe is written to as it is.
///
/// Throws `file.unwritable`, which names the folder; then nothing has changed.
void write_file(const std::string& path, std::string_view bytes);

/// What follows the last dot of the file's name, in lower case: `csv` of `out/Points.CSV`. Empty
/// where there is no dot.
std::string suffix_of(std::string_view path);

}  // namespace batten
