#pragma once

#include "convert.hpp"

namespace batten::python {

/// Adds the class `Spline`: y(x) with `.t .c .k`.
void bind_spline(py::module_& module);

}  // namespace batten::python
