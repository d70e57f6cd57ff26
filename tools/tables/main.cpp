// Builds the tables of the pseudo-spline from its minimiser: end_table.cpp and segment_table.cpp,
// into the folder given. The same compiler and C library give the same bytes.
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "end_builder.hpp"
#include "segment_problem.hpp"

using namespace batten;
using namespace batten::pseudo;

namespace {

constexpr std::array<const char*, chart_count> names{"near", "far",        "wide",       "strip",
                                                     "node", "low_corner", "high_corner"};

std::string source(const std::string& body) {
    return "// Made by tools/tables (make tables); do not edit.\n// clang-format off\n"
           "#include <array>\n\n#include \"make/pseudo/tables/tabulated.hpp\"\n\n"
           "namespace batten::pseudo {\n" + body + "\n}  // namespace batten::pseudo\n";
}

std::string segment_tables() {
    constexpr std::size_t line = 4000;
    std::string lists, cases;
    for (std::size_t i = 0; i < chart_count; ++i) {
        const std::string name = names[i];
        const SegmentProblem problem(static_cast<Chart>(i));
        const patches::Builder<SegmentProblem> builder(problem);
        const patches::Census& census = builder.census();
        std::printf("%-12s %4d patches %4d functions %3d without %8zu characters\n", names[i],
                    census.patches, census.functions, census.empty, builder.text().size());
        lists += "constexpr const char* " + name + "_text[] = {\n";
        for (std::size_t at = 0; at < builder.text().size(); at += line) {
            lists += '"' + builder.text().substr(at, line) + "\",\n";
        }
        lists += "};\n";
        cases += "        case Chart::" + name + ": return " + name + "_text;\n";
    }
    return source("namespace {\n" + lists + "}  // namespace\n\nstd::span<const char* const> "
                  "segment_text(Chart chart) {\n    switch (chart) {\n" + cases +
                  "    }\n    return {};\n}\n");
}

bool write(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    std::printf("%s %s\n", file ? "wrote" : "cannot write", path.c_str());
    return static_cast<bool>(file);
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::fprintf(stderr, "usage: batten_tables FOLDER\n");
        return 2;
    }
    const std::string folder = words[1];
    const std::string ends = source(
        "namespace {\n" + end_tables() + "}  // namespace\n\n"
        "std::span<const double> end_kinks() { return kinks; }\n"
        "std::span<const EndPiece> end_pieces() { return pieces; }\n"
        "std::span<const TurnPart> turn_parts() { return turns; }\n"
        "std::span<const Share> three_point_shares() { return shares; }\n\n"
        "std::span<const int> band_cuts(std::size_t band) {\n"
        "    switch (band) {\n        case 0: return cuts0;\n        case 1: return cuts1;\n"
        "        case 2: return cuts2;\n    }\n    return cuts3;\n}\n");
    const bool is_written = write(folder + "/end_table.cpp", ends) &&
                            write(folder + "/segment_table.cpp", segment_tables());
    return is_written ? 0 : 1;
}
