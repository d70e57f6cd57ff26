#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

#include "batten/api/operation.hpp"

/// Between Python's objects and what the operations take and make.
namespace batten::python {

namespace py = pybind11;

/// Numbers as NumPy holds them; arrays of float64 in C order are read where they are.
using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What an operation made; what Python calls an `Outcome`.
struct Made {
    const Operation* operation;
    Outcome outcome;
};

/// What Python calls a `Surface`: a class of its own, since pybind11 takes variants apart.
struct HeldSurface {
    Surface surface;
};

/// What Python calls a `Spline`.
struct HeldSpline {
    SplineFunction spline;
    std::optional<FitCovariance> covariance = {};  ///< of a fit's own
};

/// A curve, a surface, an outcome, an array of rows or of heights, or a map of columns. Arrays of float64 in C order are not
/// copied: the input keeps them. Throws `input.kind`, `points.dimension`.
Input input_from(const Operation& operation, py::handle object, const std::string& name);

/// What a keyword's value means for an option. Throws `option.value`.
Argument argument_from(const Field& field, py::handle object);

/// A tree as dictionaries, lists, numbers, texts, True, False and None.
py::object object_of(const Value& value);

/// An array over the caller's memory, which `owner` keeps alive; not writeable.
py::array_t<double> view_of(PointsView points, py::handle owner);

}  // namespace batten::python
