#include "batten/io/surface_file.hpp"

#include "batten/base/error.hpp"
#include "batten/io/json.hpp"

namespace batten {
namespace {

constexpr const char* surface_format = "batten.surface/1";

Value list_of(std::span<const double> numbers) { return ValueList(numbers.begin(), numbers.end()); }

Error wrong_entry(const std::string& place, const char* key, const char* rule) {
    return {"surface.entry", place + ", entry " + key, "missing or of another kind", rule};
}

std::vector<double> numbers_of(const Value* value, const std::string& place, const char* key) {
    if (!value || !value->list()) throw wrong_entry(place, key, "a list of numbers is needed here");
    std::vector<double> numbers;
    for (const Value& entry : *value->list()) {
        if (!entry.is_number()) throw wrong_entry(place, key, "a list of numbers is needed here");
        numbers.push_back(entry.number());
    }
    return numbers;
}

int degree_of(const Value& tree, const std::string& place, const char* key) {
    const Value* degree = tree.find(key);
    if (!degree || !degree->integer() || *degree->integer() < 0 || *degree->integer() > 1000) {
        throw wrong_entry(place, key, "a whole number is needed here");
    }
    return static_cast<int>(*degree->integer());
}

BSplineBasis basis_of(const Value& tree, const std::string& place, const char* degree_key,
                      const char* knots_key) {
    return {numbers_of(tree.find(knots_key), place, knots_key),
            degree_of(tree, place, degree_key)};
}

Value lines_value(std::span<const SplineFunction> lines) {
    ValueList list;
    for (const SplineFunction& line : lines) {
        list.push_back(ValueMap{{"degree", line.degree()},
                                {"knots", list_of(line.knots())},
                                {"coefficients", list_of(line.coefficients())}});
    }
    return list;
}

std::vector<SplineFunction> lines_from(const Value& tree, const std::string& place,
                                       const char* key) {
    const Value* list = tree.find(key);
    if (!list || !list->list()) throw wrong_entry(place, key, "a list of lines is needed here");
    std::vector<SplineFunction> lines;
    for (const Value& line : *list->list()) {
        lines.emplace_back(numbers_of(line.find("knots"), place, key),
                           numbers_of(line.find("coefficients"), place, key),
                           degree_of(line, place, "degree"));
    }
    return lines;
}

}  // namespace

Value surface_value(const SplineSurface& surface, const std::string& name) {
    ValueMap map{{"format", surface_format}, {"kind", "b-spline-graph"}};
    if (!name.empty()) map.emplace_back("name", name);
    map.emplace_back("degree_x", surface.x_basis().degree());
    map.emplace_back("degree_y", surface.y_basis().degree());
    map.emplace_back("knots_x", list_of(surface.x_basis().knots()));
    map.emplace_back("knots_y", list_of(surface.y_basis().knots()));
    ValueList rows;
    const std::size_t width = surface.y_basis().size();
    for (std::size_t i = 0; i < surface.x_basis().size(); ++i) {
        rows.emplace_back(list_of(surface.coefficients().subspan(i * width, width)));
    }
    map.emplace_back("coefficients", std::move(rows));
    return map;
}

SplineSurface surface_of(const Value& tree, const std::string& place) {
    const Value* format = tree.find("format");
    const Value* kind = tree.find("kind");
    const auto is = [](const Value* value, const char* text) {
        return value && value->text() && *value->text() == text;
    };
    if (!is(format, surface_format) || !is(kind, "b-spline-graph")) {
        throw Error("surface.format", place, "another format or kind",
                    std::string("a surface is a map with \"format\": \"") + surface_format +
                        "\" and \"kind\": \"b-spline-graph\"");
    }
    BSplineBasis x = basis_of(tree, place, "degree_x", "knots_x");
    BSplineBasis y = basis_of(tree, place, "degree_y", "knots_y");
    const Value* rows = tree.find("coefficients");
    if (!rows || !rows->list()) {
        throw wrong_entry(place, "coefficients", "a list of rows is needed here");
    }
    std::vector<double> coefficients;
    for (const Value& row : *rows->list()) {
        const std::vector<double> numbers = numbers_of(&row, place, "coefficients");
        if (numbers.size() != y.size()) {
            throw wrong_entry(place, "coefficients", "as many numbers a row as splines in y");
        }
        coefficients.insert(coefficients.end(), numbers.begin(), numbers.end());
    }
    return {std::move(x), std::move(y), std::move(coefficients)};
}

Value surface_value(const CurvedKnotSurface& surface, const std::string& name) {
    ValueMap map{{"format", surface_format}, {"kind", "curved-knots"}};
    if (!name.empty()) map.emplace_back("name", name);
    const Rectangle& d = surface.domain();
    map.emplace_back("degree", surface.degree());
    map.emplace_back("domain", ValueList{d.x.lo, d.x.hi, d.y.lo, d.y.hi});
    map.emplace_back("lines_x", lines_value(surface.x_lines()));
    map.emplace_back("lines_y", lines_value(surface.y_lines()));
    map.emplace_back("coefficients", list_of(surface.coefficients()));
    return map;
}

CurvedKnotSurface curved_surface_of(const Value& tree, const std::string& place) {
    const Value* format = tree.find("format");
    const Value* kind = tree.find("kind");
    const bool is_known = format && format->text() && *format->text() == surface_format && kind &&
                          kind->text() && *kind->text() == "curved-knots";
    if (!is_known) {
        throw Error("surface.format", place, "another format or kind",
                    "a surface with curved knot lines has the kind curved-knots");
    }
    const std::vector<double> domain = numbers_of(tree.find("domain"), place, "domain");
    if (domain.size() != 4) throw wrong_entry(place, "domain", "four numbers are needed here");
    return {degree_of(tree, place, "degree"), {{domain[0], domain[1]}, {domain[2], domain[3]}},
            lines_from(tree, place, "lines_x"), lines_from(tree, place, "lines_y"),
            numbers_of(tree.find("coefficients"), place, "coefficients")};
}

Value surface_value(const Surface& surface, const std::string& name) {
    return std::visit([&](const auto& each) { return surface_value(each, name); }, surface);
}

bool is_surface(const Value& tree) {
    const Value* format = tree.find("format");
    return format && format->text() && format->text()->rfind("batten.surface/", 0) == 0;
}

bool holds_surface(const Source& source) {
    // The format is the first entry of what is written; other orders are found as well.
    return source.bytes.find("\"batten.surface/") != std::string::npos;
}

Surface any_surface_of(const Value& tree, const std::string& place) {
    const Value* kind = tree.find("kind");
    if (kind && kind->text() && *kind->text() == "curved-knots") {
        return curved_surface_of(tree, place);
    }
    return surface_of(tree, place);
}

Surface parse_surface(const Source& source) {
    if (source.bytes.find('{') == std::string::npos) {
        throw Error("surface.format", source.name, "no map", "a surface is a JSON file");
    }
    return any_surface_of(parse_json(source.bytes, source.name), source.name);
}

Surface read_surface(const std::string& path) { return parse_surface(read_source(path)); }

}  // namespace batten
