#include "curve.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "band.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/make/fit_bands.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten::python {
namespace {

/// Parameters evaluated at once where only one derivative of several is kept.
constexpr std::size_t block = 512;

std::span<const double> numbers_in(const Array& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// `given` where it fits, else a new array.
py::array_t<double> room_for(std::vector<py::ssize_t> shape, const py::object& given) {
    if (given.is_none()) return py::array_t<double>(std::move(shape));
    const bool is_array = py::isinstance<py::array_t<double, py::array::c_style>>(given);
    if (is_array) {
        auto out = py::reinterpret_borrow<py::array_t<double>>(given);
        const std::vector<py::ssize_t> found(out.shape(), out.shape() + out.ndim());
        if (found == shape && out.writeable()) return out;
    }
    throw Error("option.value", "out", "another array",
                "must be float64 in C order, writeable and of the result's shape");
}

/// Derivative number `nu` alone.
void derivative(const Curve& curve, std::span<const double> t, int nu, std::span<double> out) {
    const auto dim = static_cast<std::size_t>(curve.dim());
    const std::size_t width = static_cast<std::size_t>(nu + 1) * dim;
    std::vector<double> jets(std::min(block, t.size()) * width);
    for (std::size_t start = 0; start < t.size(); start += block) {
        const std::size_t count = std::min(block, t.size() - start);
        curve.jets(t.subspan(start, count), nu, std::span(jets).first(count * width));
        for (std::size_t i = 0; i < count; ++i) {
            std::copy_n(jets.data() + (i + 1) * width - dim, dim, out.data() + (start + i) * dim);
        }
    }
}

py::array_t<double> called(const Curve& curve, const Array& t, int nu, const py::object& given) {
    require_order(nu, "nu");
    const std::span<const double> parameters = numbers_in(t);
    py::array_t<double> result = room_for(shape_of(t, {curve.dim()}), given);
    const std::span<double> out{result.mutable_data(), static_cast<std::size_t>(result.size())};
    const py::gil_scoped_release free;
    require_finite(parameters, "t");
    if (nu == 0) {
        curve.jets(parameters, 0, out);
    } else {
        derivative(curve, parameters, nu, out);
    }
    return result;
}

py::array_t<double> jets(const Curve& curve, const Array& t, int order, const py::object& given) {
    require_order(order, "order");
    const std::span<const double> parameters = numbers_in(t);
    py::array_t<double> result = room_for(shape_of(t, {order + 1, curve.dim()}), given);
    const std::span<double> out{result.mutable_data(), static_cast<std::size_t>(result.size())};
    const py::gil_scoped_release free;
    require_finite(parameters, "t");
    curve.jets(parameters, order, out);
    return result;
}

/// The band of the last coordinate's derivative `nu`.
py::tuple band_of(const Curve& curve, const Array& t, int nu, double percent) {
    require_order(nu, "nu");
    const std::span<const double> parameters = numbers_in(t);
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    std::vector<double> points(parameters.size() * dim), last(parameters.size());
    {
        const py::gil_scoped_release free;
        require_finite(parameters, "t");
        derivative(curve, parameters, nu, points);
        for (std::size_t i = 0; i < last.size(); ++i) last[i] = points[(i + 1) * dim - 1];
    }
    return band_around(t, last, covariance_of(curve), nu, percent);
}

/// None where the curve is no graph.
py::object spline_under(const Curve& curve) {
    std::optional<SplineFunction> spline = spline_of_graph(curve);
    if (!spline) return py::none();
    const FitCovariance* covariance = covariance_of(curve);
    return py::cast(HeldSpline{*std::move(spline),
                               covariance ? std::optional(*covariance) : std::nullopt});
}

std::string json_of(const Curve& curve) { return dump_json(curve_value(curve)); }

Curve from_json(const std::string& text) { return curve_of(parse_json(text, "curve"), "curve"); }

std::string shown(const Curve& curve) {
    const Interval domain = curve.domain();
    return "<batten.Curve: " + std::to_string(curve.dim()) + " coordinates, " +
           std::to_string(curve.pieces()) + " pieces over [" + format_number(domain.lo) + ", " +
           format_number(domain.hi) + "]>";
}

}  // namespace

void bind_curve(py::module_& module) {
    py::class_<Curve>(module, "Curve", "Any curve: immutable, usable from many threads.")
        .def("__call__", &called, py::arg("t"), py::arg("nu") = 0, py::arg("out") = py::none(),
             "Points at the parameters t (any shape), or derivatives of order nu: an array of\n"
             "t.shape + (dim,). At a break those of the piece to the right; beyond the domain the\n"
             "end pieces go on. `out`, float64 in C order, is written to where given.")
        .def("jets", &jets, py::arg("t"), py::arg("order"), py::arg("out") = py::none(),
             "Points and derivatives up to `order`: an array of t.shape + (order + 1, dim).")
        .def("band", &band_of, py::arg("t"), py::arg("nu") = 0, py::arg("percent") = 95.0,
             "Lower and upper edge, at t (any shape), of the band that holds y (or a derivative of\n"
             "it) with this probability at each t by itself. Curves of a fit y(x) only.")
        .def_property_readonly("spline", &spline_under,
                               "the Spline whose graph it is, or None where it is none")
        .def_property_readonly("dim", &Curve::dim, "number of coordinates")
        .def_property_readonly("pieces", &Curve::pieces, "number of smooth pieces")
        .def_property_readonly("degree", &Curve::degree,
                               "degree of the pieces where they are polynomials, else None")
        .def_property_readonly("is_closed", &Curve::is_closed, "whether the end goes on at the start")
        .def_property_readonly(
            "domain",
            [](const Curve& c) { return py::make_tuple(c.domain().lo, c.domain().hi); },
            "first and last parameter")
        .def_property_readonly(
            "breaks",
            [](py::object self) {
                const std::span<const double> breaks = self.cast<const Curve&>().breaks();
                py::array_t<double> array(static_cast<py::ssize_t>(breaks.size()), breaks.data(),
                                          self);
                array.attr("setflags")(py::arg("write") = false);
                return array;
            },
            "parameters where smoothness may drop, both ends included")
        .def("to_json", &json_of, "the curve as a `batten.curve/1` file: every number exact")
        .def_static("from_json", &from_json, py::arg("text"), "the curve in such a text")
        .def("_repr_svg_", [](const Curve& c) { return svg_picture(c); })
        .def("__repr__", &shown)
        .def(py::pickle([](const Curve& c) { return py::make_tuple(json_of(c)); },
                        [](const py::tuple& state) {
                            return from_json(state[0].cast<std::string>());
                        }));
}

}  // namespace batten::python
