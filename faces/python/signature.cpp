#include "signature.hpp"

#include <algorithm>
#include <array>

#include "batten/base/text.hpp"

namespace batten::python {
namespace {

/// Python's reserved words in lower case.
constexpr std::array<std::string_view, 32> reserved{
    "and",  "as",   "assert", "async",  "await",  "break",    "class", "continue",
    "def",  "del",  "elif",   "else",   "except", "finally",  "for",   "from",
    "global", "if", "import", "in",     "is",     "lambda",   "nonlocal", "not",
    "or",   "pass", "raise",  "return", "try",    "while",    "with",  "yield"};

std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + '\'';
}

std::string default_of(const Field& field) {
    if (field.kind == FieldKind::flag) return "False";
    if (field.default_text.empty()) return "None";
    const bool is_number = field.kind != FieldKind::text && parse_number(field.default_text);
    return is_number ? field.default_text : quoted(field.default_text);
}

std::string words_of(const Field& field, const char* joint) {
    std::string words;
    for (const std::string& word : field.choices) words += (words.empty() ? "" : joint) + quoted(word);
    return words;
}

std::string type_of(const Field& field) {
    switch (field.kind) {
        case FieldKind::flag: return "bool";
        case FieldKind::integer: return "int | None";
        case FieldKind::number: return "float | None";
        case FieldKind::text: return "str | None";
        case FieldKind::tolerance: return "float | str | None";
        case FieldKind::choice: return "Literal[" + words_of(field, ", ") + "] | ArrayLike | None";
        case FieldKind::list: return "ArrayLike | str | Mapping[int, float] | None";
        case FieldKind::table: return "ArrayLike | None";
        case FieldKind::errors: return "ArrayLike | str | None";
        case FieldKind::shape: return "ArrayLike | Curve | Outcome | None";
    }
    return "object";
}

std::string input_type(const Operation& operation) {
    const InputKind kind = operation.input;
    if (kind == InputKind::curve) return "Curve | Outcome";
    if (kind == InputKind::surface) return "Surface | Outcome";
    if (kind == InputKind::curve_or_surface) return "Curve | Surface | Outcome";
    if (kind == InputKind::any) return "ArrayLike | Curve | Surface | Outcome | Mapping[str, ArrayLike]";
    if (kind == InputKind::grid) return "ArrayLike | Outcome | Mapping[str, ArrayLike]";
    if (kind == InputKind::points || kind == InputKind::table) return "ArrayLike | Outcome | Mapping[str, ArrayLike]";
    return "ArrayLike | Curve | Outcome | Mapping[str, ArrayLike]";
}

std::string arguments_of(const Operation& operation, bool typed) {
    const std::string input = input_name(operation);
    std::string text;
    if (operation.many_inputs) {
        text = '*' + input + (typed ? ": " + input_type(operation) : "");
    } else if (!input.empty()) {
        text = input + (typed ? ": " + input_type(operation) : "") + ", /, *";
    } else {
        text = "*";
    }
    for (const Field& field : operation.fields) {
        text += ", " + keyword_name(field.name);
        text += typed ? ": " + type_of(field) + " = " : "=";
        text += typed && field.kind != FieldKind::flag ? "..." : default_of(field);
    }
    return text + (typed ? ", progress: Callable[[float], object] | None = None"
                         : ", progress=None");
}

std::string option_text(const Field& field) {
    std::string text = keyword_name(field.name) + "\n    " + field.help;
    if (!field.choices.empty()) text += ": " + words_of(field, ", ");
    return text + '\n';
}

}  // namespace

std::string keyword_name(const std::string& field) {
    const bool is_reserved = std::find(reserved.begin(), reserved.end(), field) != reserved.end();
    return is_reserved ? field + '_' : field;
}

std::string function_name(const Operation& operation) {
    std::string name(operation.name);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::string input_name(const Operation& operation) {
    return operation.input == InputKind::none ? "" : std::string(name_of(operation.input));
}

std::string docstring(const Operation& operation) {
    std::string text = function_name(operation) + '(' + arguments_of(operation, false) +
                       ")\n--\n\n" + std::string(operation.help) + "\n\nReturns an Outcome.\n";
    if (!operation.fields.empty()) text += "\nOptions\n-------\n";
    for (const Field& field : operation.fields) text += option_text(field);
    return text + "progress\n    called now and then with the share that is done; False stops\n";
}

std::string stub(const Operation& operation) {
    return "def " + function_name(operation) + '(' + arguments_of(operation, true) +
           ") -> Outcome:\n    \"\"\"" + std::string(operation.help) + "\"\"\"\n";
}

}  // namespace batten::python
