#pragma once

#include <memory>
#include <vector>

#include "make/fit_surface/search_space.hpp"

namespace batten::surface_fitting {

/// Nodes; fewer are searched as they are.
constexpr std::size_t worth_compressing = 50000;

/// A full grid read once: what fits over halved strips need, without the nodes.
///
/// Splines over strips made by halving lie in the space over the finest strips of that kind. For
/// its splines F_i(x), F_j(y) three products of the weighted heights are kept: with both, with the
/// F_j alone (a column an x-line) and with the F_i alone. The triangles of the two directions make
/// them orthonormal.
///
/// delta2 is that of the finest strips and what is left of the products, so that nothing cancels.
/// Accuracy: 1e-10 of delta2. Memory: for every line the functions across. Cost: one pass over the
/// nodes. Borrows the nodes.
class Compressed : public SearchSpace {
public:
    /// Nothing where the nodes do not determine the splines over these breaks.
    static std::unique_ptr<Compressed> over(const Nodes& nodes, int degree,
                                            const std::vector<double>& x_breaks,
                                            const std::vector<double>& y_breaks);

    const std::vector<double>& heights() const override { return heights_; }
    std::size_t size(Way way) const override { return axis(way).functions(); }
    std::span<const double> lines(Way way) const override {
        return way == Way::x ? nodes_.x : nodes_.y;
    }
    std::vector<double> coordinates(Way way, const BSplineBasis& basis,
                                    std::size_t function) const override;
    std::vector<double> at_lines(Way way, std::span<const double> function) const override;
    Image image(Way way, std::span<const double> function) const override;
    bool has_break(Way way, double t) const override;
    double least_delta2() const override { return least_delta2_; }
    bool is_of_nodes() const override { return false; }
    Solution solution(const Axis& x, const Axis& y) const override;

private:
    Compressed(const Nodes& nodes, Axis x, Axis y);
    double left_of_x_lines() const;
    const Axis& axis(Way way) const { return way == Way::x ? x_ : y_; }

    const Nodes& nodes_;
    Axis x_, y_;
    std::vector<double> products_;  ///< with the splines: x functions by y functions
    std::vector<double> heights_;   ///< the same by orthonormal functions
    std::vector<double> x_lines_;   ///< y functions by x-lines
    std::vector<double> y_lines_;   ///< x functions by y-lines
    double least_delta2_ = 0;
};

}  // namespace batten::surface_fitting
