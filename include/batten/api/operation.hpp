#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/progress.hpp"
#include "batten/base/shared.hpp"
#include "batten/base/value.hpp"
#include "batten/io/draw/drawing.hpp"
#include "batten/io/files.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/table.hpp"
#include "batten/make/fit_bands.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/surface.hpp"

/// Every operation as one row of one table: what the faces are made from.
namespace batten {

/// What an option takes.
enum class FieldKind {
    flag, number, integer, choice, text, tolerance, list, table, shape, errors
};

/// One option of an operation, as its `visit_fields` describes it.
struct Field {
    std::string name;  ///< words joined by `_`; a face may only change the joint
    FieldKind kind;
    std::string takes;  ///< what to type: `NUMBER`, `I:DEGREES`, `chord|uniform`, …
    std::string help;   ///< one sentence
    std::string default_text;
    Limits limits;
    std::vector<std::string> choices;
    bool takes_file = false;  ///< a file can be named where numbers are expected
    std::string bare = {};    ///< what the name alone means; empty: it needs a value
};

/// What can be given for an option: text as a person types it, or the thing itself.
using Argument = std::variant<std::string, std::vector<double>, Points, Curve>;

struct Setting {
    std::string name;
    Argument value;
};

/// A table, and the columns of it that are coordinates (none for operations that take a table); or
/// numbers in somebody's memory in place of the table's cells, which are not copied: the outcome
/// keeps their owner. A table without rows then has the names and the number of columns.
struct PointsInput {
    Table table;
    std::vector<int> columns;
    std::optional<SharedPoints> borrowed = {};     ///< rows
    std::vector<SharedNumbers> shared_columns = {};  ///< or one for each column of the table
};

/// What an operation works on. A grid is a table, rows or a picture: a file or its bytes, since the
/// options tell how to read them, or heights that are read.
enum class InputKind {
    points, curve, points_or_curve, table, none, grid, surface, curve_or_surface, any
};

/// What every face calls it.
constexpr std::array<Named<InputKind>, 9> names_of(InputKind) {
    return {{{"points", InputKind::points},
             {"curve", InputKind::curve},
             {"points_or_curve", InputKind::points_or_curve},
             {"table", InputKind::table},
             {"none", InputKind::none},
             {"grid", InputKind::grid},
             {"surface", InputKind::surface},
             {"curve_or_surface", InputKind::curve_or_surface},
             {"points_or_curve_or_surface", InputKind::any}}};
}

/// Whether an operation takes a curve, or a surface.
constexpr bool takes_curve(InputKind kind) {
    return kind == InputKind::curve || kind == InputKind::points_or_curve ||
           kind == InputKind::curve_or_surface || kind == InputKind::any;
}
constexpr bool takes_surface(InputKind kind) {
    return kind == InputKind::surface || kind == InputKind::curve_or_surface ||
           kind == InputKind::any;
}
/// Whether it takes rows of numbers.
constexpr bool takes_rows(InputKind kind) {
    return kind == InputKind::points || kind == InputKind::points_or_curve ||
           kind == InputKind::table || kind == InputKind::grid || kind == InputKind::any;
}

/// A file that is not read yet: larger than `most_bytes`, or to be read in blocks.
struct StoredFile {
    std::string path;
};

struct Input {
    std::string name;  ///< for errors and legends: the file's name, or what the caller calls it
    /// Several curves: an operation on one curve is done to each of them.
    std::variant<PointsInput, Curve, Source, GridFile, Surface, StoredFile, std::vector<Curve>>
        content;
};

/// Rows of named columns.
struct Rows {
    std::vector<std::string> names;
    Points cells;
};

/// What an operation makes: nothing but its report, a curve, rows, a picture, a surface, or curves and
/// rows of points on them.
enum class OutputKind { report, curve, rows, drawing, surface, curves };
using Output = std::variant<std::monostate, Curve, Rows, Drawing, Surface>;

/// A spline y(x) that was made, and how sure it is where that is known.
struct MadeSpline {
    SplineFunction spline;
    std::optional<FitCovariance> covariance = {};
};

/// One more form in which an output can be written, made only when somebody wants it.
struct OutputForm {
    std::string name;  ///< the suffix of its files
    std::function<std::string()> text;
};

struct Outcome {
    Output output;
    Status status = Status::met;
    Value options;  ///< as understood
    Value report;
    std::function<Drawing()> draw;  ///< makes the picture, only when somebody wants it
    std::vector<OutputForm> forms = {};  ///< beside those that every output of its kind has
    std::function<Rows()> rows = {};     ///< what is written for a curve where rows are asked for
    std::vector<Curve> curves = {};      ///< where it is not one that was made, or may be made
    std::optional<MadeSpline> spline = {};  ///< what the curve is the graph of, jumps and all
};

struct Operation {
    std::string_view name;
    std::string_view help;  ///< one line
    InputKind input;
    bool many_inputs;
    OutputKind output;
    std::vector<Field> fields;
    /// Runs it. Throws `Error` on bad input: `option.unknown`, `option.value`, `option.range`,
    /// `option.choice`, `input.kind`, and whatever the operation's own header says.
    /// Throws `Cancelled` where the progress is told to stop.
    std::function<Outcome(std::span<const Input>, const std::vector<Setting>&, const Progress&)>
        run;
    /// Throws what `run` would throw for these settings alone, whatever the inputs.
    std::function<void(const std::vector<Setting>&)> check = {};
    /// The forms in which its output can be written, by the suffix of their files; a curve or a
    /// surface of some kinds has not all of them.
    std::vector<std::string> forms = {};
};

/// All operations, in the order a person meets them.
const std::vector<Operation>& operations();

/// The operation of that name, or null.
const Operation* find_operation(std::string_view name);

/// The report's envelope: `{"batten": …, "operation": …, "status": …, "options": …, "report": …}`.
Value envelope(const Operation& operation, const Outcome& outcome);

/// The version of this library.
std::string_view version();

}  // namespace batten
