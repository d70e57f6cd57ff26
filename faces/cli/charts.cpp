#include "charts.hpp"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "batten/base/error.hpp"
#include "batten/io/draw/gnuplot.hpp"

namespace batten::cli {
namespace {

/// A file that is gone when its owner is.
class ScriptFile {
public:
    explicit ScriptFile(const std::string& text) {
        const int file = mkstemp(path_);
        if (file < 0) fail("no temporary file");
        const bool is_whole = ::write(file, text.data(), text.size()) ==
                              static_cast<ssize_t>(text.size());
        ::close(file);
        if (!is_whole) {
            ::unlink(path_);
            fail("no room for a temporary file");
        }
    }
    ScriptFile(const ScriptFile&) = delete;
    ScriptFile& operator=(const ScriptFile&) = delete;
    ~ScriptFile() { ::unlink(path_); }

    const char* path() const { return path_; }

    [[noreturn]] static void fail(const std::string& what) {
        throw Error("output.gnuplot", "gnuplot", what,
                    "pictures other than SVG are drawn by gnuplot 5");
    }

private:
    char path_[28] = "/tmp/batten-gnuplot-XXXXXX";
};

std::string by_gnuplot(const std::string& script) {
    const ScriptFile file(script);
    FILE* const pipe = popen((std::string("gnuplot ") + file.path() + " 2> /dev/null").c_str(), "r");
    if (!pipe) ScriptFile::fail("cannot be started");
    std::string bytes;
    char block[65536];
    for (std::size_t count; (count = fread(block, 1, sizeof block, pipe)) > 0;) {
        bytes.append(block, count);
    }
    const int status = pclose(pipe);
    if (status != 0 || bytes.empty()) ScriptFile::fail("is missing or fails");
    return bytes;
}

}  // namespace

std::string picture(const Drawing& drawing, const std::string& suffix) {
    if (suffix == "svg") return svg(drawing);
    if (suffix == "png") return by_gnuplot(gnuplot_script(drawing, ChartFormat::png));
    if (suffix == "pdf") return by_gnuplot(gnuplot_script(drawing, ChartFormat::pdf));
    throw Error("output.format", "draw", suffix.empty() ? "no suffix" : suffix,
                "must be one of svg, png, pdf");
}

}  // namespace batten::cli
