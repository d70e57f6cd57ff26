#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "batten/io/dxf.hpp"

/// The skeleton of a DXF file: pairs of group code and value, sections, tables.
namespace batten::dxf_file {

/// Collects pairs of lines: a group code and its value [Autodesk1999, "Group Codes"].
class Pairs {
public:
    Pairs& add(int code, std::string_view text);
    Pairs& add(int code, int number) { return add(code, std::to_string(number)); }
    Pairs& add(int code, std::size_t number) { return add(code, std::to_string(number)); }
    /// In the shortest form. Throws `number.overflow` unless it is finite.
    Pairs& add(int code, double number);
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// A handle: a number of its own for everything in the file, in hexadecimal.
class Handles {
public:
    std::string next();

private:
    unsigned last_ = 0x20;  // those below stand in the skeleton
};

/// The whole file round its entities.
std::string document(const std::string& entities, const DxfOptions& options, Handles& handles);

/// The handle of the model space's record, which owns all entities.
inline constexpr std::string_view model_space = "1B";

}  // namespace batten::dxf_file
