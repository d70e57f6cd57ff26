#include "chunk.hpp"

#include <algorithm>

#include "batten/api/fit_outcome.hpp"
#include "batten/base/error.hpp"
#include "batten/make/fit_chunks.hpp"

namespace batten::python {
namespace {

std::span<const double> view_of_array(const Array& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// From knots with both ends, each as often as it may be.
FitChunk chunk_over(const Array& knots, int degree) {
    const std::span<const double> all = view_of_array(knots);
    if (all.size() < 2) {
        throw Error("fit.knots", "knots", std::to_string(all.size()),
                    "both ends of the domain are needed");
    }
    const Interval domain{all.front(), all.back()};
    const auto is_end = [&](double x) { return x == domain.lo || x == domain.hi; };
    std::vector<double> inside;
    std::remove_copy_if(all.begin(), all.end(), std::back_inserter(inside), is_end);
    return FitChunk(domain, std::move(inside), degree);
}

void add_samples(FitChunk& chunk, const Array& x, const Array& y, const Array& sigma) {
    for (const auto& [array, name] : {std::pair{&x, "x"}, std::pair{&y, "y"}}) {
        if (array->ndim() == 1) continue;
        throw Error("option.value", name, std::to_string(array->ndim()) + " dimensions",
                    "must be a list of numbers");
    }
    const std::span<const double> errors = view_of_array(sigma);
    if (sigma.ndim() == 0) {
        if (!(errors[0] > 0)) {
            throw Error("fit.sigma", "sigma", std::to_string(errors[0]), "errors must be above 0");
        }
        chunk.add({view_of_array(x), view_of_array(y)}, errors[0]);
    } else {
        chunk.add({view_of_array(x), view_of_array(y), errors});
    }
}

Made solved(const FitChunk& chunk) {
    const py::gil_scoped_release free;
    return {find_operation("fit"), outcome_of(chunk.solve())};
}

}  // namespace

void bind_chunk(py::module_& module) {
    py::class_<FitChunk>(
        module, "FitChunk",
        "Data reduced to what a spline over given knots needs to know of them, a few numbers an\n"
        "interval: FitChunk(knots, degree), the knots rising with both ends. Blocks of data are added\n"
        "one by one, chunks merged, and the fit solved at any time.")
        .def(py::init(&chunk_over), py::arg("knots"), py::arg("degree") = 3)
        .def("add", &add_samples, py::arg("x"), py::arg("y"), py::arg("sigma") = 1.0,
             "Takes in measurements; sigma is the error of all, or one each.")
        .def("merge", &FitChunk::merge, py::arg("other"),
             "Takes in what another chunk over the same knots has seen.")
        .def("solve", &solved, "The fit, an Outcome: spline, curve and report.")
        .def_property_readonly("samples", &FitChunk::samples, "how many it has seen")
        .def_property_readonly(
            "knots",
            [](const FitChunk& c) {
                return py::array_t<double>(static_cast<py::ssize_t>(c.knots().size()),
                                           c.knots().data());
            },
            "the full knot vector")
        .def_property_readonly("degree", &FitChunk::degree, "degree of the spline")
        .def("__repr__", [](const FitChunk& c) {
            return "<batten.FitChunk of " + std::to_string(c.samples()) + " samples>";
        });
}

}  // namespace batten::python
