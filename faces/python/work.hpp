#pragma once

#include "convert.hpp"

namespace batten::python {

/// Runs an operation with the interpreter's lock released. An interrupt (Ctrl-C), or `progress`
/// saying False or raising, stops it: then the interrupt, `batten.Cancelled` or what was raised is
/// raised and nothing is half done.
Made run(const Operation& operation, const std::vector<Input>& inputs,
         const std::vector<Setting>& settings, py::object progress);

}  // namespace batten::python
