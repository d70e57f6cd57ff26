#pragma once

#include "convert.hpp"

namespace batten::python {

/// The class `Curve`.
void bind_curve(py::module_& module);

}  // namespace batten::python
