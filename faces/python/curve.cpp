#include "curve.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/json.hpp"
#include "batten/io/svg_path.hpp"
#include "batten/make/fit_bands.hpp"

namespace batten::python {
namespace {

constexpr int most_derivatives = 15;
/// Parameters evaluated at once where only one derivative of several is kept.
constexpr std::size_t block = 512;

void require_order(int order, const char* name) {
    if (order < 0 || order > most_derivatives) {
        throw Error("option.range", name, std::to_string(order),
                    "must be at least 0 and at most " + std::to_string(most_derivatives));
    }
}

void require_finite(std::span<const double> t) {
    for (const double x : t) {
        if (!std::isfinite(x)) {
            throw Error("curve.parameter", "t", format_number(x), "parameters must be finite");
        }
    }
}

std::span<const double> numbers_in(const Array& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

std::vector<py::ssize_t> shape_of(const Array& t, std::initializer_list<int> more) {
    std::vector<py::ssize_t> shape(t.shape(), t.shape() + t.ndim());
    shape.insert(shape.end(), more.begin(), more.end());
    return shape;
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
    require_finite(parameters);
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
    require_finite(parameters);
    curve.jets(parameters, order, out);
    return result;
}

/// The edges of the band of the last coordinate's derivative `nu`.
py::tuple band_of(const Curve& curve, const Array& t, int nu, double percent) {
    require_order(nu, "nu");
    if (!(percent > 0 && percent < 100)) {
        throw Error("option.range", "percent", format_number(percent),
                    "must be above 0 and below 100");
    }
    const FitCovariance* covariance = covariance_of(curve);
    if (!covariance) {
        throw Error("curve.no-band", "band", format_number(percent),
                    "the curve does not say how sure it is: take that of a fit y(x), nothing made "
                    "of it");
    }
    const std::span<const double> parameters = numbers_in(t);
    py::array_t<double> lower(shape_of(t, {})), upper(shape_of(t, {}));
    const std::span<double> lo{lower.mutable_data(), parameters.size()};
    const std::span<double> hi{upper.mutable_data(), parameters.size()};
    {
        const py::gil_scoped_release free;
        require_finite(parameters);
        std::vector<double> values(parameters.size() * static_cast<std::size_t>(curve.dim()));
        if (nu == 0) curve.jets(parameters, 0, values);
        else derivative(curve, parameters, nu, values);
        const double factor = covariance->factor(percent);
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            const double value = values[(i + 1) * static_cast<std::size_t>(curve.dim()) - 1];
            const double half = factor * covariance->deviation(parameters[i], nu);
            if (!std::isfinite(value - half) || !std::isfinite(value + half)) {
                throw Error("number.overflow", "band", format_number(half),
                            "is beyond the range of a double");
            }
            lo[i] = value - half;
            hi[i] = value + half;
        }
    }
    return py::make_tuple(lower, upper);
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
