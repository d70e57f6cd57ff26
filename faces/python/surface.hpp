#pragma once

#include "convert.hpp"

namespace batten::python {

/// The class `Surface`.
void bind_surface(py::module_& module);

}  // namespace batten::python
