#include "make/fit/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/moments.hpp"
#include "num/cox_de_boor.hpp"
#include "num/householder.hpp"

namespace batten::fitting {
namespace {

constexpr int batch = 32;
constexpr int most_width = num::most_order + most_sides;
constexpr double most_weight_ratio = 1e4;   // beyond, Cholesky loses more digits than reflections
constexpr double least_scaled_pivot = 1e-3;  // relative error at most 1e-16 / 1e-3

/// Cholesky of the Gram matrix; false where a scaled pivot is small.
bool factor(const Moments& m, const TriangleShape& shape, double* out) {
    const int k = shape.order, width = shape.width();
    for (int i = 0; i < k; ++i) {
        for (int j = i; j < k; ++j) {
            double g = 0.5 * (m.gram[static_cast<std::size_t>(i + j)] +
                              m.gram[static_cast<std::size_t>(j - i)]);
            const double whole = g;
            for (int l = 0; l < i; ++l) g -= out[l * width + i] * out[l * width + j];
            if (i == j) {
                if (!(g > least_scaled_pivot * whole)) return false;
                out[i * width + i] = std::sqrt(g);
            } else {
                out[i * width + j] = g / out[i * width + i];
            }
        }
        double z = m.side[static_cast<std::size_t>(i)];
        for (int l = 0; l < i; ++l) z -= out[l * width + i] * out[l * width + k];
        out[i * width + k] = z / out[i * width + i];
        for (int j = 0; j < i; ++j) out[i * width + j] = 0;
    }
    return true;
}

void back_substitute(const TriangleShape& shape, const double* triangle, double* p) {
    const int k = shape.order, width = shape.width();
    for (int i = k; i-- > 0;) {
        double value = triangle[i * width + k];
        for (int j = i + 1; j < k; ++j) value -= triangle[i * width + j] * p[j];
        p[i] = value / triangle[i * width + i];
    }
}

[[noreturn]] void refuse_ordinate(const Samples& samples, std::size_t i, double y) {
    const std::size_t row = samples.row(i);
    throw Error("points.not-finite", "row " + std::to_string(row) + ", column y",
                format_number(y), "coordinates must be finite", {row});
}

}  // namespace

Reducer::Reducer(const Samples& samples, const LocalBasis& basis)
    : samples_(samples),
      basis_(basis),
      shape_{basis.order(), static_cast<int>(samples.sides.size())} {}

void Reducer::reduce(Rows rows, Interval span, Rest rest, double* out) const {
    const LocalScale scale(span);
    const bool has_kernel = shape_.order <= most_moment_order && shape_.sides == 1;
    const bool is_many = rows.count() >= static_cast<std::size_t>(2 * shape_.order);
    if (has_kernel && is_many && reduce_by_moments(rows, scale, rest, out)) return;
    reduce_by_reflections(rows, scale, out);
}

bool Reducer::reduce_by_moments(Rows rows, LocalScale scale, Rest rest, double* out) const {
    const SampleRun run{samples_.x.data() + rows.first, samples_.sides[0].data() + rows.first,
                        samples_.sigma.empty() ? nullptr : samples_.sigma.data() + rows.first,
                        rows.count()};
    const Moments m = chebyshev_moments(run, scale, shape_.order);
    // NaN and Inf among the ordinates, or sums beyond a double: sample by sample.
    if (!std::isfinite(m.side[0])) return false;
    const double mean_weight_sq = m.gram[0] / static_cast<double>(rows.count());
    if (!(m.largest_weight_sq < most_weight_ratio * mean_weight_sq)) return false;
    if (!factor(m, shape_, out)) return false;
    double p[num::most_order];
    back_substitute(shape_, out, p);
    double rest_sq = rest == Rest::wanted ? squared_rest(run, scale, shape_.order, p) : 0;
    if (samples_.sigma.empty()) {
        for (std::size_t i = 0; i < shape_.rest(); ++i) out[i] /= samples_.common_sigma;
        rest_sq /= samples_.common_sigma * samples_.common_sigma;
    }
    out[shape_.rest()] = rest_sq;
    return true;
}

void Reducer::reduce_by_reflections(Rows rows, LocalScale scale, double* out) const {
    const int k = shape_.order, sides = shape_.sides, width = shape_.width();
    std::fill(out, out + shape_.size(), 0.0);
    double block[batch * most_width];
    double rest = 0;
    for (std::size_t first = rows.first; first < rows.last; first += batch) {
        const int count = static_cast<int>(std::min<std::size_t>(batch, rows.last - first));
        for (int i = 0; i < count; ++i) {
            double* const row = block + i * width;
            const std::size_t r = first + static_cast<std::size_t>(i);
            basis_.values(scale(samples_.x[r]), row);
            for (int s = 0; s < sides; ++s) {
                row[k + s] = samples_.sides[s][r];
                if (!std::isfinite(row[k + s])) refuse_ordinate(samples_, r, row[k + s]);
            }
            const double sigma = samples_.sigma_at(r);
            for (int j = 0; j < width; ++j) row[j] /= sigma;
        }
        num::absorb({out, static_cast<std::size_t>(width), k, width},
                    {block, count, static_cast<std::size_t>(width)});
        for (int i = 0; i < count; ++i) {
            for (int s = k; s < width; ++s) rest += block[i * width + s] * block[i * width + s];
        }
    }
    out[shape_.rest()] = rest;
}

void Reducer::merge(const double* part, Interval of, Interval whole, double* out) const {
    const int k = shape_.order, width = shape_.width();
    double map[num::most_order * num::most_order];
    double rows[num::most_order * most_width];
    basis_.restriction(whole, of, map);
    for (int i = 0; i < k; ++i) {
        for (int j = 0; j < k; ++j) {
            double sum = 0;
            for (int l = i; l <= j; ++l) sum += part[i * width + l] * map[l * k + j];
            rows[i * width + j] = sum;
        }
        for (int s = k; s < width; ++s) rows[i * width + s] = part[i * width + s];
    }
    num::absorb({out, static_cast<std::size_t>(width), k, width},
                {rows, k, static_cast<std::size_t>(width)}, num::BlockShape::triangular);
    double rest = part[shape_.rest()];
    for (int i = 0; i < k; ++i) {
        for (int s = k; s < width; ++s) rest += rows[i * width + s] * rows[i * width + s];
    }
    out[shape_.rest()] += rest;
}

}  // namespace batten::fitting
