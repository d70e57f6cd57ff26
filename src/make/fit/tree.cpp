#include "make/fit/tree.hpp"

#include <algorithm>

namespace batten::fitting {

ReductionTree::ReductionTree(const Reducer& reducer, Interval domain) : reducer_(reducer) {
    // Twice as many nodes as leaves, and leaves at least half full where x is evenly spread.
    const std::size_t usual = 4 * (reducer.samples().size() / leaf_rows + 1);
    nodes_.reserve(usual);
    triangles_.reserve(usual * reducer.shape().size());
    nodes_.push_back({domain, {0, reducer.samples().size()}, -1});
    grow(0);
}

void ReductionTree::grow(int index) {
    const Node here = node(index);
    const double middle = knot_between(here.span);
    const bool is_leaf = here.rows.count() <= leaf_rows || !(here.span.lo < middle) ||
                         !(middle < here.span.hi);
    const std::size_t size = reducer_.shape().size();
    const auto own = [&](int i) { return triangles_.data() + static_cast<std::size_t>(i) * size; };
    if (triangles_.size() < nodes_.size() * size) triangles_.resize(nodes_.size() * size);
    if (is_leaf) {
        reducer_.reduce(here.rows, here.span, Rest::wanted, own(index));
        return;
    }
    const Rows left = rows_in(reducer_.samples(), here.rows, {here.span.lo, middle}, RightEnd::open);
    const int first = static_cast<int>(nodes_.size());
    nodes_[static_cast<std::size_t>(index)].left = first;
    nodes_.push_back({{here.span.lo, middle}, left, -1});
    nodes_.push_back({{middle, here.span.hi}, {left.last, here.rows.last}, -1});
    grow(first);
    grow(first + 1);
    for (const int child : {first, first + 1}) {
        reducer_.merge(own(child), node(child).span, here.span, own(index));
    }
}

void ReductionTree::over(Interval span, RightEnd end, double* out) const {
    std::fill(out, out + reducer_.shape().size(), 0.0);
    collect(0, span, end, out);
}

void ReductionTree::collect(int index, Interval span, RightEnd end, double* out) const {
    const Node& here = node(index);
    if (here.span.hi < span.lo || span.hi < here.span.lo || here.rows.count() == 0) return;
    if (span.lo <= here.span.lo && here.span.hi <= span.hi) {
        reducer_.merge(triangle(index), here.span, span, out);
        return;
    }
    if (here.left >= 0) {
        collect(here.left, span, end, out);
        collect(here.left + 1, span, end, out);
        return;
    }
    const Rows rows = rows_in(reducer_.samples(), here.rows, span, end);
    if (rows.count() == 0) return;
    std::vector<double> part(reducer_.shape().size());
    reducer_.reduce(rows, span, Rest::wanted, part.data());
    reducer_.merge(part.data(), span, span, out);
}

}  // namespace batten::fitting
