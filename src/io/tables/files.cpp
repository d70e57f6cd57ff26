#include "batten/io/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "batten/base/error.hpp"

namespace batten {
namespace {

namespace fs = std::filesystem;

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File open(const fs::path& path, const char* mode) {
    return File(std::fopen(path.string().c_str(), mode));
}

/// Why the last call failed, in words that are the same on every system.
std::string reason(int error) {
    switch (error) {
        case EACCES:
        case EPERM: return "no permission";
        case EROFS: return "the file system is read-only";
        case ENOENT: return "no such folder";
        case ENOTDIR: return "not a folder";
        case ENOSPC: return "no space left";
        case EISDIR: return "a folder";
        case ENAMETOOLONG: return "the name is too long";
        default: return "system error " + std::to_string(error);
    }
}

std::string shown(const std::string& path) { return path.empty() ? "''" : path; }

Error too_large(const std::string& name) {
    return {"file.too-large", name, "more than " + std::to_string(most_bytes) + " bytes",
            "at most " + std::to_string(most_bytes) + " bytes are read"};
}

/// All that is in `file`, of which about `expected` bytes are.
std::string read_all(std::FILE* file, const std::string& name, std::uintmax_t expected) {
    constexpr std::size_t step = 1 << 16;
    std::string bytes;
    std::size_t used = 0;
    bytes.resize(static_cast<std::size_t>(expected) + step);
    while (true) {
        const std::size_t count = std::fread(bytes.data() + used, 1, bytes.size() - used, file);
        used += count;
        if (used > most_bytes) throw too_large(name);
        if (used < bytes.size()) break;
        bytes.resize(2 * used);
    }
    if (std::ferror(file)) {
        throw Error("file.unreadable", name, reason(errno), "the file must be readable");
    }
    bytes.resize(used);
    return bytes;
}

Error unwritable(const std::string& path, const std::string& why) {
    const std::string folder = fs::path(path).parent_path().string();
    return {"file.unwritable", shown(path), why,
            "the folder " + (folder.empty() ? "." : folder) + " must exist and allow writing"};
}

/// Whether all bytes have arrived in `file`, which is closed.
bool write_all(File file, std::string_view bytes) {
    const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    return std::fclose(file.release()) == 0 && whole;
}

/// A new file beside the one to be written; it goes away unless it takes that one's place.
class Draft {
public:
    explicit Draft(const fs::path& target) : target_(target) {
        // Exclusive creation finds a free name whoever else is writing here.
        for (int i = 0; !file_ && (i == 0 || (errno == EEXIST && i < 10'000)); ++i) {
            path_ = target.parent_path() / (".batten-" + std::to_string(i) + ".part");
            file_ = open(path_, "wbx");
        }
        exists_ = file_ != nullptr;
    }
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;
    ~Draft() {
        file_.reset();
        std::error_code ignored;
        if (exists_) fs::remove(path_, ignored);
    }

    /// Writes the bytes and takes the target's place; false, with errno, where this cannot be.
    bool replace_by(std::string_view bytes) {
        if (!file_ || !write_all(std::move(file_), bytes)) return false;
        std::error_code error;
        const fs::file_status old = fs::status(target_, error);
        if (fs::exists(old)) fs::permissions(path_, old.permissions(), error);
        fs::rename(path_, target_, error);
        errno = error.value();
        exists_ = static_cast<bool>(error);
        return !exists_;
    }

private:
    fs::path target_, path_;
    File file_;
    bool exists_ = false;
};

}  // namespace

Source read_source(const std::string& path) {
    if (path == "-") return {"standard input", read_all(stdin, "standard input", 0)};
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status) && (!error || error.value() == ENOENT || error.value() == ENOTDIR)) {
        throw Error("file.missing", shown(path), "no such file", "the input file must exist");
    }
    if (fs::is_directory(status)) {
        throw Error("file.directory", path, "a folder", "the input must be a file");
    }
    const File file = open(path, "rb");
    if (!file) throw Error("file.unreadable", path, reason(errno), "the file must be readable");
    std::uintmax_t size = fs::is_regular_file(status) ? fs::file_size(path, error) : 0;
    if (error) size = 0;
    if (size > most_bytes) throw too_large(path);
    return {path, read_all(file.get(), path, size)};
}

void write_file(const std::string& path, std::string_view bytes) {
    std::error_code error;
    const fs::path followed = fs::canonical(path, error);
    const fs::path target = error ? fs::path(path) : followed;
    const fs::file_status status = fs::status(target, error);
    if (path.empty()) throw unwritable(path, "no name");
    if (fs::is_directory(status)) throw unwritable(path, "a folder");
    if (fs::exists(status)) {
        // Opening tells whether an existing file may be changed, which renaming over it would not.
        const bool is_file = fs::is_regular_file(status);
        File existing = open(target, is_file ? "r+b" : "wb");
        if (!existing) throw unwritable(path, reason(errno));
        if (!is_file) {
            if (!write_all(std::move(existing), bytes)) throw unwritable(path, reason(errno));
            return;
        }
    }
    if (!Draft(target).replace_by(bytes)) throw unwritable(path, reason(errno));
}

std::string suffix_of(std::string_view path) {
    const std::string_view name = path.substr(path.find_last_of("/\\") + 1);
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return {};
    std::string suffix(name.substr(dot + 1));
    for (char& c : suffix) {
        if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return suffix;
}

}  // namespace batten
