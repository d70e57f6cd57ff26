#include "work.hpp"

#include <chrono>

namespace batten::python {
namespace {

using Clock = std::chrono::steady_clock;

/// Interrupts are looked for, and listeners told, so often.
constexpr std::chrono::milliseconds pause{50};

/// Whether the work may go on. Where not, Python's error is set unless the listener said False.
bool tell(const py::object& listener, double share) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) return false;
    if (listener.is_none()) return true;
    try {
        return !listener(share).is(py::bool_(false));
    } catch (py::error_already_set& raised) {
        raised.restore();
        return false;
    }
}

}  // namespace

Made run(const Operation& operation, const std::vector<Input>& inputs,
         const std::vector<Setting>& settings, py::object progress) {
    Clock::time_point next = Clock::now() + pause;
    const Progress listening([&](double share) {
        const Clock::time_point now = Clock::now();
        if (now < next && share < 1) return true;
        next = now + pause;
        return tell(progress, share);
    });
    try {
        const py::gil_scoped_release free;
        return {&operation, operation.run(inputs, settings, listening)};
    } catch (const Cancelled&) {
        if (PyErr_Occurred()) throw py::error_already_set();
        throw;
    }
}

}  // namespace batten::python
