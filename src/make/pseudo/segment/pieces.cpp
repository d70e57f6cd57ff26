#include "make/pseudo/segment/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::pseudo {
namespace {

/// A Bernstein radius and the nodes that suit it.
struct Step {
    double radius;
    int nodes;
};
constexpr std::array<Step, 8> steps{
    {{32, 8}, {12, 12}, {6, 16}, {4, 20}, {3.1, 24}, {2.35, 32}, {2, 40}, {1.8, 48}}};

constexpr int most_halvings = 40;

/// |u - 1| + |u + 1| = radius + 1 / radius on the ellipse with the foci +-1.
double focal_sum(std::complex<double> u) {
    const double y_sq = u.imag() * u.imag();
    const double left = u.real() + 1;
    const double right = u.real() - 1;
    return std::sqrt(left * left + y_sq) + std::sqrt(right * right + y_sq);
}

}  // namespace

Pieces::Pieces(const std::complex<double>* roots, int count) : count_(count) {
    std::copy(roots, roots + count, roots_.begin());
}

int Pieces::nodes_for(Interval part) const {
    double sum = std::numeric_limits<double>::infinity();
    const double middle = part.middle();
    const double stretch = 2 / part.length();
    for (int i = 0; i < count_; ++i) {
        sum = std::min(sum, focal_sum((roots_[static_cast<std::size_t>(i)] - middle) * stretch));
    }
    for (const Step& step : steps) {
        if (sum >= step.radius + 1 / step.radius) return step.nodes;
    }
    return 0;
}

bool Pieces::next(Piece& piece) {
    if (is_done_) return false;
    int nodes = 0;
    while (true) {
        const double width = std::ldexp(1.0, -level_);
        piece.part = {static_cast<double>(index_) * width, static_cast<double>(index_ + 1) * width};
        nodes = nodes_for(piece.part);
        if (nodes > 0) break;
        if (level_ == most_halvings) {
            is_done_ = is_singular_ = true;
            return false;
        }
        ++level_;
        index_ *= 2;
    }
    piece.rule = num::gauss_legendre(nodes);
    ++index_;
    while (level_ > 0 && index_ % 2 == 0) {
        index_ /= 2;
        --level_;
    }
    is_done_ = level_ == 0;
    return true;
}

}  // namespace batten::pseudo
