#pragma once

#include <string>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/base/value.hpp"

namespace batten {

/// What a tree, such as a job's entry or a value of Python's, means for an option: a truth, a
/// number or a text as it would be typed; lists of numbers, and of rows of them, as they are; rows
/// as points and a `batten.curve/1` tree as a curve, where the option takes these.
///
/// Throws `option.value` where the option takes nothing of this kind, and for rows and curves what
/// parse_table and curve_of throw. The value itself is checked by the operation.
Argument argument_of(const Field& field, const Value& value);

/// The columns of `table` that an option takes: all of them where it takes a table, else the
/// coordinates. Throws what coordinate_columns throws.
std::vector<int> columns_for(const Field& field, const Table& table);

/// The columns of `table` to lay beside a curve: beside a graph y(x) those that a fit of y(x) would
/// take, beside others x, y and z, as many as the curve has coordinates, else the coordinates.
/// Throws what coordinate_columns throws.
std::vector<int> columns_beside(const Curve& curve, const Table& table);

/// Rows of numbers, or a `batten.curve/1` tree, as an input of the operation, called `name`. The
/// coordinates are the columns that `picks` names (coordinate_columns); an operation on tables
/// finds its columns itself where nothing is picked. Throws what the readers of files throw.
Input input_of(const Value& value, const std::string& name, const Operation& operation,
               const std::string& picks = {});

/// A table as an input of the operation, in the same way.
Input input_of(Table table, const Operation& operation, const std::string& picks = {});

/// What an operation made, as the input of another: its curves where that takes any, else its rows
/// or its surface. Throws `job.input` where it made none of these, and what coordinate_columns
/// throws.
Input input_of(const Outcome& made, const std::string& name, const Operation& operation,
               const std::string& picks = {});

/// The same for an option. Throws `job.input` where it made neither rows nor a curve,
/// `curve.several` where it made more curves than one.
Argument argument_of(const Outcome& made, const std::string& name);

}  // namespace batten
