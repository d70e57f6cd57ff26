#include "operation_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    std::vector<Setting> settings;
    const auto set = [&](const char* name, std::string value) {
        settings.push_back({name, std::move(value)});
    };
    const char* const parameters[] = {"index", "chord", "centripetal"};
    set("degree", std::to_string(bytes.below(9)));
    set("parameter", parameters[bytes.below(3)]);
    const unsigned how = bytes.byte();
    if (how & 1) set("closed", "true");
    if (how & 2) set("blend", "true");
    if (how & 4) set("keep_spikes", "true");
    if (how & 8) set("between", std::to_string(bytes.below(6)));
    if (how & 16) set("tolerance", bytes.number_text() + "r");
    if (how & 32) set("end_degree", std::to_string(bytes.below(6)));
    const int dim = 1 + static_cast<int>(bytes.below(3));
    fuzz::check_operation("densify", fuzz::points_as_input(bytes.points(24, dim)), settings);
    return 0;
}
