#include "measure/surface/chains.hpp"

#include <array>

namespace batten::contouring {
namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Edges are numbered 2 node, and 2 node + 1 for those along y; each is joined to at most two.
class Joints {
public:
    Joints(std::size_t nu, std::size_t nv) : nv_(nv), next_(2 * nu * nv, {nowhere, nowhere}) {}

    std::size_t along_x(std::size_t i, std::size_t j) const { return 2 * (i * nv_ + j); }
    std::size_t along_y(std::size_t i, std::size_t j) const { return 2 * (i * nv_ + j) + 1; }
    std::size_t size() const { return next_.size(); }
    std::array<std::size_t, 2>& operator[](std::size_t edge) { return next_[edge]; }
    void join(std::size_t a, std::size_t b) {
        next_[a][next_[a][0] == nowhere ? 0 : 1] = b;
        next_[b][next_[b][0] == nowhere ? 0 : 1] = a;
    }
    LatticeEdge edge(std::size_t number) const {
        return {number / 2 / nv_, number / 2 % nv_, number % 2 == 0};
    }

private:
    std::size_t nv_;
    std::vector<std::array<std::size_t, 2>> next_;
};

void join_cell(Joints& joints, std::size_t i, std::size_t j, GridView above, GridView middles) {
    // Sides in the order below, right, above, left; corners before each of them.
    const std::size_t sides[] = {joints.along_x(i, j), joints.along_y(i + 1, j),
                                 joints.along_x(i, j + 1), joints.along_y(i, j)};
    const bool corner[] = {above(i, j) > 0, above(i + 1, j) > 0, above(i + 1, j + 1) > 0,
                           above(i, j + 1) > 0};
    std::size_t crossed[4];
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        if (corner[k] != corner[(k + 1) % 4]) crossed[count++] = k;
    }
    if (count == 2) joints.join(sides[crossed[0]], sides[crossed[1]]);
    if (count < 4) return;
    // A saddle: the middle belongs to the corners of its own sign, the others are cut off.
    const bool middle = middles(i, j) >= 0;
    const bool cuts_first = corner[0] != middle;
    joints.join(sides[cuts_first ? 3 : 0], sides[cuts_first ? 0 : 1]);
    joints.join(sides[cuts_first ? 1 : 2], sides[cuts_first ? 2 : 3]);
}

Chain follow(Joints& joints, std::size_t start, std::vector<char>& seen) {
    Chain chain;
    std::size_t before = nowhere, at = start;
    while (at != nowhere && !seen[at]) {
        seen[at] = 1;
        chain.edges.push_back(joints.edge(at));
        const std::array<std::size_t, 2> next = joints[at];
        const std::size_t onward = next[0] == before ? next[1] : next[0];
        before = at;
        at = onward;
    }
    chain.is_closed = at == start;
    return chain;
}

}  // namespace

std::vector<Chain> chains_of(GridView above, GridView middles) {
    Joints joints(above.nu(), above.nv());
    for (std::size_t i = 0; i + 1 < above.nu(); ++i) {
        for (std::size_t j = 0; j + 1 < above.nv(); ++j) join_cell(joints, i, j, above, middles);
    }
    std::vector<Chain> chains;
    std::vector<char> seen(joints.size(), 0);
    for (const bool from_border : {true, false}) {
        for (std::size_t e = 0; e < joints.size(); ++e) {
            if (seen[e] || joints[e][0] == nowhere) continue;
            if (from_border && joints[e][1] != nowhere) continue;
            chains.push_back(follow(joints, e, seen));
        }
    }
    return chains;
}

}  // namespace batten::contouring
