#include <cstddef>
#include <cstdint>
#include <optional>

#include "curve_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    std::optional<Curve> curve;
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        curve = curve_of(parse_json(text, "input"), "input");
    } catch (const Error& error) {
        fuzz::check_error(error);
        return 0;
    }
    fuzz::check_curve(*curve);
    return 0;
}
