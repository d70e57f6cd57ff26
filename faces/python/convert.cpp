#include "convert.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

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

/// A masked array with NaN where it is masked; all else as it is.
py::object unmasked(py::handle object) {
    if (!py::hasattr(object, "filled")) return py::reinterpret_borrow<py::object>(object);
    return object.attr("astype")("float64").attr("filled")(std::nan(""));
}

PointsView view_of_rows(const Array& array, const std::string& name) {
    if (array.ndim() != 2 || array.shape(1) < 1) {
        throw Error("points.dimension", name, "an array of " + std::to_string(array.ndim()) +
                        " dimensions", "must be rows of coordinates");
    }
    return {array.data(), static_cast<std::size_t>(array.shape(0)),
            static_cast<int>(array.shape(1))};
}

std::vector<double> list_of(const Array& array) {
    return {array.data(), array.data() + array.size()};
}

Points column_of(const Array& array) { return Points(list_of(array), 1); }

Points points_from(py::handle object, const std::string& name) {
    const Array array = array_of(object);
    if (!array) throw Error("option.value", name, type_name(object), "must be rows of numbers");
    const Points points = array.ndim() == 1 ? column_of(array) : Points(view_of_rows(array, name));
    require_finite(points);
    return points;
}

void set_cell(Table& table, std::size_t row, std::size_t column, double x) {
    table.cells[row][column] =
        std::isfinite(x) ? x : table.mark_bad(column, x, {row, format_number(x)});
}

/// Keeps a Python object for those who know nothing of Python, on whatever thread they let it go.
std::shared_ptr<const void> keeper_of(py::object object) {
    return {new py::object(std::move(object)), [](const void* kept) {
                const py::gil_scoped_acquire lock;
                delete static_cast<const py::object*>(kept);
            }};
}

Table empty_table(const std::string& name, std::size_t columns) {
    Table table;
    table.source = name;
    table.cells = Points(0, static_cast<int>(columns));
    table.bad.resize(columns);
    return table;
}

PointsInput rows_input(const Array& array, const std::string& name) {
    const PointsView rows = view_of_rows(array, name);
    PointsInput input;
    input.table = empty_table(name, static_cast<std::size_t>(rows.dim()));
    input.borrowed = SharedPoints(rows, keeper_of(array));
    return input;
}

/// `{"x": …, "y": …}`: columns by name.
PointsInput columns_input(const py::dict& columns, const std::string& name) {
    PointsInput input;
    std::vector<std::string> names;
    for (const auto& [key, value] : columns) {
        names.push_back(py::str(key));
        const Array array = array_of(value);
        const auto size = array ? static_cast<std::size_t>(array.size()) : 0;
        if (!array || array.ndim() != 1 ||
            (!input.shared_columns.empty() && size != input.shared_columns.front().size())) {
            throw Error("table.ragged", name, names.back(),
                        "columns must be numbers, all equally many");
        }
        input.shared_columns.emplace_back(std::span(array.data(), size), keeper_of(array));
    }
    if (names.empty()) throw Error("table.columns", name, "none", "must have columns");
    input.table = empty_table(name, names.size());
    input.table.names = std::move(names);
    return input;
}

/// As a table of its own, where points are wanted from columns.
Table table_of(const PointsInput& input) {
    Table table = input.table;
    const auto& columns = input.shared_columns;
    table.cells = Points(columns.front().size(), table.columns());
    for (std::size_t k = 0; k < columns.size(); ++k) {
        for (std::size_t row = 0; row < table.cells.size(); ++row) {
            set_cell(table, row, k, columns[k][row]);
        }
    }
    return table;
}

/// f[x][y], a masked array or NaN where nodes are missing.
GridFile grid_of(const Array& heights, const std::string& name) {
    const auto rows = static_cast<std::size_t>(heights.shape(0));
    const auto columns = static_cast<std::size_t>(heights.shape(1));
    Grid z(rows, columns);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            const double value = heights.data()[i * columns + j];
            if (std::isnan(value)) {
                z.drop(i, j);
            } else if (std::isinf(value)) {
                throw Error("grid.cell", name + " [" + std::to_string(i) + "][" +
                                             std::to_string(j) + "]",
                            "inf", "a height must be a finite number or NaN");
            } else {
                z(i, j) = value;
            }
        }
    }
    return counted_grid(std::move(z), name);
}

/// The columns as a file has them.
std::string text_of(const PointsInput& input) {
    const std::vector<std::string>& names = input.table.names;
    std::string text;
    const auto next = [&](std::size_t k) { return k + 1 < names.size() ? ',' : '\n'; };
    for (std::size_t k = 0; k < names.size(); ++k) text += names[k] + next(k);
    for (std::size_t i = 0; i < input.shared_columns.front().size(); ++i) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            text += format_number(input.shared_columns[k][i]) + next(k);
        }
    }
    return text;
}

/// Points p[u][v] of three coordinates, as rows u, v, x, y, z of a file; lines count from 0.
std::string text_of_nodes(const Array& nodes) {
    std::string text = "u,v,x,y,z\n";
    const auto columns = nodes.shape(1);
    for (py::ssize_t i = 0; i < nodes.shape(0); ++i) {
        for (py::ssize_t j = 0; j < columns; ++j) {
            text += std::to_string(i) + ',' + std::to_string(j);
            for (py::ssize_t k = 0; k < 3; ++k) {
                text += ',' + format_number(nodes.data()[(i * columns + j) * 3 + k]);
            }
            text += '\n';
        }
    }
    return text;
}

/// Heights, points of three coordinates, or columns by name as in a file.
Input grid_input(py::handle object, const std::string& name) {
    if (py::isinstance<py::dict>(object)) {
        const auto columns = py::reinterpret_borrow<py::dict>(object);
        return {name, Source{name, text_of(columns_input(columns, name))}};
    }
    const Array heights = array_of(unmasked(object));
    if (heights && heights.ndim() == 3 && heights.shape(2) == 3) {
        return {name, Source{name, text_of_nodes(heights)}};
    }
    if (!heights || heights.ndim() != 2) {
        throw Error("input.kind", name, type_name(object), "must be a table of heights f[x][y]");
    }
    return {name, grid_of(heights, name)};
}

/// An array without dimensions, which is its number.
bool is_single(py::handle object) { return py::reinterpret_borrow<py::array>(object).ndim() == 0; }

bool is_curve_list(py::handle object) {
    if (!py::isinstance<py::list>(object) || py::len(object) == 0) return false;
    for (const py::handle each : object) {
        if (!py::isinstance<Curve>(each)) return false;
    }
    return true;
}

/// `made.curves`, or others.
Input curves_input(const py::list& list, const std::string& name) {
    std::vector<Curve> curves;
    for (const py::handle each : list) curves.push_back(each.cast<const Curve&>());
    if (curves.size() == 1) return {name, std::move(curves.front())};
    return {name, std::move(curves)};
}

}  // namespace

Input input_from(const Operation& operation, py::handle object, const std::string& name) {
    if (py::isinstance<Curve>(object)) return {name, object.cast<const Curve&>()};
    if (py::isinstance<HeldSurface>(object)) {
        return {name, object.cast<const HeldSurface&>().surface};
    }
    if (py::isinstance<Made>(object)) {
        return input_of(object.cast<const Made&>().outcome, name, operation);
    }
    if (operation.input == InputKind::grid) return grid_input(object, name);
    const bool takes_table = operation.input == InputKind::table;
    if (py::isinstance<py::dict>(object)) {
        PointsInput columns = columns_input(py::reinterpret_borrow<py::dict>(object), name);
        return takes_table ? Input{name, std::move(columns)}
                           : input_of(table_of(columns), operation);
    }
    if (is_curve_list(object)) return curves_input(py::reinterpret_borrow<py::list>(object), name);
    const Array array = array_of(object);
    if (!array) throw Error("input.kind", name, type_name(object), "must be points, a curve or a surface");
    return {name, rows_input(array, name)};
}

Argument argument_from(const Field& field, py::handle object) {
    if (py::isinstance<Curve>(object)) return object.cast<const Curve&>();
    if (py::isinstance<Made>(object)) {
        return argument_of(object.cast<const Made&>().outcome, field.name);
    }
    const bool takes_rows = field.kind == FieldKind::table || field.kind == FieldKind::shape;
    if (takes_rows && !py::isinstance<py::str>(object)) return points_from(object, field.name);
    if (field.kind == FieldKind::errors && !py::isinstance<py::str>(object)) {
        // Not looked at here: an error may be infinite, or missing where the height is.
        const Array errors = array_of(unmasked(object));
        if (errors && errors.ndim() == 1) return list_of(errors);
        if (errors && errors.ndim() == 2) return Points(view_of_rows(errors, field.name));
    }
    const bool takes_numbers = field.takes_file || field.kind == FieldKind::choice;
    if (takes_numbers && py::isinstance<py::array>(object) && !is_single(object)) {
        const Array array = array_of(object);
        if (array && array.ndim() == 1) return list_of(array);
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
