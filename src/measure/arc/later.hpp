#pragma once

#include <atomic>

namespace batten::arc {

/// What is made when it is first asked for. Threads that ask at once each make it, one is kept.
template <class T>
class Later {
public:
    Later() = default;
    Later(const Later&) = delete;
    Later& operator=(const Later&) = delete;
    ~Later() { delete made_.load(std::memory_order_relaxed); }

    /// `make` returns it, always the same.
    template <class Make>
    const T& get(const Make& make) const {
        if (const T* made = made_.load(std::memory_order_acquire)) return *made;
        const T* mine = new T(make());
        const T* first = nullptr;
        if (made_.compare_exchange_strong(first, mine, std::memory_order_acq_rel,
                                          std::memory_order_acquire)) {
            return *mine;
        }
        delete mine;
        return *first;
    }

private:
    mutable std::atomic<const T*> made_{nullptr};
};

}  // namespace batten::arc
