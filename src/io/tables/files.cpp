#include "batten/io/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

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
    explicit Draft(fs::path target) : target_(std::move(target)) {
        // Exclusive creation finds a free name whoever else is writing here.
        for (int i = 0; !file_ && (i == 0 || (errno == EEXIST && i < 10'000)); ++i) {
            path_ = target_.parent_path() / (".batten-" + std::to_string(i) + ".part");
            file_ = open(path_, "wbx");
        }
        exists_ = file_ != nullptr;
    }
    Draft(Draft&& other) noexcept
        : target_(std::move(other.target_)), path_(std::move(other.path_)),
          file_(std::move(other.file_)), exists_(std::exchange(other.exists_, false)) {}
    Draft& operator=(Draft&&) = delete;
    ~Draft() {
        file_.reset();
        std::error_code ignored;
        if (exists_) fs::remove(path_, ignored);
    }

    bool is_open() const { return file_ != nullptr; }
    /// Whether all bytes have arrived; errno tells why not.
    bool fill(std::string_view bytes) { return file_ && write_all(std::move(file_), bytes); }
    /// Takes the target's place; false, with errno, where this cannot be.
    bool replace_target() {
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

/// Where the bytes for a path go: links are followed.
struct Target {
    fs::path path;
    bool is_device = false;  ///< or a pipe: written to as it is
};

/// Throws where the path can be no file or may not be changed.
Target target_of(const std::string& path) {
    if (path.empty()) throw unwritable(path, "no name");
    std::error_code error;
    const fs::path followed = fs::canonical(path, error);
    const Target target{error ? fs::path(path) : followed, false};
    const fs::file_status status = fs::status(target.path, error);
    if (fs::is_directory(status)) throw unwritable(path, "a folder");
    if (!fs::exists(status)) return target;
    const bool is_device = !fs::is_regular_file(status);
    // Opening tells whether an existing file may be changed, which renaming over it would not.
    if (!is_device && !open(target.path, "r+b")) throw unwritable(path, reason(errno));
    return {target.path, is_device};
}

void write_device(const FileToWrite& file, const Target& target) {
    File device = open(target.path, "wb");
    if (!device || !write_all(std::move(device), file.bytes)) {
        throw unwritable(file.path, reason(errno));
    }
}

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

void write_files(std::span<const FileToWrite> files) {
    std::vector<Target> targets;
    for (const FileToWrite& file : files) targets.push_back(target_of(file.path));
    std::vector<std::pair<const FileToWrite*, Draft>> drafts;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (targets[i].is_device) continue;
        drafts.emplace_back(&files[i], Draft(targets[i].path));
        if (!drafts.back().second.fill(files[i].bytes)) {
            throw unwritable(files[i].path, reason(errno));
        }
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (targets[i].is_device) write_device(files[i], targets[i]);
    }
    for (auto& [file, draft] : drafts) {
        if (!draft.replace_target()) throw unwritable(file->path, reason(errno));
    }
}

void require_writable(const std::string& path) {
    const Target target = target_of(path);
    if (!target.is_device && !Draft(target.path).is_open()) {
        throw unwritable(path, reason(errno));
    }
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
