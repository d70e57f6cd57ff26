#pragma once

#include <cmath>
#include <cstddef>
#include <memory>

#include "batten/base/progress.hpp"

namespace batten::fitting {

/// Counts the refits of one fit and tells how far it may be. Copies count together.
///
/// Nobody knows how many there will be: the share is r / (r + 100) with r the root of their number,
/// so a hundred are told as 9 %, ten thousand as half.
class Work {
public:
    Work() = default;
    explicit Work(const Progress& progress) : state_(std::make_shared<State>(State{progress})) {}

    /// One refit is done, or one sum over knots. Throws `Cancelled` if that is wanted.
    void step() const {
        if (!state_) return;
        constexpr std::size_t told_every = 16;
        if (state_->steps++ % told_every != 0) return;
        constexpr double unit = 1000, slowly = 100;
        const double root = std::sqrt(static_cast<double>(state_->steps));
        state_->progress.at(static_cast<std::size_t>(unit * root),
                            static_cast<std::size_t>(unit * (root + slowly)));
    }
    /// All is done.
    void finish() const {
        if (state_) state_->progress.at(1, 1);
    }

private:
    struct State {
        Progress progress;
        std::size_t steps = 0;
    };
    std::shared_ptr<State> state_;
};

}  // namespace batten::fitting
