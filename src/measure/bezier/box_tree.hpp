#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace batten::bezier {

/// Boxes arranged so that those near a point are found without looking at all.
class BoxTree {
public:
    /// `boxes` holds for each item its dim lower, then its dim upper bounds.
    BoxTree(int dim, std::vector<double> boxes);

    /// Calls `visit(item)`, which returns a squared distance, for every item whose box is not
    /// farther from `point` than the smallest distance returned so far and `limit_sq`; near boxes
    /// first. Returns that smallest distance.
    template <class Visit>
    double visit_near(std::span<const double> point, double limit_sq, Visit&& visit) const {
        if (nodes_.empty()) return limit_sq;
        return descend(0, point, limit_sq, visit);
    }

private:
    struct Node {
        std::size_t first, last;  // items_[first, last)
        std::size_t right = 0;    // the left child follows its parent; 0 for leaves
    };

    std::size_t build(std::size_t first, std::size_t last);
    std::span<const double> box(std::size_t item) const;
    double distance_sq(std::size_t node, std::span<const double> point) const;

    template <class Visit>
    double descend(std::size_t node, std::span<const double> point, double limit_sq,
                   Visit& visit) const {
        const Node& here = nodes_[node];
        if (here.right == 0) {
            for (std::size_t i = here.first; i < here.last; ++i) {
                limit_sq = std::min(limit_sq, visit(items_[i]));
            }
            return limit_sq;
        }
        std::size_t near = node + 1, far = here.right;
        double near_sq = distance_sq(near, point), far_sq = distance_sq(far, point);
        if (far_sq < near_sq) {
            std::swap(near, far);
            std::swap(near_sq, far_sq);
        }
        if (near_sq <= limit_sq) limit_sq = descend(near, point, limit_sq, visit);
        if (far_sq <= limit_sq) limit_sq = descend(far, point, limit_sq, visit);
        return limit_sq;
    }

    std::size_t dim_;
    std::vector<double> boxes_, node_boxes_;
    std::vector<std::size_t> items_;
    std::vector<Node> nodes_;
};

}  // namespace batten::bezier
