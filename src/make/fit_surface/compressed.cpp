#include "make/fit_surface/compressed.hpp"

#include <algorithm>

#include "make/fit_surface/height_products.hpp"
#include "make/fit_surface/inclusion.hpp"
#include "num/rows.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {

std::unique_ptr<Compressed> Compressed::over(const Nodes& nodes, int degree,
                                             const std::vector<double>& x_breaks,
                                             const std::vector<double>& y_breaks) {
    const BSplineBasis x = basis_over(x_breaks, degree), y = basis_over(y_breaks, degree);
    if (!is_determined(x, nodes.x) || !is_determined(y, nodes.y)) return nullptr;
    return std::unique_ptr<Compressed>(
        new Compressed(nodes, Axis(x, nodes.x, nodes.x_weight, nodes.x),
                       Axis(y, nodes.y, nodes.y_weight, nodes.y)));
}

Compressed::Compressed(const Nodes& nodes, Axis x, Axis y)
    : nodes_(nodes), x_(std::move(x)), y_(std::move(y)) {
    HeightProducts sums(nodes, x_, y_);
    nodes.for_rows([&](std::size_t first, std::span<const double> z) { sums.add(first, z); });
    products_ = std::move(sums.both);
    x_lines_ = std::move(sums.x_lines);
    y_lines_ = std::move(sums.y_lines);
    const std::size_t n = nodes.y.size();
    for (std::size_t i = 0; i < x_.functions(); ++i) {
        for (std::size_t s = 0; s < n; ++s) y_lines_[i * n + s] *= nodes.y_weight[s];
    }
    heights_ = products_;
    x_.forward_rows(heights_, y_.functions());
    y_.forward_columns(heights_);
    x_.forward_rows(y_lines_, n);
    least_delta2_ = sums.left_sq + left_of_x_lines();
}

double Compressed::left_of_x_lines() const {
    const std::size_t m = nodes_.x.size(), q = y_.functions();
    std::vector<double> of_x(x_.functions());
    double sum = 0;
    for (std::size_t j = 0; j < q; ++j) {
        for (std::size_t i = 0; i < of_x.size(); ++i) of_x[i] = heights_[i * q + j];
        std::vector<double> rest = at_lines(Way::x, of_x);
        num::add_times(-1, std::span(x_lines_).subspan(j * m, m), rest);
        sum += num::sum_of_squares(rest);
    }
    return sum;
}

bool Compressed::has_break(Way way, double t) const {
    const std::span<const double> breaks = axis(way).basis().breaks();
    return std::binary_search(breaks.begin(), breaks.end(), t);
}

std::vector<double> Compressed::coordinates(Way way, const BSplineBasis& basis,
                                            std::size_t function) const {
    return axis(way).times_triangle(refined_spline(basis, function, axis(way).basis()));
}

std::vector<double> Compressed::at_lines(Way way, std::span<const double> function) const {
    const std::vector<double> c = axis(way).solved(function);
    const num::TensorSide& side = axis(way).weighted();
    std::vector<double> values(side.places(), 0.0);
    for (std::size_t r = 0; r < values.size(); ++r) {
        for (int i = 0; i < side.order; ++i) {
            values[r] += side.at(r)[i] * c[side.first[r] + static_cast<std::size_t>(i)];
        }
    }
    return values;
}

SearchSpace::Image Compressed::image(Way way, std::span<const double> function) const {
    Image result;
    result.lines.assign(lines(across(way)).size(), 0.0);
    result.coordinates.assign(size(across(way)), 0.0);
    if (way == Way::x) {
        num::add_combination(function, y_lines_, result.lines);
        num::add_combination(function, heights_, result.coordinates);
    } else {
        num::add_combination(function, x_lines_, result.lines);
        num::add_dots(heights_, function, result.coordinates);
    }
    return result;
}

Solution Compressed::solution(const Axis& x, const Axis& y) const {
    const InclusionPair coarse{{x.basis(), x_.basis()}, {y.basis(), y_.basis()}};
    return {inverted(coarse.reduced(products_), x, y)};
}

}  // namespace batten::surface_fitting
