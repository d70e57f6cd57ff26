#include "make/fit_surface/node_space.hpp"

#include <algorithm>

#include "num/rows.hpp"
#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {

NodeSpace::NodeSpace(const Nodes& nodes) : nodes_(nodes), heights_(nodes.z.size()) {
    const std::size_t n = nodes.y.size();
    for (std::size_t r = 0; r < nodes.x.size(); ++r) {
        for (std::size_t s = 0; s < n; ++s) {
            heights_[r * n + s] = nodes.z[r * n + s] * nodes.x_weight[r] * nodes.y_weight[s];
        }
    }
}

std::vector<double> NodeSpace::coordinates(Way way, const BSplineBasis& basis,
                                           std::size_t function) const {
    const std::span<const double> all = lines(way);
    const std::vector<double>& weights = way == Way::x ? nodes_.x_weight : nodes_.y_weight;
    const auto place = [&](double t) {
        return static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), t) - all.begin());
    };
    const std::size_t order = static_cast<std::size_t>(basis.degree()) + 1;
    const std::size_t from = place(basis.knots()[function]);
    const std::size_t to =
        std::min(all.size(), place(basis.knots()[function + order]) + 1);
    const num::TensorSide side = surfaces::side_of(basis, all.subspan(from, to - from));
    std::vector<double> values(all.size(), 0.0);
    for (std::size_t r = 0; r < side.places(); ++r) {
        const std::size_t first = side.first[r];
        if (function < first || function >= first + order) continue;
        values[from + r] = side.at(r)[function - first] * weights[from + r];
    }
    return values;
}

SearchSpace::Image NodeSpace::image(Way way, std::span<const double> function) const {
    Image result;
    result.lines.assign(size(across(way)), 0.0);
    if (way == Way::x) num::add_combination(function, heights_, result.lines);
    else num::add_dots(heights_, function, result.lines);
    result.coordinates = result.lines;
    return result;
}

}  // namespace batten::surface_fitting
