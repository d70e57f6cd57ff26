#pragma once

#include "convert.hpp"

namespace batten::python {

/// The class `FitChunk`.
void bind_chunk(py::module_& module);

}  // namespace batten::python
