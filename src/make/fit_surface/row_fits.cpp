#include "make/fit_surface/row_fits.hpp"

#include <algorithm>

#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

/// Of the triangle's diagonal: below, seminormal equations lose 2 digits of 16 at most.
constexpr double harmless_row_spread = 10;
constexpr std::size_t row_lanes = 8;

std::vector<double> band_gram(const num::TensorSide& side) {
    const std::size_t order = static_cast<std::size_t>(side.order);
    std::vector<double> gram(side.functions * order, 0.0);
    for (std::size_t s = 0; s < side.places(); ++s) {
        for (std::size_t i = 0; i < order; ++i) {
            for (std::size_t j = i; j < order; ++j) {
                gram[(side.first[s] + i) * order + j - i] += side.at(s)[i] * side.at(s)[j];
            }
        }
    }
    return gram;
}

/// Sum of (weight e)^2: lane by lane, so that vectors give the same bits.
double weighted_sq(const double* e, std::span<const double> weights) {
    double lanes[row_lanes] = {};
    const std::size_t whole = weights.size() / row_lanes * row_lanes;
    for (std::size_t s = 0; s < whole; s += row_lanes) {
        for (std::size_t l = 0; l < row_lanes; ++l) {
            const double value = weights[s + l] * e[s + l];
            lanes[l] += value * value;
        }
    }
    for (std::size_t s = whole; s < weights.size(); ++s) {
        lanes[0] += weights[s] * e[s] * (weights[s] * e[s]);
    }
    double sum = 0;
    for (const double lane : lanes) sum += lane;
    return sum;
}

}  // namespace

num::TensorSide separate_rows(std::size_t count) {
    num::TensorSide side{1, count, {}, std::vector<double>(count, 1.0)};
    for (std::size_t r = 0; r < count; ++r) side.first.push_back(r);
    return side;
}

RowFits::RowFits(BSplineBasis basis, std::span<const double> places,
                 std::span<const double> weights)
    : weights_(weights.begin(), weights.end()), axis_(std::move(basis), places, weights, places),
      gram_(band_gram(axis_.weighted())), is_harmless_(axis_.spread() <= harmless_row_spread),
      each_row_(separate_rows(most_rows)), plain_(each_row_, axis_.plain()),
      normal_(each_row_, axis_.normal()) {}

void RowFits::solve(std::span<const double> z, std::size_t rows, std::vector<double>& c) const {
    const std::size_t q = axis_.functions();
    std::vector<double> products(rows * q, 0.0);
    normal_.contract(z, {0, rows}, products);
    std::vector<double> turned = num::transposed(products, rows);
    axis_.invert_rows(turned, rows);
    for (std::size_t r = 0; r < rows; ++r) {
        for (std::size_t j = 0; j < q; ++j) c[r * q + j] += turned[j * rows + r];
    }
}

RowFits::Fitted RowFits::fit(std::span<const double> z) const {
    const std::size_t columns = weights_.size(), rows = z.size() / columns;
    Fitted fitted{std::vector<double>(rows * axis_.functions(), 0.0), std::vector<double>(rows)};
    const bool is_delicate = axis_.is_delicate();
    if (is_delicate) {
        fitted.coefficients =
            num::transposed(axis_.fitted(num::transposed(z, rows), rows), axis_.functions());
    } else {
        solve(z, rows, fitted.coefficients);
    }
    std::vector<double> e(z.size());
    const auto take_residuals = [&] {
        plain_.expand(fitted.coefficients, {0, rows}, e);
        for (std::size_t k = 0; k < e.size(); ++k) e[k] = z[k] - e[k];
    };
    take_residuals();
    if (!is_harmless_ && !is_delicate) {
        solve(e, rows, fitted.coefficients);
        take_residuals();
    }
    for (std::size_t r = 0; r < rows; ++r) {
        fitted.left_sq[r] = weighted_sq(e.data() + r * columns, weights_);
    }
    return fitted;
}

double RowFits::norm_sq(const double* c) const {
    const std::size_t order = static_cast<std::size_t>(axis_.plain().order), q = axis_.functions();
    double sum = 0;
    for (std::size_t j = 0; j < q; ++j) {
        double across = 0;
        for (std::size_t l = 1; l < std::min(order, q - j); ++l) {
            across += gram_[j * order + l] * c[j + l];
        }
        sum += c[j] * (gram_[j * order] * c[j] + 2 * across);
    }
    return std::max(0.0, sum);
}

}  // namespace batten::surface_fitting
