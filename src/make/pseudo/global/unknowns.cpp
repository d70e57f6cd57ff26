#include "make/pseudo/global/unknowns.hpp"

namespace batten::pseudo {
namespace {

enum class Joint {
    smooth,  // one tangent
    split,   // a corner or an end: two
    fixed
};

std::vector<Joint> joints(std::size_t points, const AngleRules& rules) {
    std::vector<Joint> joints(points, Joint::smooth);
    if (!rules.is_closed) joints.front() = joints.back() = Joint::split;
    for (int corner : rules.corners) joints[static_cast<std::size_t>(corner)] = Joint::split;
    for (const FixedTangent& tangent : rules.tangents) {
        joints[static_cast<std::size_t>(tangent.index)] = Joint::fixed;
    }
    return joints;
}

}  // namespace

Unknowns number_unknowns(std::size_t points, const AngleRules& rules) {
    const std::vector<Joint> at = joints(points, rules);
    Unknowns unknowns;
    unknowns.of_span.resize(rules.is_closed ? points : points - 1);
    for (std::size_t i = 0; i < unknowns.of_span.size(); ++i) {
        SpanUnknowns& span = unknowns.of_span[i];
        if (at[i] == Joint::split || (i == 0 && at[0] == Joint::smooth)) {
            span.start = unknowns.count++;
        } else if (at[i] == Joint::smooth) {
            span.start = unknowns.of_span[i - 1].end;
        }
        const std::size_t to = (i + 1) % points;
        if (to == 0 && at[0] == Joint::smooth) {
            span.end = unknowns.of_span[0].start;
        } else if (at[to] != Joint::fixed) {
            span.end = unknowns.count++;
        }
    }
    return unknowns;
}

Unknowns within_window(const Unknowns& all, std::size_t first, std::size_t spans) {
    constexpr std::size_t fixed = SpanUnknowns::fixed;
    const std::size_t n = all.of_span.size();
    const auto span = [&](std::size_t k) { return all.of_span[(first + k) % n]; };
    Unknowns window;
    std::size_t outside_start = fixed;  // unknowns shared with the spans beside the window
    std::size_t outside_end = fixed;
    if (spans < n) {
        outside_start = span(n - 1).end;
        outside_end = span(spans).start;
    }
    std::size_t named = fixed;  // the unknown of `all` that was named last
    const auto name = [&](std::size_t unknown) {
        if (unknown == fixed || unknown == outside_start || unknown == outside_end) return fixed;
        if (window.count > 0 && spans == n && unknown == span(0).start) return std::size_t{0};
        if (unknown != named) ++window.count;
        named = unknown;
        return window.count - 1;
    };
    for (std::size_t k = 0; k < spans; ++k) {
        const std::size_t start = name(span(k).start);
        window.of_span.push_back({start, name(span(k).end)});
    }
    return window;
}

}  // namespace batten::pseudo
