#include <cstddef>
#include <cstdint>
#include <string_view>

#include "batten/api/job.hpp"
#include "batten/io/json.hpp"
#include "promises.hpp"

// What is taken for a job names operations, options of theirs, and steps before its own.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    try {
        const Value tree = parse_json({reinterpret_cast<const char*>(data), size}, "input");
        const std::vector<Step> steps = job_of(tree, "input");
        fuzz::require(!steps.empty());
        for (std::size_t i = 0; i < steps.size(); ++i) {
            fuzz::require(steps[i].operation != nullptr);
            for (const StepInput& input : steps[i].inputs) {
                const auto* earlier = std::get_if<EarlierStep>(&input);
                fuzz::require(!earlier || earlier->index < i);
            }
            for (const auto& option : steps[i].options) fuzz::require(option.first != nullptr);
        }
    } catch (const Error& error) {
        fuzz::check_error(error);
    }
    return 0;
}
