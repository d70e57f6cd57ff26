#include "batten/make/sample_options.hpp"
#include "operation_promises.hpp"

// On the natural spline through points, and on cubics with any tangents: cusps, rests, loops.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace batten;
    fuzz::Bytes bytes(data, size);
    constexpr auto laws = names_of(Law{});
    const Law law = laws[bytes.below(laws.size())].value;
    std::vector<Setting> settings{{"law", std::string(name_of(law))}};
    const auto set = [&](const char* name, std::string value) {
        settings.push_back({name, std::move(value)});
    };
    const unsigned how = bytes.byte();
    if (how & 1) set("count", std::to_string(bytes.below(40)));
    if (how & 2) set("curvature_weight", bytes.number_text());
    if (how & 4) set("frames", "true");
    if (how & 8) {
        for (const char* limit : {"max_speed", "max_lateral", "max_tangential"}) {
            set(limit, bytes.number_text());
        }
    }
    const int dim = 2 + static_cast<int>(bytes.below(2));
    if (how & 16) settings.push_back({"weights", bytes.points(3, how & 32 ? 1 : 2)});
    const Points points = bytes.points(10, dim);
    const std::optional<Curve> curve =
        how & 64 ? fuzz::cubics(points) : fuzz::natural_spline(points);
    if (curve) fuzz::check_operation("sample", {"input", *curve}, settings);
    return 0;
}
