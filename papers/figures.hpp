#pragma once

#include <iostream>
#include <optional>
#include <string>

#include "batten/batten.hpp"

/// What the programs that make the papers' figures have in common.
namespace batten::papers {

/// Writes the drawing as FOLDER/NAME.svg and says so.
inline void save(const std::string& folder, const std::string& name, const Drawing& drawing) {
    write_file(folder + "/" + name + ".svg", svg(drawing));
    std::cout << name << ".svg\n";
}

/// The folder that the program was given; nothing where it was called otherwise, which is said.
inline std::optional<std::string> folder_given(int argc, char** argv) {
    if (argc == 2) return argv[1];
    std::cerr << "usage: figures FOLDER\n";
    return std::nullopt;
}

}  // namespace batten::papers
