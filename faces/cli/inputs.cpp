#include "inputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>

#include "batten/api/argument.hpp"
#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/curve_file.hpp"
#include "batten/io/files.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/table.hpp"
#include "usage.hpp"
#include "vocabulary.hpp"

namespace batten::cli {
namespace {

/// Whether the text is a number, or one with `r` behind it: a share.
bool is_number(std::string_view text) {
    text = trimmed(text);
    if (!text.empty() && text.back() == 'r') text.remove_suffix(1);
    return parse_number(text).has_value();
}

/// Whether the text is a list of numbers as typed.
bool is_list(const std::string& text) {
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find(',', start), text.size());
        if (!is_number(std::string_view(text).substr(start, end - start))) return false;
        start = end + 1;
    }
    return true;
}

/// The lines of a file, one number each, some of them shares, as they would be typed; or nothing
/// where the file is something else.
std::optional<std::string> listed_shares(const Source& source) {
    std::string list;
    bool holds_shares = false;
    for (std::size_t start = 0; start < source.bytes.size();) {
        const std::size_t end = std::min(source.bytes.find('\n', start), source.bytes.size());
        const std::string_view line =
            trimmed(std::string_view(source.bytes).substr(start, end - start));
        start = end + 1;
        if (line.empty() || line.front() == '#') continue;
        if (!is_number(line)) return std::nullopt;
        holds_shares = holds_shares || line.back() == 'r';
        list += (list.empty() ? "" : ",") + std::string(line);
    }
    if (!holds_shares) return std::nullopt;
    return list;
}

bool is_choice(const Field& field, const std::string& text) {
    return std::find(field.choices.begin(), field.choices.end(), text) != field.choices.end();
}

/// Whether a sibling list `x_values` stands beside the choice `x`.
bool takes_column(const Operation& operation, const Field& field) {
    return std::any_of(operation.fields.begin(), operation.fields.end(), [&](const Field& other) {
        return other.name == field.name + "_values";
    });
}

std::vector<double> numbers_in(const std::string& list) {
    std::vector<double> numbers;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t end = std::min(list.find(',', start), list.size());
        numbers.push_back(*parse_number(std::string_view(list).substr(start, end - start)));
        start = end + 1;
    }
    return numbers;
}

/// A curve, or points that are laid beside the curve of the input.
Argument read_shape(const std::string& path, const std::vector<Input>& inputs) {
    const Source source = read_source(path);
    if (holds_curve(source)) return parse_curve(source);
    const Table table = parse_table(source);
    const Curve* curve = inputs.empty() ? nullptr : std::get_if<Curve>(&inputs.front().content);
    Points points = points_of(table, curve ? columns_beside(*curve, table)
                                           : coordinate_columns(table));
    try {
        if (curve) require_dimension(points, curve->dim(), curve->dim());
    } catch (const Error& error) {
        throw error.at(source.name);
    }
    return points;
}

Argument read_numbers(const std::string& path, const Field& field) {
    const Source source = read_source(path);
    if (const std::optional<std::string> list = listed_shares(source)) return *list;
    const Table table = parse_table(source);
    return table.columns() == 1 ? Argument(column_values(table, 0))
                                : Argument(points_of(table, columns_for(field, table)));
}

bool is_flag_set(const Command& command, const char* name) {
    return std::any_of(command.options.begin(), command.options.end(), [&](const auto& option) {
        return option.first->name == name && option.second == "true";
    });
}

/// Whether a grid or a table stays where it is: asked for by `--stream`, or larger than what is read whole.
bool stays_stored(const std::string& path, const Command& command) {
    const InputKind kind = command.operation->input;
    if ((kind != InputKind::grid && kind != InputKind::table) || path == "-") return false;
    if (is_flag_set(command, "stream")) return true;
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    return !error && size > most_bytes;
}

}  // namespace

Input read_input(const std::string& path, const Command& command) {
    if (stays_stored(path, command)) return {path, StoredFile{path}};
    Source source = read_source(path);
    const InputKind kind = command.operation->input;
    const auto refuse = [&](const char* what, const char* takes) {
        throw Error("input.kind", source.name, what,
                    std::string(command.operation->name) + " takes " + takes);
    };
    if (holds_surface(source)) {
        if (!takes_surface(kind)) refuse("a surface", takes_curve(kind) ? "a curve" : "points");
        return {source.name, parse_surface(source)};
    }
    if (kind == InputKind::surface) {
        // Read it all the same: what is wrong with the file comes before what it is for.
        parse_surface(source);
    }
    const bool is_curve = holds_curve(source);
    if (kind == InputKind::grid) {
        if (is_curve) refuse("a curve", "a grid of heights");
        std::string name = source.name;
        return {std::move(name), std::move(source)};
    }
    if (is_curve && !takes_curve(kind)) refuse("a curve", "points");
    if (!is_curve && !takes_rows(kind)) {
        // Read it all the same: what is wrong with the file comes before what it is for.
        parse_table(source);
        throw Error("input.kind", source.name, "points",
                    std::string(command.operation->name) +
                        " takes a curve; `batten interpolate` makes one");
    }
    if (is_curve) {
        std::vector<Curve> curves = parse_curves(source);
        if (curves.size() == 1) return {source.name, std::move(curves.front())};
        return {source.name, std::move(curves)};
    }
    const Table table = parse_table(source);
    if (kind == InputKind::table && command.columns.empty()) {
        return {source.name, PointsInput{table, {}}};
    }
    return {source.name, PointsInput{table, coordinate_columns(table, command.columns)}};
}

/// The place of a column, where the text is nothing else that the option takes.
int column_named(const Table& table, const Field& field, const std::string& text) {
    try {
        return column_index(table, text);
    } catch (const Error& error) {
        if (error.code() != "table.unknown-column") throw;
        const bool is_choice = !field.choices.empty();
        throw Error(error.code(), error.place(), error.value(),
                    error.rule() + "; --" + flag_name(field.name) + " also takes " +
                        (is_choice ? field.takes + ", numbers" : "a number") +
                        " or a file of them, and there is no such file" +
                        guess(text, field.choices));
    }
}

bool is_column(const std::vector<Input>& inputs, const std::string& text) {
    const auto* points = inputs.empty() ? nullptr : std::get_if<PointsInput>(&inputs.front().content);
    if (!points) return false;
    const std::vector<std::string>& names = points->table.names;
    return text.starts_with('#') || std::find(names.begin(), names.end(), text) != names.end();
}

/// Whether the lines of the grid of heights fall in its file, in x and in y.
std::array<bool, 2> turned_lines(const std::vector<Input>& inputs) {
    const auto* source = inputs.empty() ? nullptr : std::get_if<Source>(&inputs.front().content);
    if (!source || grid_format(*source) != GridFormat::text) return {false, false};
    const GridFile heights = parse_grid(*source);
    return {heights.x_is_turned, heights.y_is_turned};
}

/// The errors of a grid's nodes in the order of the heights' file, NaN where there is none. Those
/// with places of their own are read rising.
Points errors_on_grid(const std::string& path, const std::vector<Input>& inputs) {
    const Source source = read_source(path);
    const GridFile grid = parse_grid(source);
    const bool has_places = grid_format(source) == GridFormat::text;
    const auto [turns_x, turns_y] =
        has_places ? turned_lines(inputs) : std::array<bool, 2>{false, false};
    const std::size_t nu = grid.z.nu(), nv = grid.z.nv();
    Points rows(nu, static_cast<int>(nv));
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            const std::size_t r = turns_x ? nu - 1 - i : i, s = turns_y ? nv - 1 - j : j;
            rows[i][j] = grid.z.has(r, s) ? grid.z(r, s) : std::numeric_limits<double>::quiet_NaN();
        }
    }
    return rows;
}

/// A number, a column of the input, or else a file.
Argument errors_of(const Command& command, const Field& field, const std::string& text,
                   const std::vector<Input>& inputs) {
    if (is_number(text) || is_column(inputs, text)) return text;
    const bool is_grid =
        command.operation->input == InputKind::grid && !is_flag_set(command, "scattered");
    if (is_grid) return errors_on_grid(text, inputs);
    if (!std::filesystem::is_regular_file(text)) {
        const auto* points =
            inputs.empty() ? nullptr : std::get_if<PointsInput>(&inputs.front().content);
        if (points) column_named(points->table, field, text);
        return text;
    }
    const Table table = read_table(text);
    return column_errors(table, column_index(table, "#1"));
}

Argument argument_of(const Command& command, const Field& field, const std::string& text,
                     const std::vector<Input>& inputs) {
    switch (field.kind) {
        case FieldKind::shape: return read_shape(text, inputs);
        case FieldKind::table: return read_numbers(text, field);
        case FieldKind::errors: return errors_of(command, field, text, inputs);
        case FieldKind::list:
            if (field.takes_file && !is_list(text)) return read_numbers(text, field);
            return text;
        case FieldKind::choice:
            if (!is_choice(field, text) && takes_column(*command.operation, field)) {
                if (is_list(text)) return numbers_in(text);
                if (std::filesystem::is_regular_file(text)) return read_numbers(text, field);
                if (const auto* points = std::get_if<PointsInput>(&inputs.front().content)) {
                    return column_values(points->table,
                                         column_named(points->table, field, text));
                }
            }
            return text;
        default: return text;
    }
}

std::vector<Input> read_inputs(const Command& command) {
    std::vector<Input> inputs;
    for (const std::string& path : command.inputs) inputs.push_back(read_input(path, command));
    return inputs;
}

std::vector<Setting> read_settings(const Command& command, const std::vector<Input>& inputs) {
    std::vector<Setting> settings;
    for (const auto& [field, text] : command.options) {
        settings.push_back({field->name, argument_of(command, *field, text, inputs)});
    }
    return settings;
}

}  // namespace batten::cli
