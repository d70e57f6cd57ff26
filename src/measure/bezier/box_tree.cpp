#include "measure/bezier/box_tree.hpp"

#include <cmath>

namespace batten::bezier {
namespace {

constexpr std::size_t leaf_size = 2;

}  // namespace

BoxTree::BoxTree(int dim, std::vector<double> boxes)
    : dim_(static_cast<std::size_t>(dim)), boxes_(std::move(boxes)) {
    const std::size_t count = boxes_.size() / (2 * dim_);
    for (std::size_t i = 0; i < count; ++i) items_.push_back(i);
    if (count > 0) build(0, count);
}

std::span<const double> BoxTree::box(std::size_t item) const {
    return {boxes_.data() + item * 2 * dim_, 2 * dim_};
}

/// Halves at the median of the centres along the side on which they spread most.
std::size_t BoxTree::build(std::size_t first, std::size_t last) {
    const std::size_t node = nodes_.size();
    nodes_.push_back({first, last});
    std::vector<double> lo(dim_, HUGE_VAL), hi(dim_, -HUGE_VAL);
    std::size_t axis = 0;
    double widest = -1;
    for (std::size_t k = 0; k < dim_; ++k) {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (std::size_t i = first; i < last; ++i) {
            const std::span<const double> b = box(items_[i]);
            lo[k] = std::fmin(lo[k], b[k]);
            hi[k] = std::fmax(hi[k], b[dim_ + k]);
            least = std::fmin(least, b[k] + b[dim_ + k]);
            most = std::fmax(most, b[k] + b[dim_ + k]);
        }
        if (most - least > widest) {
            widest = most - least;
            axis = k;
        }
    }
    node_boxes_.insert(node_boxes_.end(), lo.begin(), lo.end());
    node_boxes_.insert(node_boxes_.end(), hi.begin(), hi.end());
    if (last - first <= leaf_size) return node;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [this](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::size_t a, std::size_t b) {
        const double centre_a = box(a)[axis] + box(a)[dim_ + axis];
        const double centre_b = box(b)[axis] + box(b)[dim_ + axis];
        return centre_a != centre_b ? centre_a < centre_b : a < b;
    });
    build(first, middle);
    const std::size_t right = build(middle, last);
    nodes_[node].right = right;
    return node;
}

double BoxTree::distance_sq(std::size_t node, std::span<const double> point) const {
    const double* const lo = node_boxes_.data() + node * 2 * dim_;
    double sum = 0;
    for (std::size_t k = 0; k < dim_; ++k) {
        const double outside =
            std::fmax(0.0, std::fmax(lo[k] - point[k], point[k] - lo[dim_ + k]));
        sum += outside * outside;
    }
    return sum;
}

}  // namespace batten::bezier
