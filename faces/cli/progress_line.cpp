#include "progress_line.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>

namespace batten::cli {
namespace {

using std::chrono::milliseconds;

/// Work that is done before is not worth a line.
constexpr milliseconds patience{500};
constexpr milliseconds terminal_pause{200}, log_pause{1000};

/// `45 s`, `3 min 20 s`, `2 h 05 min`.
std::string time_text(double seconds) {
    const long all = std::lround(std::ceil(seconds));
    const auto two = [](long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    if (all < 60) return std::to_string(all) + " s";
    if (all < 3600) return std::to_string(all / 60) + " min " + two(all % 60) + " s";
    return std::to_string(all / 3600) + " h " + two(all / 60 % 60) + " min";
}

}  // namespace

ProgressLine::ProgressLine(const Command& command)
    : verb_(command.operation->name), is_terminal_(isatty(STDERR_FILENO) == 1),
      is_wanted_(command.progress == "always" || (command.progress == "auto" && is_terminal_)),
      next_(start_ + (command.progress == "always" ? milliseconds{0} : patience)) {}

ProgressLine::~ProgressLine() {
    if (is_shown_ && is_terminal_) std::cerr << "\r\x1b[K" << std::flush;
}

Progress ProgressLine::progress() {
    if (!is_wanted_) return {};
    return Progress([this](double share) {
        show(share);
        return true;
    });
}

void ProgressLine::show(double share) {
    const Clock::time_point now = Clock::now();
    if (now < next_ && share < 1) return;
    next_ = now + (is_terminal_ ? terminal_pause : log_pause);
    is_shown_ = true;
    const double spent = std::chrono::duration<double>(now - start_).count();
    std::string line = "batten " + verb_ + ": " + std::to_string(std::lround(100 * share)) + " %";
    if (share > 0 && share < 1) line += ", " + time_text(spent * (1 - share) / share) + " left";
    if (is_terminal_) {
        std::cerr << '\r' << line << "\x1b[K" << std::flush;
    } else {
        std::cerr << line << std::endl;
    }
}

}  // namespace batten::cli
