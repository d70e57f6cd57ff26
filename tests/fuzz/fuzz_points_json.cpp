#include "table_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    batten::fuzz::check_table(data, size, batten::TableFormat::json);
    return 0;
}
