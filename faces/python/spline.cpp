#include "spline.hpp"

#include <pybind11/stl.h>

#include "band.hpp"
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

/// A copy of what the spline holds: SciPy's `BSpline` takes only what may be written to.
template <class Part>
auto copy(Part part) {
    return [part](const HeldSpline& held) { return array_of((held.spline.*part)()); };
}

/// What a part of the spline says.
template <class Part>
auto of(Part part) {
    return [part](const HeldSpline& held) { return (held.spline.*part)(); };
}

/// Another spline made of it.
template <class Make>
auto made_of(Make make) {
    return [make](const HeldSpline& held) { return HeldSpline{make(held.spline)}; };
}

py::array_t<double> spline_values(const HeldSpline& held, const Array& x, int nu) {
    if (nu < 0) throw Error("option.range", "nu", std::to_string(nu), "must be at least 0");
    py::array_t<double> result(std::vector<py::ssize_t>(x.shape(), x.shape() + x.ndim()));
    const std::span<const double> at{x.data(), static_cast<std::size_t>(x.size())};
    const std::span<double> out{result.mutable_data(), at.size()};
    const py::gil_scoped_release free;
    require_finite(at, "x");
    held.spline.evaluate(at, nu, out);
    return result;
}

py::tuple spline_band(const HeldSpline& held, const Array& x, int nu, double percent) {
    require_order(nu, "nu");
    const py::array_t<double> values = spline_values(held, x, nu);
    const std::span<const double> around{values.data(), static_cast<std::size_t>(values.size())};
    return band_around(x, around, held.covariance ? &*held.covariance : nullptr, nu, percent);
}

py::array_t<double> power_of(const HeldSpline& held) {
    const SplineFunction& spline = held.spline;
    py::array_t<double> result({static_cast<py::ssize_t>(spline.degree() + 1),
                                static_cast<py::ssize_t>(spline.pieces())});
    for (int row = 0; row <= spline.degree(); ++row) {
        const std::span<const double> power = spline.power(spline.degree() - row);
        std::copy(power.begin(), power.end(), result.mutable_data(row, 0));
    }
    return result;
}

py::tuple without_knot(const HeldSpline& held, std::size_t index) {
    KnotRemoval removal = remove_knot(held.spline, index);
    return py::make_tuple(HeldSpline{std::move(removal.spline)}, removal.max_error);
}

std::string spline_shown(const HeldSpline& held) {
    const SplineFunction& spline = held.spline;
    const Interval domain = spline.domain();
    return "<batten.Spline: degree " + std::to_string(spline.degree()) + ", " +
           std::to_string(spline.pieces()) + " pieces over [" + format_number(domain.lo) + ", " +
           format_number(domain.hi) + "]>";
}

}  // namespace

void bind_spline(py::module_& module) {
    py::class_<HeldSpline>(
        module, "Spline",
        "A spline y(x), immutable: Spline(t, c, k) of knots, coefficients and degree, as in SciPy's\n"
        "BSpline. That of a fit is `spline` of its outcome, and knows its band.")
        .def(py::init([](const Array& t, const Array& c, int k) {
                 return HeldSpline{{numbers_of(t), numbers_of(c), k}};
             }),
             py::arg("t"), py::arg("c"), py::arg("k") = 3)
        .def("__call__", &spline_values, py::arg("x"), py::arg("nu") = 0,
             "Values at x (any shape), or derivatives of order nu.")
        .def("band", &spline_band, py::arg("x"), py::arg("nu") = 0, py::arg("percent") = 95.0,
             "Lower and upper edge, at x (any shape), of the band that holds y (or a derivative of\n"
             "it) with this probability at each x by itself. Of a fit's own spline only.")
        .def_property_readonly("t", copy(&SplineFunction::knots), "knots")
        .def_property_readonly("c", copy(&SplineFunction::coefficients), "coefficients")
        .def_property_readonly("k", of(&SplineFunction::degree), "degree")
        .def_property_readonly("breaks", copy(&SplineFunction::breaks), "distinct knots")
        .def_property_readonly("power", &power_of,
                               "coefficients of (x - breaks[i])**(k - j) at [j, i]: SciPy's PPoly.c")
        .def("derivative", made_of(&batten::derivative), "dS/dx, of one degree less")
        .def("antiderivative", made_of(&batten::antiderivative), "the integral from the start")
        .def("integrate", [](const HeldSpline& s, double a, double b) {
                 return integral(s.spline, {a, b});
             }, py::arg("a"), py::arg("b"), "the integral from a to b")
        .def("roots", [](const HeldSpline& s, double level) {
                 return array_of(roots(s.spline, level));
             },
             py::arg("level") = 0.0, "where the spline crosses a level, rising")
        .def("extrema", [](const HeldSpline& s) { return array_of(extrema(s.spline)); },
             "where the derivative changes sign, rising")
        .def("insert_knots", [](const HeldSpline& s, const Array& knots) {
                 return HeldSpline{insert_knots(s.spline, numbers_of(knots))};
             }, py::arg("knots"), "the same spline with more knots")
        .def("remove_knot", &without_knot, py::arg("index"),
             "the spline without t[index], and a bound of the change")
        .def("elevate_degree", [](const HeldSpline& s, int by) {
                 return HeldSpline{elevate_degree(s.spline, by)};
             }, py::arg("by") = 1, "the same, of a higher degree")
        .def("graph", [](const HeldSpline& s) { return graph(s.spline); },
             "the Curve x(t) = t, y(t) = S(t)")
        .def("__repr__", &spline_shown)
        .def(py::pickle(
            [](const HeldSpline& s) {
                return py::make_tuple(array_of(s.spline.knots()), array_of(s.spline.coefficients()),
                                      s.spline.degree());
            },
            [](const py::tuple& state) {
                return HeldSpline{{numbers_of(state[0].cast<Array>()),
                                   numbers_of(state[1].cast<Array>()), state[2].cast<int>()}};
            }));
}

}  // namespace batten::python
