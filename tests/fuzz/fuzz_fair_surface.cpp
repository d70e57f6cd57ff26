#include "batten/base/text.hpp"
#include "operation_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    const char* const borders[] = {"g0", "g1", "g2"};
    std::vector<Setting> settings{{"border", std::string(borders[bytes.below(3)])},
                                  {"sweeps", std::to_string(1 + bytes.below(20))}};
    const unsigned flags = bytes.byte();
    if (flags & 1) settings.push_back({"engine", "filter"});
    if (flags & 2) settings.push_back({"target", "mean"});
    if (flags & 4) settings.push_back({"root", "paper"});
    if (flags & 8) settings.push_back({"sigma", bytes.number_text()});
    if (flags & 16) settings.push_back({"weight_curvature", bytes.number_text()});
    // A flat grid with some nodes moved, scaled by anything.
    const double scale = flags & 32 ? bytes.number() : 1;
    const unsigned nu = 7 + bytes.below(4), nv = 7 + bytes.below(4);
    std::string text = "u,v,x,y,z\n";
    for (unsigned i = 0; i < nu; ++i) {
        for (unsigned j = 0; j < nv; ++j) {
            const double moved = bytes.byte() & 3 ? 0 : bytes.number();
            const double x = scale * i, y = scale * j, z = scale * moved;
            if (!(std::isfinite(x) && std::isfinite(y) && std::isfinite(z))) continue;
            text += std::to_string(i) + ',' + std::to_string(j) + ',' + format_number(x) + ',' +
                    format_number(y) + ',' + format_number(z) + '\n';
        }
    }
    fuzz::check_operation("fair-surface", {"nodes.csv", Source{"nodes.csv", text}}, settings);
    return 0;
}
