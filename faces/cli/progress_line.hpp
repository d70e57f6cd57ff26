#pragma once

#include <chrono>
#include <string>

#include "batten/base/progress.hpp"
#include "command_line.hpp"

namespace batten::cli {

/// One line on standard error that tells how far long work has come and how long it still takes.
/// On a terminal it is written over until it goes; elsewhere (`--progress always`) lines follow
/// each other, at most one a second.
class ProgressLine {
public:
    explicit ProgressLine(const Command& command);
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// To be given to the work; must not outlive the line.
    Progress progress();

private:
    using Clock = std::chrono::steady_clock;
    void show(double share);

    std::string verb_;
    bool is_terminal_, is_wanted_, is_shown_ = false;
    Clock::time_point start_ = Clock::now(), next_;
};

}  // namespace batten::cli
