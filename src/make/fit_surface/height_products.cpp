#include "make/fit_surface/height_products.hpp"

#include <algorithm>

#include "make/fit_surface/row_fits.hpp"
#include "num/clones.hpp"
#include "num/lanes.hpp"
#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t rows_read = 16;
constexpr double safe_ratio = 1e6;  // of square sums to what is left of them

/// The sum of the squares of row[s] weights[s].
BATTEN_CLONES double weighted_square_sum(const double* row, std::span<const double> weights) {
    num::Lanes sums = {};
    std::size_t s = 0;
    for (; s + num::lanes <= weights.size(); s += num::lanes) {
        num::Lanes z, w;
        num::load(row + s, z);
        num::load(weights.data() + s, w);
        z *= w;
        sums += z * z;
    }
    double sum = num::sum_of(sums);
    for (; s < weights.size(); ++s) sum += row[s] * weights[s] * (row[s] * weights[s]);
    return sum;
}

/// (a b)(r, s) of the row r.
void add_row_products(const num::TensorSide& side, std::size_t r, std::span<const double> row,
                      std::vector<double>& to) {
    for (int i = 0; i < side.order; ++i) {
        const std::size_t at = side.first[r] + static_cast<std::size_t>(i);
        num::add_times(side.at(r)[i], row, std::span(to).subspan(at * row.size(), row.size()));
    }
}

}  // namespace

HeightProducts::HeightProducts(const Nodes& nodes, const Axis& x, const Axis& y)
    : both(x.functions() * y.functions(), 0.0), x_lines(y.functions() * nodes.x.size(), 0.0),
      y_lines(x.functions() * nodes.y.size(), 0.0), nodes_(nodes), x_(x), y_(y),
      each_row_(separate_rows(rows_read)),
      tensor_(x.normal(), y.normal(), num::Tensor::Use::products), rows_(each_row_, y.plain()) {}

void HeightProducts::add(std::size_t first, std::span<const double> z) {
    const std::size_t columns = nodes_.y.size(), end = first + z.size() / columns;
    for (std::size_t r = first; r < end; r += rows_read) {
        const num::PlaceRange rows{r, std::min(end, r + rows_read)};
        add_few(rows, z.subspan((r - first) * columns, rows.count() * columns));
    }
}

void HeightProducts::add_few(num::PlaceRange rows, std::span<const double> z) {
    const std::size_t m = nodes_.x.size(), n = nodes_.y.size(), q = y_.functions();
    part_.assign(rows.count() * q, 0.0);
    tensor_.contract_apart(z, rows, y_lines, part_);
    double all = 0;
    for (std::size_t r = rows.first; r < rows.last; ++r) {
        const double weight = nodes_.x_weight[r];
        const std::size_t at = r - rows.first;
        all += weighted_square_sum(z.data() + at * n, nodes_.y_weight) * weight * weight;
        const std::span<double> row = std::span(part_).subspan(at * q, q);
        for (double& value : row) value *= weight;
        add_row_products(x_.weighted(), r, row, both);
    }
    std::vector<double> turned = num::transposed(part_, rows.count());
    y_.forward_rows(turned, rows.count());
    for (std::size_t j = 0; j < q; ++j) {
        std::copy_n(turned.data() + j * rows.count(), rows.count(),
                    x_lines.data() + j * m + rows.first);
    }
    const double left = all - num::sum_of_squares(turned);
    left_sq += all <= safe_ratio * left ? left : residual_sq(rows, z);
}

double HeightProducts::residual_sq(num::PlaceRange rows, std::span<const double> z) const {
    const std::size_t n = nodes_.y.size(), q = y_.functions(), count = rows.count();
    std::vector<double> turned = num::transposed(part_, count);
    y_.invert_rows(turned, count);
    std::vector<double> fitted(count * n);
    rows_.expand(num::transposed(turned, q), {0, count}, fitted);
    double sum = 0;
    for (std::size_t r = 0; r < count; ++r) {
        const double weight = nodes_.x_weight[rows.first + r];
        double* const e = fitted.data() + r * n;
        for (std::size_t s = 0; s < n; ++s) e[s] = weight * z[r * n + s] - e[s];
        sum += weighted_square_sum(e, nodes_.y_weight);
    }
    return sum;
}

}  // namespace batten::surface_fitting
