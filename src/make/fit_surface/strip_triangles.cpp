#include "make/fit_surface/strip_triangles.hpp"

#include <algorithm>

#include "make/fit/whitney.hpp"
#include "num/householder.hpp"

namespace batten::surface_fitting {
namespace {

/// (-1)^j binomial(order, j), times `scale`.
std::vector<double> differences(std::size_t order, double scale) {
    std::vector<double> row{scale};
    for (std::size_t j = 0; j < order; ++j) {
        row.push_back(-row.back() * static_cast<double>(order - j) / static_cast<double>(j + 1));
    }
    return row;
}

}  // namespace

std::vector<int> open_splines(const BSplineBasis& basis, std::span<const double> places) {
    fitting::Samples samples;
    samples.x = places;
    return fitting::undetermined_coefficients(
        fitting::cells_of(basis.knots(), basis.degree() + 1, samples),
        static_cast<int>(basis.size()));
}

StripTriangles::StripTriangles(const BSplineBasis& basis, const RowFits& fits, double tie)
    : basis_(basis), fits_(fits), functions_(basis.size()),
      order_(static_cast<std::size_t>(basis.degree()) + 1), sides_(fits.axis().functions()),
      band_(tie > 0 ? std::min(order_ + 1, functions_) : order_) {
    if (tie > 0) difference_ = differences(band_ - 1, tie);
    window_.assign(band_ * (band_ + sides_), 0.0);
    rows_.reserve(functions_ * (band_ + sides_));
}

void StripTriangles::take(std::span<const double> triangle) {
    const std::size_t first = basis_.span_of_piece(strip_++) + 1 - order_;
    while (first_ < std::min(first, functions_ - band_)) advance();
    if (!triangle.empty()) absorb(triangle, order_, first - first_);
}

/// Rows of `width` splines, the first of which is `shift` beyond the window's first.
void StripTriangles::absorb(std::span<const double> rows, std::size_t width, std::size_t shift) {
    const std::size_t stride = band_ + sides_, count = rows.size() / (width + sides_);
    std::vector<double> block(count * stride, 0.0);
    for (std::size_t r = 0; r < count; ++r) {
        const double* const from = rows.data() + r * (width + sides_);
        std::copy_n(from, width, block.data() + r * stride + shift);
        std::copy_n(from + width, sides_, block.data() + r * stride + band_);
    }
    num::absorb({window_.data(), stride, static_cast<int>(band_), static_cast<int>(stride)},
                {block.data(), static_cast<int>(count), stride});
    for (std::size_t r = 0; r < count; ++r) {
        left_sq_ += fits_.norm_sq(block.data() + r * stride + band_);
    }
}

/// The window's first row is finished.
void StripTriangles::advance() {
    const std::size_t stride = band_ + sides_;
    if (!difference_.empty()) {
        std::vector<double> row = difference_;
        row.resize(stride, 0.0);
        absorb(row, band_, 0);
    }
    const auto second = window_.begin() + static_cast<std::ptrdiff_t>(stride);
    rows_.insert(rows_.end(), window_.begin(), second);
    for (std::size_t i = 0; i + 1 < band_; ++i) {
        const double* const from = window_.data() + (i + 1) * stride;
        double* const to = window_.data() + i * stride;
        std::copy_n(from + 1, band_ - 1, to);
        to[band_ - 1] = 0;
        std::copy_n(from + band_, sides_, to + band_);
    }
    std::fill(window_.end() - static_cast<std::ptrdiff_t>(stride), window_.end(), 0.0);
    ++first_;
}

std::vector<double> StripTriangles::solve() {
    while (first_ + band_ < functions_) advance();
    if (!difference_.empty()) {
        std::vector<double> row = difference_;
        row.resize(band_ + sides_, 0.0);
        absorb(row, band_, 0);
        difference_.clear();
    }
    while (first_ < functions_) advance();
    const std::size_t stride = band_ + sides_;
    std::vector<double> c(functions_ * sides_);
    for (std::size_t i = functions_; i-- > 0;) {
        const double* const row = rows_.data() + i * stride;
        double* const to = c.data() + i * sides_;
        std::copy_n(row + band_, sides_, to);
        for (std::size_t l = 1; l < band_ && i + l < functions_; ++l) {
            const double* const below = c.data() + (i + l) * sides_;
            for (std::size_t j = 0; j < sides_; ++j) to[j] -= row[l] * below[j];
        }
        const double scale = row[0] == 0 ? 0 : 1 / row[0];
        for (std::size_t j = 0; j < sides_; ++j) to[j] *= scale;
    }
    return c;
}

}  // namespace batten::surface_fitting
