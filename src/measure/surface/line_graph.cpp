#include "measure/surface/line_graph.hpp"

#include <array>
#include <utility>

namespace batten::contouring {
namespace {

constexpr std::size_t nothing = static_cast<std::size_t>(-1);

using JointPair = std::array<std::size_t, 2>;

Thread follow(const std::vector<Joint>& joints, const std::vector<JointPair>& of,
              std::size_t start, std::vector<char>& seen) {
    Thread thread;
    std::size_t at = start, arrival = nothing;
    while (!seen[at]) {
        seen[at] = 1;
        const std::size_t onward = of[at][0] == arrival ? of[at][1] : of[at][0];
        if (onward == nothing) return thread;
        const Joint& joint = joints[onward];
        const bool is_forward = joint.ends[0] == at;
        thread.pieces.push_back(joint.piece);
        if (!is_forward) std::swap(thread.pieces.back().a, thread.pieces.back().b);
        at = joint.ends[is_forward ? 1 : 0];
        arrival = onward;
    }
    thread.is_closed = true;
    return thread;
}

}  // namespace

void LineGraph::join(std::size_t a, std::size_t b, const LinePiece& between) {
    joints_.push_back({{a, b}, between});
}

std::vector<Thread> LineGraph::threads(std::size_t points) const {
    std::vector<JointPair> of(points, {nothing, nothing});
    for (std::size_t k = 0; k < joints_.size(); ++k) {
        for (const std::size_t end : joints_[k].ends) of[end][of[end][0] == nothing ? 0 : 1] = k;
    }
    std::vector<Thread> threads;
    std::vector<char> seen(points, 0);
    for (const bool from_end : {true, false}) {
        for (std::size_t p = 0; p < points; ++p) {
            if (seen[p] || of[p][0] == nothing) continue;
            if (from_end && of[p][1] != nothing) continue;
            threads.push_back(follow(joints_, of, p, seen));
        }
    }
    return threads;
}

}  // namespace batten::contouring
