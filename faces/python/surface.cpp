#include "surface.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"

namespace batten::python {
namespace {

constexpr int most_partials = 15;

Partial partial_from(int nux, int nuy) {
    for (const int order : {nux, nuy}) {
        if (order < 0 || order > most_partials) {
            throw Error("option.range", order == nux ? "nux" : "nuy", std::to_string(order),
                        "must be at least 0 and at most " + std::to_string(most_partials));
        }
    }
    return {nux, nuy};
}

std::span<const double> finite_numbers(const Array& array, const char* name) {
    const std::span<const double> numbers{array.data(), static_cast<std::size_t>(array.size())};
    for (const double x : numbers) {
        if (!std::isfinite(x)) {
            throw Error("curve.parameter", name, format_number(x), "places must be finite");
        }
    }
    return numbers;
}

/// At each pair of places; x and y are broadcast as NumPy does.
py::array_t<double> heights_of(const HeldSurface& held, const py::object& x, const py::object& y,
                           int nux, int nuy) {
    const Partial derivative = partial_from(nux, nuy);
    const py::object both = py::module_::import("numpy").attr("broadcast_arrays")(x, y);
    const Array xs = Array::ensure(both[py::int_(0)]), ys = Array::ensure(both[py::int_(1)]);
    if (!xs || !ys) throw py::error_already_set();
    py::array_t<double> result(std::vector<py::ssize_t>(xs.shape(), xs.shape() + xs.ndim()));
    const std::span<const double> places = finite_numbers(xs, "x"), across = finite_numbers(ys, "y");
    double* out = result.mutable_data();
    const py::gil_scoped_release free;
    for (std::size_t i = 0; i < places.size(); ++i) {
        out[i] = height_at(held.surface, places[i], across[i], derivative);
    }
    return result;
}

/// On the grid of two rising lists.
py::array_t<double> on_grid(const HeldSurface& held, const Array& x, const Array& y, int nux,
                            int nuy) {
    const Partial derivative = partial_from(nux, nuy);
    const std::span<const double> xs = finite_numbers(x, "x"), ys = finite_numbers(y, "y");
    for (const auto& [places, name] : {std::pair{xs, "x"}, std::pair{ys, "y"}}) {
        if (!std::is_sorted(places.begin(), places.end())) {
            throw Error("grid.axis", name, "falling", "the lines of a grid must rise");
        }
    }
    py::array_t<double> result({x.size(), y.size()});
    double* out = result.mutable_data();
    const py::gil_scoped_release free;
    if (const auto* product = std::get_if<SplineSurface>(&held.surface)) {
        product->evaluate(xs, ys, derivative, {out, xs.size() * ys.size()});
    } else {
        const Grid z = heights_on(held.surface, xs, ys, derivative);
        std::copy(z.view().values().begin(), z.view().values().end(), out);
    }
    return result;
}

std::string surface_json(const HeldSurface& held) { return dump_json(surface_value(held.surface)); }

HeldSurface surface_from_json(const std::string& text) {
    return {any_surface_of(parse_json(text, "surface"), "surface")};
}

py::tuple sides(Interval side) { return py::make_tuple(side.lo, side.hi); }

std::string shown_surface(const HeldSurface& held) {
    const Rectangle d = domain_of(held.surface);
    return "<batten.Surface over [" + format_number(d.x.lo) + ", " + format_number(d.x.hi) +
           "] x [" + format_number(d.y.lo) + ", " + format_number(d.y.hi) + "]>";
}

}  // namespace

void bind_surface(py::module_& module) {
    py::class_<HeldSurface>(module, "Surface",
                        "A spline surface z = S(x, y): immutable, usable from many threads.")
        .def("__call__", &heights_of, py::arg("x"), py::arg("y"), py::arg("nux") = 0,
             py::arg("nuy") = 0,
             "Heights at the places (x, y), broadcast against each other, or the derivative of\n"
             "order nux by x and nuy by y (of order 9 in all where knot lines are curved).")
        .def("grid", &on_grid, py::arg("x"), py::arg("y"), py::arg("nux") = 0, py::arg("nuy") = 0,
             "The same on the grid of rising x and y: an array (len(x), len(y)), far faster.")
        .def_property_readonly(
            "domain",
            [](const HeldSurface& s) {
                const Rectangle d = domain_of(s.surface);
                return py::make_tuple(sides(d.x), sides(d.y));
            },
            "((x0, x1), (y0, y1))")
        .def_property_readonly("json", &surface_json, "the surface as a `batten.surface/1` file")
        .def("to_json", &surface_json, "the surface as a `batten.surface/1` file: every number exact")
        .def_static("from_json", &surface_from_json, py::arg("text"), "the surface in such a text")
        .def("__repr__", &shown_surface)
        .def(py::pickle([](const HeldSurface& s) { return py::make_tuple(surface_json(s)); },
                        [](const py::tuple& state) {
                            return surface_from_json(state[0].cast<std::string>());
                        }));
}

}  // namespace batten::python
