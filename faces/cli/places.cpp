#include "places.hpp"

#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <system_error>

#include "batten/base/error.hpp"

namespace batten::cli {
namespace {

namespace fs = std::filesystem;

/// One name for one file, however it is spelt.
fs::path place_of(const std::string& path) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : place;
}

/// A device may be written to twice: /dev/null keeps nothing.
bool is_device(const fs::path& place) {
    std::error_code error;
    const fs::file_status status = fs::status(place, error);
    return fs::exists(status) && !fs::is_regular_file(status);
}

/// The files that a command reads: its inputs, and options that name files.
std::vector<std::string> files_read(const Command& command) {
    std::vector<std::string> files = command.inputs;
    if (!command.job.empty()) files.push_back(command.job);
    for (const auto& [field, text] : command.options) {
        std::error_code error;
        if (fs::is_regular_file(text, error)) files.push_back(text);
    }
    return files;
}

/// A file to be written, and who asks for it, as errors call it.
struct Target {
    std::string asked_by, path;
};

std::vector<Target> targets_of(const Command& command) {
    const bool is_step = !command.step.empty();
    const auto name = [&](const char* flag, const char* key) {
        return is_step ? command.step + ", " + key : std::string(flag);
    };
    std::vector<Target> targets;
    for (Target& target : std::vector<Target>{{name("-o", "output"), command.output},
                                              {name("--report", "report"), command.report},
                                              {name("--draw", "draw"), command.drawing}}) {
        const bool is_file = !target.path.empty() && target.path != "-";
        if (is_file && !is_device(place_of(target.path))) targets.push_back(std::move(target));
    }
    return targets;
}

}  // namespace

void require_places(const std::vector<const Command*>& commands) {
    std::set<fs::path> read;
    for (const Command* command : commands) {
        for (const std::string& path : files_read(*command)) read.insert(place_of(path));
    }
    std::map<fs::path, std::string> written;
    for (const Command* command : commands) {
        for (const Target& target : targets_of(*command)) {
            const fs::path file = place_of(target.path);
            if (read.count(file) > 0) {
                throw Error("output.is-input", target.asked_by, target.path,
                            "must be another file than those that are read");
            }
            const auto [before, is_new] = written.emplace(file, target.asked_by);
            if (!is_new) {
                throw Error("output.twice", before->second + " and " + target.asked_by, target.path,
                            "each must have a file of its own");
            }
            require_writable(target.path);
        }
    }
}

void write(const std::vector<FileToWrite>& texts) {
    std::vector<FileToWrite> files;
    for (const FileToWrite& text : texts) {
        if (text.path != "-") files.push_back(text);
    }
    write_files(files);
    for (const FileToWrite& text : texts) {
        if (text.path == "-") std::cout << text.bytes;
    }
    if (!std::cout.flush()) {
        throw Error("file.unwritable", "standard output", "not all could be written",
                    "what reads it must take it whole");
    }
}

}  // namespace batten::cli
