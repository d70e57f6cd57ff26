#include <algorithm>
#include <set>

#include "batten/base/error.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/io/json.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/table.hpp"
#include "chunk.hpp"
#include "convert.hpp"
#include "curve.hpp"
#include "signature.hpp"
#include "spline.hpp"
#include "surface.hpp"
#include "work.hpp"

namespace batten::python {
namespace {

py::object error_class(const char* name) {
    return py::module_::import("batten._error").attr(name);
}

/// The one translator of exceptions.
void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
        const py::object type = error_class("Error");
        const py::object raised =
            type(error.code(), error.place(), error.value(), error.rule());
        PyErr_SetObject(type.ptr(), raised.ptr());
    } catch (const Cancelled& stopped) {
        PyErr_SetString(error_class("Cancelled").ptr(), stopped.what());
    }
}

/// The option that a keyword names: itself, or with the underscore of reserved words.
const Field* field_called(const Operation& operation, const std::string& keyword) {
    for (const Field& field : operation.fields) {
        if (field.name == keyword || keyword_name(field.name) == keyword) return &field;
    }
    return nullptr;
}

std::vector<Setting> settings_of(const Operation& operation, const py::kwargs& keywords) {
    std::vector<Setting> settings;
    for (const auto& [key, value] : keywords) {
        const std::string name = py::str(key);
        if (name == "progress") continue;
        const Field* field = field_called(operation, name);
        if (!field) {
            throw Error("option.unknown", name, "given",
                        function_name(operation) + " has no such option");
        }
        if (!value.is_none()) settings.push_back({field->name, argument_from(*field, value)});
    }
    return settings;
}

std::vector<Input> inputs_of(const Operation& operation, const py::args& arguments) {
    std::vector<Input> inputs;
    const std::string name = input_name(operation);
    for (const py::handle each : arguments) {
        const std::string number =
            arguments.size() > 1 ? ' ' + std::to_string(inputs.size() + 1) : "";
        inputs.push_back(input_from(operation, each, name + number));
    }
    return inputs;
}

void bind_operation(py::module_& module, const Operation& operation) {
    const std::string name = function_name(operation), doc = docstring(operation);
    const auto call = [&operation](const py::args& arguments, const py::kwargs& keywords) {
        const std::vector<Input> inputs = inputs_of(operation, arguments);
        const std::vector<Setting> settings = settings_of(operation, keywords);
        const py::object progress =
            keywords.contains("progress") ? py::object(keywords["progress"]) : py::none();
        return run(operation, inputs, settings, progress);
    };
    module.def(name.c_str(), call, doc.c_str());
}

py::object points_of(py::object self) {
    const Rows* rows = std::get_if<Rows>(&self.cast<const Made&>().outcome.output);
    return rows ? py::object(view_of(rows->cells, self)) : py::none();
}

std::vector<Curve> curves_made(const Made& made) {
    const Curve* curve = std::get_if<Curve>(&made.outcome.output);
    return curve ? std::vector<Curve>{*curve} : made.outcome.curves;
}

/// None where there is none, or more than one.
py::object curve_of(const Made& made) {
    const std::vector<Curve> curves = curves_made(made);
    return curves.size() == 1 ? py::cast(curves.front()) : py::none();
}

py::list curve_list(const std::vector<Curve>& curves) {
    py::list list;
    for (const Curve& curve : curves) list.append(py::cast(curve));
    return list;
}

py::object spline_made(const Made& made) {
    if (!made.outcome.spline) return py::none();
    return py::cast(HeldSpline{made.outcome.spline->spline, made.outcome.spline->covariance});
}

py::object surface_of(const Made& made) {
    const Surface* surface = std::get_if<Surface>(&made.outcome.output);
    return surface ? py::cast(HeldSurface{*surface}) : py::none();
}

py::list names_of(const Made& made) {
    py::list names;
    if (const Rows* rows = std::get_if<Rows>(&made.outcome.output)) {
        for (const std::string& name : rows->names) names.append(name);
    }
    return names;
}

/// Columns by name, each a view of the rows that `owner` keeps.
py::dict columns_of(const Rows& rows, py::handle owner) {
    const std::size_t width = rows.names.size();
    py::dict columns;
    for (std::size_t k = 0; k < width; ++k) {
        py::array_t<double> column({static_cast<py::ssize_t>(rows.cells.size())},
                                   {static_cast<py::ssize_t>(width * sizeof(double))},
                                   rows.cells.coordinates().data() + k, owner);
        column.attr("setflags")(py::arg("write") = false);
        columns[py::str(rows.names[k])] = column;
    }
    return columns;
}

/// The rows that were made, or that go with the curve.
py::dict rows_of(py::object self) {
    const Outcome& outcome = self.cast<const Made&>().outcome;
    if (const Rows* rows = std::get_if<Rows>(&outcome.output)) return columns_of(*rows, self);
    if (!outcome.rows) return {};
    auto* const rows = new Rows(outcome.rows());
    return columns_of(*rows, py::capsule(rows, [](void* p) { delete static_cast<Rows*>(p); }));
}

py::dict forms_of(const Made& made) {
    py::dict forms;
    for (const OutputForm& form : made.outcome.forms) {
        forms[py::str(form.name)] = py::cpp_function(form.text);
    }
    return forms;
}

/// The picture, or None where there is nothing to draw.
py::object picture_of(const Made& made) {
    return made.outcome.draw ? py::object(py::str(svg(made.outcome.draw()))) : py::none();
}

void bind_outcome(py::module_& module) {
    py::class_<Made>(module, "Outcome", "What an operation made, and how good it is.")
        .def_property_readonly("curve", &curve_of, "the curve, or None where none was made, or several")
        .def_property_readonly("curves", [](const Made& m) { return curve_list(curves_made(m)); },
                               "all curves that were made")
        .def_property_readonly("spline", &spline_made,
                               "the spline y(x), or None where none was made")
        .def_property_readonly("surface", &surface_of, "the surface, or None where none was made")
        .def_property_readonly("points", &points_of, "the rows, or None where none were made")
        .def_property_readonly("names", &names_of, "what the columns of the rows are called")
        .def_property_readonly(
            "status", [](const Made& m) { return std::string(name_of(m.outcome.status)); },
            "met, not_met, not_converged or rank_deficient")
        .def_property_readonly(
            "report", [](const Made& m) { return object_of(m.outcome.report); },
            "the report's numbers, by the keys of the report's file")
        .def_property_readonly(
            "options", [](const Made& m) { return object_of(m.outcome.options); },
            "the options as understood")
        .def_property_readonly("forms", &forms_of,
                               "functions that write the result for machines, by format")
        .def("rows", &rows_of, "the rows made, or those that go with a fit: a view of each column by its name")
        .def("draw", &picture_of, "what was done as an SVG picture")
        .def("_repr_svg_", &picture_of)
        .def("to_json",
             [](const Made& m) { return dump_json(envelope(*m.operation, m.outcome)); },
             "the report as the command line writes it")
        .def("__repr__", [](const Made& m) {
            return "<batten.Outcome of " + function_name(*m.operation) + ": " +
                   std::string(name_of(m.outcome.status)) + ">";
        });
}

py::array_t<double> read_points_file(const std::string& path, const std::string& columns) {
    auto* points = new Points(read_points(path, columns));
    const py::capsule owner(points, [](void* p) { delete static_cast<Points*>(p); });
    return view_of(*points, owner);
}

std::string stubs() {
    std::string text;
    for (const Operation& operation : operations()) text += '\n' + stub(operation);
    return text;
}

}  // namespace
}  // namespace batten::python

PYBIND11_MODULE(_core, module) {
    using namespace batten::python;
    pybind11::register_exception_translator(&translate);
    module.attr("__version__") = std::string(batten::version());
    bind_curve(module);
    bind_surface(module);
    bind_spline(module);
    bind_outcome(module);
    bind_chunk(module);
    module.def("read_points", &read_points_file, py::arg("path"), py::arg("columns") = "",
               "The points in a file of any format that the command line reads.");
    module.def("read_curve", &batten::read_curve, py::arg("path"),
               "The curve in a file of Batten or an SVG picture.");
    module.def("read_curves",
               [](const std::string& path) {
                   return curve_list(batten::parse_curves(batten::read_source(path)));
               },
               py::arg("path"), "All curves in a file, a list.");
    module.def("read_surface", [](const std::string& path) { return HeldSurface{batten::read_surface(path)}; },
               py::arg("path"), "The surface in a file of Batten.");
    module.def("_stubs", &stubs, "The operations as they stand in the stub file.");
    pybind11::options plain;
    plain.disable_function_signatures();
    for (const batten::Operation& operation : batten::operations()) {
        bind_operation(module, operation);
    }
    for (const char* name : {"Curve", "FitChunk", "Outcome", "Spline", "Surface"}) module.attr(name).attr("__module__") = "batten";
}
