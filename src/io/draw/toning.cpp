#include "io/draw/toning.hpp"

#include <algorithm>
#include <array>

namespace batten::drawing {

Tone Toning::line(const LineStyle& style, const std::string& name) {
    constexpr std::array cycle{Tone::ink,  Tone::blue,  Tone::accent,
                               Tone::teal, Tone::ochre, Tone::violet};
    if (style.tone) return *style.tone;
    const auto known = by_name_.find(name);
    if (known != by_name_.end()) return known->second;
    const std::size_t next = name.empty() ? in_panel_ : std::max(in_panel_, named_);
    const Tone tone = cycle[next % cycle.size()];
    in_panel_ = next + 1;
    if (!name.empty()) {
        named_ = next + 1;
        by_name_.emplace(name, tone);
    }
    return tone;
}

}  // namespace batten::drawing
