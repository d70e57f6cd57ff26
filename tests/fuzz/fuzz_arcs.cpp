#include "operation_promises.hpp"

// Through points, and along the natural spline through them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    std::vector<Setting> settings;
    const auto set = [&](const char* name, std::string value) {
        settings.push_back({name, std::move(value)});
    };
    const unsigned how = bytes.byte();
    if (how & 1) set("closed", "true");
    if (how & 2) set("method", how & 4 ? "chain" : "biarc");
    if (how & 8) set("tolerance", bytes.number_text() + "r");
    if (how & 16) set("start_angle", bytes.number_text());
    if (how & 32) set("max_radius", bytes.number_text());
    Points points = bytes.points(16, 2);
    if (how & 64) {
        const std::optional<Curve> curve = fuzz::natural_spline(points);
        if (curve) fuzz::check_operation("arcs", {"input", *curve}, settings);
    } else {
        fuzz::check_operation("arcs", fuzz::points_as_input(std::move(points)), settings);
    }
    return 0;
}
