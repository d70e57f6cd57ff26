#include "batten/io/stored_bytes.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "batten/base/error.hpp"

namespace batten {

StoredBytes::StoredBytes(const std::string& path) : source_{path, {}}, size_(0) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw Error("file.missing", path.empty() ? "''" : path, "no such file",
                    "the input file must exist");
    }
    if (fs::is_directory(status)) {
        throw Error("file.directory", path, "a folder", "the input must be a file");
    }
    file_ = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!fs::is_regular_file(status) || !*file_) {
        throw Error("file.unreadable", path,
                    fs::is_regular_file(status) ? "cannot be opened" : "no regular file",
                    "the file must be readable, more than once");
    }
    size_ = fs::file_size(path, error);
}

StoredBytes::StoredBytes(Source source) : source_(std::move(source)), size_(source_.bytes.size()) {}

std::size_t StoredBytes::read(std::uint64_t offset, std::span<char> out) {
    if (offset >= size_) return 0;
    const std::size_t count =
        static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), size_ - offset));
    if (!file_) {
        std::memcpy(out.data(), source_.bytes.data() + offset, count);
        return count;
    }
    file_->clear();
    file_->seekg(static_cast<std::streamoff>(offset));
    file_->read(out.data(), static_cast<std::streamsize>(count));
    if (file_->bad() || static_cast<std::size_t>(file_->gcount()) != count) {
        throw Error("file.unreadable", name(), "fewer bytes than before",
                    "the file must stay as it is while it is read");
    }
    return count;
}

Source StoredBytes::head(const char* rule) {
    constexpr std::size_t first_bytes = 512;
    Source first{name(), std::string(first_bytes, '\0')};
    first.bytes.resize(read(0, first.bytes));
    if (first.bytes.empty()) throw Error("file.empty", name(), "no bytes", rule);
    return first;
}

}  // namespace batten
