#include <cstddef>
#include <cstdint>
#include <optional>

#include "curve_promises.hpp"

// Bare path data, and SVG pictures where the text begins with <.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    std::optional<Curve> curve;
    try {
        curve = parse_curve({"input.svg", {reinterpret_cast<const char*>(data), size}});
    } catch (const Error& error) {
        fuzz::check_error(error);
        return 0;
    }
    fuzz::check_curve(*curve);
    return 0;
}
