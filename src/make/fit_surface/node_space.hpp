#pragma once

#include "make/fit_surface/search_space.hpp"

namespace batten::surface_fitting {

/// The search among all functions on the nodes of a small full grid. Borrows the nodes.
class NodeSpace : public SearchSpace {
public:
    explicit NodeSpace(const Nodes& nodes);

    const std::vector<double>& heights() const override { return heights_; }
    std::size_t size(Way way) const override { return lines(way).size(); }
    std::span<const double> lines(Way way) const override {
        return way == Way::x ? nodes_.x : nodes_.y;
    }
    std::vector<double> coordinates(Way way, const BSplineBasis& basis,
                                    std::size_t function) const override;
    std::vector<double> at_lines(Way, std::span<const double> function) const override {
        return {function.begin(), function.end()};
    }
    Image image(Way way, std::span<const double> function) const override;
    bool has_break(Way, double) const override { return true; }
    double least_delta2() const override { return 0; }
    bool is_of_nodes() const override { return true; }
    Solution solution(const Axis& x, const Axis& y) const override {
        return solve(nodes_, x, y, Corrected::no);
    }

private:
    const Nodes& nodes_;
    std::vector<double> heights_;
};

}  // namespace batten::surface_fitting
