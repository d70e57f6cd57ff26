#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/bspline.hpp"

namespace batten {
namespace {

constexpr std::size_t most_functions = BSplineBasis::most_degree + 1;

/// Divides a jet of weight x point by the jet of the weight, in place [PieglTiller1997, eq. 4.8].
void divide_by_weight(std::span<double> jet, std::span<const double> weight, std::size_t dim) {
    const std::size_t rows = jet.size() / dim;
    for (std::size_t k = 0; k < rows; ++k) {
        double binomial = 1;
        for (std::size_t i = 1; i <= k && i < weight.size(); ++i) {
            binomial *= static_cast<double>(k - i + 1) / static_cast<double>(i);
            const double factor = std::round(binomial) * weight[i];
            for (std::size_t c = 0; c < dim; ++c)
                jet[k * dim + c] -= factor * jet[(k - i) * dim + c];
        }
        for (std::size_t c = 0; c < dim; ++c) jet[k * dim + c] /= weight[0];
    }
}

}  // namespace

BSplineCurve::BSplineCurve(BSplineBasis basis, Points control_points, std::vector<double> weights)
    : basis_(std::move(basis)),
      control_points_(std::move(control_points)),
      weights_(std::move(weights)) {
    if (basis_.degree() < 1) {
        throw Error("bspline.degree", "degree", "0", "a curve needs degree 1 or more");
    }
    if (control_points_.size() != basis_.size()) {
        throw Error("bspline.control-points", "control points",
                    std::to_string(control_points_.size()),
                    "these knots need " + std::to_string(basis_.size()));
    }
    require_finite(control_points_);
    if (weights_.empty()) return;
    if (weights_.size() != basis_.size()) {
        throw Error("bspline.weights", "weights", std::to_string(weights_.size()),
                    "one weight a control point is needed: " + std::to_string(basis_.size()));
    }
    for (std::size_t i = 0; i < weights_.size(); ++i) {
        if (!(weights_[i] > 0) || !std::isfinite(weights_[i])) {
            throw Error("bspline.weights", "weight " + std::to_string(i),
                        format_number(weights_[i]), "weights must be positive and finite");
        }
    }
}

void BSplineCurve::jets_on(std::size_t piece, std::span<const double> t, int order,
                           std::span<double> out) const {
    const std::size_t span = basis_.span_of_piece(piece);
    const std::size_t dim = static_cast<std::size_t>(control_points_.dim());
    const std::size_t width = dim * static_cast<std::size_t>(order + 1);
    const int functions = basis_.degree() + 1;
    const int rows = std::min(order, basis_.degree()) + 1;  // the others are 0
    std::array<double, most_functions * most_functions> values;
    std::array<double, most_functions> weight;
    for (std::size_t i = 0; i < t.size(); ++i) {
        const std::span<double> jet = out.subspan(i * width, width);
        std::fill(jet.begin(), jet.end(), 0.0);
        weight.fill(0);
        basis_.nonzero_on(span, t[i], rows - 1, values);
        for (int j = 0; j < functions; ++j) {
            const std::size_t control = basis_.control(span, j);
            const std::span<const double> point = control_points_[control];
            const double w = is_rational() ? weights_[control] : 1;
            for (int k = 0; k < rows; ++k) {
                const double value = values[static_cast<std::size_t>(k * functions + j)] * w;
                const std::size_t row = static_cast<std::size_t>(k);
                weight[row] += value;
                for (std::size_t c = 0; c < dim; ++c) jet[row * dim + c] += value * point[c];
            }
        }
        if (is_rational()) {
            divide_by_weight(jet, {weight.data(), static_cast<std::size_t>(rows)}, dim);
        }
    }
}

}  // namespace batten
