#include "make/fit_surface/inclusion.hpp"

#include "num/rows.hpp"

namespace batten::surface_fitting {

std::vector<double> refined_spline(const BSplineBasis& coarse, std::size_t i,
                                   const BSplineBasis& fine) {
    const std::span<const double> t = coarse.knots(), u = fine.knots();
    const std::size_t order = static_cast<std::size_t>(coarse.degree()) + 1;
    std::vector<double> result(fine.size(), 0.0), a(order);
    for (std::size_t j = 0; j < fine.size(); ++j) {
        if (u[j] < t[i] || u[j + order] > t[i + order]) continue;
        for (std::size_t l = 0; l < order; ++l) {
            a[l] = t[i + l] <= u[j] && u[j] < t[i + l + 1] ? 1 : 0;
        }
        const auto share = [&](std::size_t first, std::size_t k) {
            const double width = t[first + k] - t[first];
            return width > 0 ? (u[j + k] - t[first]) / width : 0;
        };
        for (std::size_t k = 1; k < order; ++k) {
            for (std::size_t l = 0; l + k < order; ++l) {
                const double right = t[i + l + 1 + k] > t[i + l + 1] ? 1 - share(i + l + 1, k) : 0;
                a[l] = share(i + l, k) * a[l] + right * a[l + 1];
            }
        }
        result[j] = a[0];
    }
    return result;
}

Inclusion::Inclusion(const BSplineBasis& coarse, const BSplineBasis& fine) : fine_(fine.size()) {
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        const std::vector<double> c = refined_spline(coarse, i, fine);
        std::size_t from = 0, to = c.size();
        while (from + 1 < to && c[from] == 0) ++from;
        while (to > from + 1 && c[to - 1] == 0) --to;
        first_.push_back(from);
        weights_.emplace_back(c.begin() + static_cast<std::ptrdiff_t>(from),
                              c.begin() + static_cast<std::ptrdiff_t>(to));
    }
}

std::vector<double> Inclusion::reduced(const std::vector<double>& products,
                                       std::size_t width) const {
    std::vector<double> result(coarse() * width, 0.0);
    for (std::size_t i = 0; i < coarse(); ++i) {
        num::add_combination(weights_[i], std::span(products).subspan(first_[i] * width),
                             std::span(result).subspan(i * width, width));
    }
    return result;
}

std::vector<double> Inclusion::refined(const std::vector<double>& coefficients,
                                       std::size_t width) const {
    std::vector<double> result(fine() * width, 0.0);
    for (std::size_t i = 0; i < coarse(); ++i) {
        for (std::size_t k = 0; k < weights_[i].size(); ++k) {
            num::add_times(weights_[i][k], std::span(coefficients).subspan(i * width, width),
                           std::span(result).subspan((first_[i] + k) * width, width));
        }
    }
    return result;
}

std::vector<double> InclusionPair::reduced(const std::vector<double>& products) const {
    const std::vector<double> half = x.reduced(products, y.fine());
    return num::transposed(y.reduced(num::transposed(half, x.coarse()), x.coarse()), y.coarse());
}

std::vector<double> InclusionPair::refined(const std::vector<double>& coefficients) const {
    const std::vector<double> half = x.refined(coefficients, y.coarse());
    return num::transposed(y.refined(num::transposed(half, x.fine()), x.fine()), y.fine());
}

}  // namespace batten::surface_fitting
