#pragma once

#include <string>

#include "batten/api/operation.hpp"

/// How the rows of the operations table look to Python.
namespace batten::python {

/// `weight_exponent` as it is; `as`, a word of the language, as `as_`.
std::string keyword_name(const std::string& field);

/// `log-aesthetic` as `log_aesthetic`.
std::string function_name(const Operation& operation);

/// What the first argument is called; empty where there is none.
std::string input_name(const Operation& operation);

/// Signature and docstring in the form that CPython splits into `__text_signature__` and `__doc__`.
std::string docstring(const Operation& operation);

/// One function of the stub file, with types.
std::string stub(const Operation& operation);

}  // namespace batten::python
