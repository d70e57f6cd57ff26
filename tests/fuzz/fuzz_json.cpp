#include <cstddef>
#include <cstdint>
#include <string_view>

#include "batten/io/json.hpp"
#include "promises.hpp"

// What is read as JSON reads back from both styles of writing.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    Value tree;
    try {
        tree = parse_json({reinterpret_cast<const char*>(data), size}, "input");
    } catch (const Error& error) {
        fuzz::check_error(error);
        return 0;
    }
    for (const JsonStyle style : {JsonStyle::readable, JsonStyle::one_line}) {
        const std::string text = dump_json(tree, style);
        // A whole real comes back as a whole number, so texts are compared and not trees.
        fuzz::require(dump_json(parse_json(text, "copy"), style) == text);
    }
    return 0;
}
