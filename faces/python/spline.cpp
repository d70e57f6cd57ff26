#include "spline.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/spline_function.hpp"

namespace batten::python {
namespace {

py::array_t<double> array_of(std::span<const double> numbers) {
    return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

std::vector<double> numbers_of(const Array& array) {
    return {array.data(), array.data() + array.size()};
}

/// A read-only view of what the spline holds.
template <class Part>
auto view(Part part) {
    return [part](py::object self) {
        const std::span<const double> numbers = (self.cast<const SplineFunction&>().*part)();
        py::array_t<double> array(static_cast<py::ssize_t>(numbers.size()), numbers.data(), self);
        array.attr("setflags")(py::arg("write") = false);
        return array;
    };
}

py::array_t<double> spline_values(const SplineFunction& spline, const Array& x, int nu) {
    if (nu < 0) throw Error("option.range", "nu", std::to_string(nu), "must be at least 0");
    py::array_t<double> result(std::vector<py::ssize_t>(x.shape(), x.shape() + x.ndim()));
    const std::span<const double> at{x.data(), static_cast<std::size_t>(x.size())};
    const std::span<double> out{result.mutable_data(), at.size()};
    const py::gil_scoped_release free;
    for (const double value : at) {
        if (std::isfinite(value)) continue;
        throw Error("curve.parameter", "x", format_number(value), "abscissae must be finite");
    }
    spline.evaluate(at, nu, out);
    return result;
}

py::array_t<double> power_form(const SplineFunction& spline) {
    py::array_t<double> result({static_cast<py::ssize_t>(spline.degree() + 1),
                                static_cast<py::ssize_t>(spline.pieces())});
    for (int row = 0; row <= spline.degree(); ++row) {
        const std::span<const double> power = spline.power(spline.degree() - row);
        std::copy(power.begin(), power.end(), result.mutable_data(row, 0));
    }
    return result;
}

py::tuple without_knot(const SplineFunction& spline, std::size_t index) {
    KnotRemoval removal = remove_knot(spline, index);
    return py::make_tuple(std::move(removal.spline), removal.max_error);
}

std::string spline_shown(const SplineFunction& spline) {
    const Interval domain = spline.domain();
    return "<batten.Spline: degree " + std::to_string(spline.degree()) + ", " +
           std::to_string(spline.pieces()) + " pieces over [" + format_number(domain.lo) + ", " +
           format_number(domain.hi) + "]>";
}

}  // namespace

void bind_spline(py::module_& module) {
    py::class_<SplineFunction>(
        module, "Spline",
        "A spline y(x), immutable: Spline(t, c, k) of knots, coefficients and degree, as in SciPy's\n"
        "BSpline. Of a fit: Spline(report['knots'], report['coefficients'], options['degree']).")
        .def(py::init([](const Array& t, const Array& c, int k) {
                 return SplineFunction(numbers_of(t), numbers_of(c), k);
             }),
             py::arg("t"), py::arg("c"), py::arg("k") = 3)
        .def("__call__", &spline_values, py::arg("x"), py::arg("nu") = 0,
             "Values at x (any shape), or derivatives of order nu.")
        .def_property_readonly("t", view(&SplineFunction::knots), "knots")
        .def_property_readonly("c", view(&SplineFunction::coefficients), "coefficients")
        .def_property_readonly("k", &SplineFunction::degree, "degree")
        .def_property_readonly("breaks", view(&SplineFunction::breaks), "distinct knots")
        .def_property_readonly("power", &power_form,
                               "coefficients of (x - breaks[i])**(k - j) at [j, i]: SciPy's PPoly.c")
        .def("derivative", &batten::derivative, "dS/dx, of one degree less")
        .def("antiderivative", &batten::antiderivative, "the integral from the start")
        .def("integrate", [](const SplineFunction& s, double a, double b) {
                 return integral(s, {a, b});
             }, py::arg("a"), py::arg("b"), "the integral from a to b")
        .def("roots", [](const SplineFunction& s, double level) { return array_of(roots(s, level)); },
             py::arg("level") = 0.0, "where the spline crosses a level, rising")
        .def("extrema", [](const SplineFunction& s) { return array_of(extrema(s)); },
             "where the derivative changes sign, rising")
        .def("insert_knots", [](const SplineFunction& s, const Array& knots) {
                 return insert_knots(s, numbers_of(knots));
             }, py::arg("knots"), "the same spline with more knots")
        .def("remove_knot", &without_knot, py::arg("index"),
             "the spline without t[index], and a bound of the change")
        .def("elevate_degree", &elevate_degree, py::arg("by") = 1, "the same, of a higher degree")
        .def("graph", &graph, "the Curve x(t) = t, y(t) = S(t)")
        .def("__repr__", &spline_shown)
        .def(py::pickle(
            [](const SplineFunction& s) {
                return py::make_tuple(array_of(s.knots()), array_of(s.coefficients()), s.degree());
            },
            [](const py::tuple& state) {
                return SplineFunction(numbers_of(state[0].cast<Array>()),
                                      numbers_of(state[1].cast<Array>()), state[2].cast<int>());
            }));
}

}  // namespace batten::python
