#include "make/densify/cell_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "batten/shape/piecewise_cubic.hpp"
#include "make/densify/cell_run.hpp"

namespace batten::lagrange {
namespace {

/// Bernstein coefficients on [0, 1] of a polynomial given by its power coefficients, in place.
void to_bernstein(std::span<double> c) {
    const std::size_t n = c.size() - 1;
    double choose = 1;  // n over j
    for (std::size_t j = 1; j <= n; ++j) {
        choose = choose * static_cast<double>(n - j + 1) / static_cast<double>(j);
        c[j] /= choose;
    }
    for (std::size_t round = 1; round <= n; ++round) {
        for (std::size_t j = n; j >= round; --j) c[j] += c[j - 1];
    }
}

}  // namespace

CellCurve::CellCurve(const CellMaker& maker, bool closed)
    : joints_(maker.cells() + 1, static_cast<int>(maker.dim())),
      g_(maker.cells() * maker.terms() * maker.dim()),
      terms_(maker.terms()),
      closed_(closed) {
    for (std::size_t i = 0; i <= maker.cells(); ++i) {
        breaks_.push_back(maker.parameter(static_cast<std::ptrdiff_t>(i)));
        std::copy_n(maker.start(i), width(), joints_[i].begin());
    }
    double* next = g_.data();
    tamed_ = with_size(maker, [&](auto size) {
        return run_cells(size, maker,
                         [&](std::size_t, const double*, const double*, const double* g) {
                             next = std::copy_n(g, size.terms * size.dim, next);
                         });
    });
}

void CellCurve::point(std::size_t cell, double s, std::span<double> out) const {
    std::array<double, most_coefficients> factors;
    put_factors(s, terms_, factors.data());
    put_points(RunTimeSize{terms_, width()}, start(cell), end(cell), bubble(cell), factors.data(),
               1, out.data());
}

void CellCurve::power(std::size_t cell, int coordinate, std::span<double> out) const {
    const std::size_t k = static_cast<std::size_t>(coordinate);
    std::fill(out.begin(), out.end(), 0.0);
    out[0] = start(cell)[k];
    out[1] = end(cell)[k] - start(cell)[k];
    for (std::size_t j = 0; j < terms_; ++j) {
        const double term = bubble(cell)[j * width() + k];
        out[j + 1] -= term;
        out[j + 2] += term;
    }
}

double CellCurve::second_derivative_bound(std::size_t cell) const {
    if (terms_ == 0) return 0;
    std::array<double, most_coefficients> c;
    std::array<double, most_coefficients> norm{};
    for (int k = 0; k < dim(); ++k) {
        power(cell, k, {c.data(), terms_ + 2});
        for (std::size_t j = 0; j < terms_; ++j) {
            c[j] = static_cast<double>((j + 1) * (j + 2)) * c[j + 2];
        }
        to_bernstein({c.data(), terms_});
        for (std::size_t j = 0; j < terms_; ++j) norm[j] = std::hypot(norm[j], c[j]);
    }
    return *std::max_element(norm.begin(), norm.begin() + terms_);
}

void CellCurve::start_slope(std::size_t cell, std::span<double> out) const {
    for (std::size_t k = 0; k < width(); ++k) {
        out[k] = end(cell)[k] - start(cell)[k] - (terms_ > 0 ? bubble(cell)[k] : 0);
    }
}

void CellCurve::end_slope(std::size_t cell, std::span<double> out) const {
    for (std::size_t k = 0; k < width(); ++k) {
        double g = 0;
        for (std::size_t j = 0; j < terms_; ++j) g += bubble(cell)[j * width() + k];
        out[k] = end(cell)[k] - start(cell)[k] + g;
    }
}

void CellCurve::jets_on(std::size_t piece, std::span<const double> t, int order,
                        std::span<double> out) const {
    const std::size_t rows = static_cast<std::size_t>(order + 1);
    const double width_t = breaks_[piece + 1] - breaks_[piece];
    std::array<double, most_coefficients> c;
    const std::size_t count = std::max<std::size_t>(2, terms_ + 2);
    for (int k = 0; k < dim(); ++k) {
        power(piece, k, {c.data(), count});
        for (std::size_t i = 0; i < t.size(); ++i) {
            const double s = (t[i] - breaks_[piece]) / width_t;
            double per_width = 1;
            for (std::size_t d = 0; d < rows; ++d, per_width /= width_t) {
                double value = 0;
                for (std::size_t j = count; j-- > d;) {
                    double factor = 1;
                    for (std::size_t l = 0; l < d; ++l) factor *= static_cast<double>(j - l);
                    value = value * s + factor * c[j];
                }
                out[(i * rows + d) * width() + static_cast<std::size_t>(k)] = value * per_width;
            }
        }
    }
    // The joints are met bit for bit.
    for (std::size_t i = 0; i < t.size(); ++i) {
        const bool at_end = t[i] == breaks_[piece + 1];
        if (at_end) std::copy_n(end(piece), width(), out.data() + i * rows * width());
    }
}

Curve as_curve(const CellCurve& cells) {
    if (cells.terms() > 2) return cells;
    const std::size_t joints = cells.cells() + 1;
    const std::size_t dim = static_cast<std::size_t>(cells.dim());
    std::vector<double> block(4 * dim * joints, 0.0);
    std::array<double, 4> c{};
    for (std::size_t i = 0; i + 1 < joints; ++i) {
        const double width = cells.breaks()[i + 1] - cells.breaks()[i];
        for (std::size_t k = 0; k < dim; ++k) {
            cells.power(i, static_cast<int>(k), c);
            double per_width = 1;
            for (std::size_t j = 0; j < 4; ++j, per_width /= width) {
                block[(j * dim + k) * joints + i] = c[j] * per_width;
            }
        }
    }
    for (std::size_t k = 0; k < dim; ++k) {
        block[k * joints + joints - 1] = cells.end(joints - 2)[k];
    }
    return PiecewiseCubic::power(std::move(block), cells.dim(),
                                 {cells.breaks().begin(), cells.breaks().end()},
                                 cells.is_closed());
}

}  // namespace batten::lagrange
