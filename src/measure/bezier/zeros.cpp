#include "measure/bezier/zeros.hpp"

namespace batten::bezier {
namespace {

/// A zero this near to the end of a piece may be the neighbour's zero at its start.
constexpr double near_end = 0x1p-40;

}  // namespace

void Zeros::add(std::size_t i, bernstein::View c, double noise) {
    if (bernstein::bound(c) <= noise) {
        zeros_.push_back({i, 0});
        zeros_.push_back({i, 1});
        return;
    }
    for (const double u : bernstein::roots(c, noise)) zeros_.push_back({i, u});
}

std::vector<double> Zeros::parameters() const {
    std::vector<double> result;
    for (std::size_t j = 0; j < zeros_.size(); ++j) {
        const Zero& zero = zeros_[j];
        const bool repeats = j > 0 && zero.u <= near_end && zeros_[j - 1].u >= 1 - near_end &&
                             zeros_[j - 1].piece + 1 == zero.piece;
        if (repeats) continue;
        result.push_back(pieces_.t_of(zero.piece, zero.u));
    }
    const bool seam_twice = result.size() > 1 && pieces_.curve().is_closed() &&
                            zeros_.front().piece == 0 && zeros_.front().u <= near_end &&
                            zeros_.back().piece + 1 == pieces_.size() &&
                            zeros_.back().u >= 1 - near_end;
    if (seam_twice) result.pop_back();
    return result;
}

}  // namespace batten::bezier
