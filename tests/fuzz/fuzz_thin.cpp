#include "operation_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    const char* const parameters[] = {"index", "chord", "centripetal"};
    std::vector<Setting> settings{{"degree", std::to_string(bytes.below(7))},
                                  {"parameter", std::string(parameters[bytes.below(3)])},
                                  {"tolerance", bytes.number_text() + "r"}};
    if (bytes.byte() & 1) settings.push_back({"closed", "true"});
    const int dim = 2 + static_cast<int>(bytes.below(2));
    fuzz::check_operation("thin", fuzz::points_as_input(bytes.points(24, dim)), settings);
    return 0;
}
