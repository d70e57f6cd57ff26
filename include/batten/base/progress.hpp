#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <utility>

namespace batten {

/// Thrown out of long work that was asked to stop. Nothing is half done: there is no result, and
/// what was given to the work is as it was.
class Cancelled : public std::exception {
public:
    const char* what() const noexcept override { return "the work was cancelled"; }
};

/// Told by long work how far it has come; may stop it. A copy tells the same listener.
class Progress {
public:
    /// Called now and then, from the thread that works, with the share that is done: from 0 to 1,
    /// never falling. False stops the work, which then throws `Cancelled`.
    using Listener = std::function<bool(double share)>;

    Progress() = default;
    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    /// For one stage of the work: its 0 to 1 are `from` to `to` of this one.
    Progress stage(double from, double to) const {
        Progress part(*this);
        part.from_ = from_ + from * (to_ - from_);
        part.to_ = from_ + to * (to_ - from_);
        return part;
    }

    /// Tells that `done` of `all` equal steps are done. Throws `Cancelled` if that is wanted.
    void at(std::size_t done, std::size_t all) const {
        if (!listener_) return;
        const double share = all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all);
        if (!listener_(from_ + share * (to_ - from_))) throw Cancelled();
    }

private:
    Listener listener_;
    double from_ = 0, to_ = 1;
};

}  // namespace batten
