#include "convert.hpp"

#include <algorithm>
#include <cmath>

#include "batten/api/argument.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::python {
namespace {

std::string type_name(py::handle object) {
    return py::str(py::type::handle_of(object).attr("__name__"));
}

/// A tree from Python's own kinds, and from NumPy's scalars and arrays.
Value value_from(py::handle object, const std::string& place) {
    if (object.is_none()) return {};
    if (py::isinstance<py::bool_>(object) || type_name(object) == "bool_") {
        return object.cast<bool>();
    }
    if (PyIndex_Check(object.ptr()) && !py::isinstance<py::array>(object)) {
        return object.cast<long long>();
    }
    if (py::isinstance<py::str>(object)) return object.cast<std::string>();
    if (py::isinstance<py::array>(object)) return value_from(object.attr("tolist")(), place);
    if (py::isinstance<py::dict>(object)) {
        // {0: 90} as 0:90, the way it is typed.
        ValueList pairs;
        for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(object)) {
            const std::string text = py::str(value);
            pairs.push_back(std::string(py::str(key)) + ':' + text);
        }
        return pairs;
    }
    if (py::isinstance<py::sequence>(object)) {
        ValueList list;
        for (const py::handle each : object) list.push_back(value_from(each, place));
        return list;
    }
    if (PyNumber_Check(object.ptr())) return py::float_(py::reinterpret_borrow<py::object>(object)).cast<double>();
    throw Error("option.value", place, type_name(object), "must be numbers, texts or lists of them");
}

/// The array that an object is, or an empty handle where it is none.
Array array_of(py::handle object) {
    Array array = Array::ensure(object);
    if (!array) PyErr_Clear();
    return array;
}

PointsView view_of_rows(const Array& array, const std::string& name) {
    if (array.ndim() != 2 || array.shape(1) < 1) {
        throw Error("points.dimension", name, "an array of " + std::to_string(array.ndim()) +
                        " dimensions", "must be rows of coordinates");
    }
    return {array.data(), static_cast<std::size_t>(array.shape(0)),
            static_cast<int>(array.shape(1))};
}

Points column_of(const Array& array) {
    return Points(std::vector<double>(array.data(), array.data() + array.size()), 1);
}

Points points_from(py::handle object, const std::string& name) {
    const Array array = array_of(object);
    if (!array) throw Error("option.value", name, type_name(object), "must be rows of numbers");
    const Points points = array.ndim() == 1 ? column_of(array) : Points(view_of_rows(array, name));
    require_finite(points);
    return points;
}

void set_cell(Table& table, std::size_t row, std::size_t column, double x) {
    const bool is_infinite = std::isinf(x) && x > 0;
    if (!std::isfinite(x)) note_bad(table.bad[column], {row, format_number(x), is_infinite});
    table.cells[row][column] = std::isfinite(x) || is_infinite ? x : 0;
}

Table empty_table(const std::string& name, std::size_t rows, std::size_t columns) {
    Table table;
    table.source = name;
    table.cells = Points(rows, static_cast<int>(columns));
    table.bad.resize(columns);
    return table;
}

Table table_of(PointsView rows, const std::string& name) {
    const auto columns = static_cast<std::size_t>(rows.dim());
    Table table = empty_table(name, rows.size(), columns);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        for (std::size_t k = 0; k < columns; ++k) set_cell(table, row, k, rows[row][k]);
    }
    return table;
}

/// `{"x": …, "y": …}`: columns by name.
Table table_of(const py::dict& columns, const std::string& name) {
    std::vector<Array> arrays;
    std::vector<std::string> names;
    for (const auto& [key, value] : columns) {
        names.push_back(py::str(key));
        arrays.push_back(array_of(value));
        if (!arrays.back() || arrays.back().ndim() != 1 ||
            arrays.back().size() != arrays.front().size()) {
            throw Error("table.ragged", name, names.back(),
                        "columns must be numbers, all equally many");
        }
    }
    if (arrays.empty()) throw Error("table.columns", name, "none", "must have columns");
    Table table = empty_table(name, static_cast<std::size_t>(arrays.front().size()), arrays.size());
    table.names = names;
    for (std::size_t k = 0; k < arrays.size(); ++k) {
        for (std::size_t row = 0; row < table.cells.size(); ++row) {
            set_cell(table, row, k, arrays[k].data()[row]);
        }
    }
    return table;
}

}  // namespace

void add_input(Inputs& all, const Operation& operation, py::handle object,
               const std::string& name) {
    if (py::isinstance<Curve>(object)) {
        all.inputs.push_back({name, object.cast<const Curve&>()});
    } else if (py::isinstance<Made>(object)) {
        all.inputs.push_back(input_of(object.cast<const Made&>().outcome.output, name, operation));
    } else if (py::isinstance<py::dict>(object)) {
        all.inputs.push_back(
            input_of(table_of(py::reinterpret_borrow<py::dict>(object), name), operation));
    } else {
        Array array = array_of(object);
        if (!array) throw Error("input.kind", name, type_name(object), "must be points or a curve");
        const PointsView rows = view_of_rows(array, name);
        if (operation.input == InputKind::table) {
            all.inputs.push_back(input_of(table_of(rows, name), operation));
        } else {
            PointsInput borrowed;
            borrowed.table.source = name;
            borrowed.borrowed = rows;
            all.inputs.push_back({name, std::move(borrowed)});
        }
        all.owners.push_back(std::move(array));
    }
}

Argument argument_from(const Field& field, py::handle object) {
    if (py::isinstance<Curve>(object)) return object.cast<const Curve&>();
    if (py::isinstance<Made>(object)) {
        const Output& output = object.cast<const Made&>().outcome.output;
        if (const Curve* curve = std::get_if<Curve>(&output)) return *curve;
        if (const Rows* rows = std::get_if<Rows>(&output)) return rows->cells;
    }
    const bool takes_rows = field.kind == FieldKind::table || field.kind == FieldKind::shape;
    if (takes_rows && !py::isinstance<py::str>(object)) return points_from(object, field.name);
    const bool takes_numbers = field.takes_file || field.kind == FieldKind::choice;
    if (takes_numbers && py::isinstance<py::array>(object)) {
        const Array array = array_of(object);
        if (array && array.ndim() == 1) {
            return std::vector<double>(array.data(), array.data() + array.size());
        }
        return points_from(object, field.name);
    }
    return argument_of(field, value_from(object, field.name));
}

py::object object_of(const Value& value) {
    if (value.is_null()) return py::none();
    if (const bool* truth = value.truth()) return py::bool_(*truth);
    if (const long long* whole = value.integer()) return py::int_(*whole);
    if (const double* real = value.real()) return py::float_(*real);
    if (const std::string* text = value.text()) return py::str(*text);
    if (const ValueList* list = value.list()) {
        py::list result;
        for (const Value& each : *list) result.append(object_of(each));
        return result;
    }
    py::dict result;
    for (const auto& [key, each] : *value.map()) result[py::str(key)] = object_of(each);
    return result;
}

py::array_t<double> view_of(PointsView points, py::handle owner) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()),
                               static_cast<py::ssize_t>(points.dim())},
                              points.coordinates().data(), owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

}  // namespace batten::python
