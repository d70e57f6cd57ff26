#include "operation_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    const char* const alphas[] = {"-1", "0", "0.5", "1", "2", "auto", "-20", "7.5"};
    const char* const ends[] = {"none", "position", "tangent", "curvature"};
    std::vector<Setting> settings{{"alpha", std::string(alphas[bytes.below(8)])},
                                  {"fix_ends", std::string(ends[bytes.below(4)])},
                                  {"sweeps", std::to_string(1 + bytes.below(40))},
                                  {"window", std::to_string(1 + bytes.below(12))}};
    const unsigned flags = bytes.byte();
    if (flags & 1) settings.push_back({"closed", "true"});
    if (flags & 2) settings.push_back({"engine", "filter"});
    if (flags & 4) settings.push_back({"as", "arcs"});
    if (flags & 8) settings.push_back({"split", "true"});
    if (flags & 16) settings.push_back({"sigma", bytes.number_text()});
    if (flags & 32) settings.push_back({"tolerance", bytes.number_text()});
    if (flags & 64) settings.push_back({"lambda", bytes.number_text()});
    const int dim = 2 + static_cast<int>(bytes.below(2));
    fuzz::check_operation("fair", fuzz::points_as_input(bytes.points(24, dim)), settings);
    return 0;
}
