#include "batten/shape/cubic_evaluator.hpp"

#include <algorithm>
#include <cassert>

namespace batten {
namespace {

/// Cells a piece: with equal pieces, half of the cells hold no break.
constexpr std::size_t cells_a_piece = 2;

/// One coordinate of a run of parameters on one piece.
template <int Order>
void run_on(const double* c, double origin, std::span<const double> t, std::size_t stride,
            std::size_t dim, double* out) {
    const double c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3];
    for (const double at : t) {
        const double u = at - origin;
        out[0] = c0 + u * (c1 + u * (c2 + u * c3));
        if constexpr (Order > 0) out[dim] = c1 + u * (2 * c2 + u * 3 * c3);
        if constexpr (Order > 1) out[2 * dim] = 2 * c2 + u * 6 * c3;
        out += stride;
    }
}

/// The same for values alone that lie side by side, which the compiler works on in vectors.
void run_of_values(const double* c, double origin, std::span<const double> t, double* out) {
    const double c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3];
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double u = t[i] - origin;
        out[i] = c0 + u * (c1 + u * (c2 + u * c3));
    }
}

}  // namespace

CubicEvaluator::CubicEvaluator(const PiecewiseCubic& curve)
    : dim_(static_cast<std::size_t>(curve.dim())),
      breaks_(curve.breaks().begin(), curve.breaks().end()),
      coefficients_(4 * dim_ * curve.pieces()) {
    const std::size_t pieces = curve.pieces();
    for (int k = 0; k < curve.dim(); ++k) {
        for (int power = 0; power < 4; ++power) {
            const std::span<const double> column = curve.coefficients(power, k);
            for (std::size_t i = 0; i < pieces; ++i) {
                const std::size_t at = i * dim_ + static_cast<std::size_t>(k);
                coefficients_[4 * at + static_cast<std::size_t>(power)] = column[i];
            }
        }
        last_point_.push_back(curve.coefficients(0, k)[pieces]);
    }
    const std::size_t cells = cells_a_piece * pieces;
    cells_ = static_cast<double>(cells) / domain().length();
    first_.resize(cells + 1);
    std::size_t piece = 0;
    for (std::size_t cell = 0; cell <= cells; ++cell) {
        while (piece + 1 < pieces && cell_of(breaks_[piece + 1]) < cell) ++piece;
        first_[cell] = static_cast<std::uint32_t>(piece);
    }
}

/// Grows with t, roundings included: so a parameter's piece begins in its cell or is the one that
/// the cell begins in.
std::size_t CubicEvaluator::cell_of(double t) const {
    const double last = static_cast<double>(cells_a_piece * (breaks_.size() - 1) - 1);
    const double place = (t - breaks_[0]) * cells_;
    return static_cast<std::size_t>(place > 0 ? (place < last ? place : last) : 0);
}

std::size_t CubicEvaluator::piece_of(double t) const {
    const std::size_t cell = cell_of(t);
    std::size_t lo = first_[cell];
    std::size_t hi = cell + 1 < first_.size() - 1 ? first_[cell + 1] : breaks_.size() - 2;
    while (hi > lo + 1) {
        const std::size_t middle = lo + (hi - lo) / 2;
        (breaks_[middle] <= t ? lo : hi) = middle;
    }
    // Without a branch: half of the random parameters go either way.
    return lo + static_cast<std::size_t>(breaks_[lo + 1] <= t && lo < hi);
}

void CubicEvaluator::evaluate(std::span<const double> t, int order, std::span<double> out) const {
    assert(order >= 0 && order <= 2);
    const std::size_t stride = static_cast<std::size_t>(order + 1) * dim_;
    assert(out.size() == t.size() * stride);
    const double end = breaks_.back();
    for (std::size_t first = 0; first < t.size();) {
        const std::size_t piece = piece_of(t[first]);
        const double lo = breaks_[piece], hi = breaks_[piece + 1];
        std::size_t last = first + 1;
        // Where neighbours lie far apart, a loop that ends after one step is a branch mispredicted.
        const auto is_here = [&](std::size_t i) { return lo <= t[i] && t[i] < hi; };
        const bool is_run = first + 8 <= t.size() && is_here(first + 3) && is_here(first + 7);
        while (is_run && last < t.size() && is_here(last)) ++last;
        const std::span<const double> run = t.subspan(first, last - first);
        for (std::size_t k = 0; k < dim_; ++k) {
            const double* const c = coefficients_.data() + 4 * (piece * dim_ + k);
            double* const to = out.data() + first * stride + k;
            if (stride == 1) run_of_values(c, lo, run, to);
            if (order == 0 && stride > 1) run_on<0>(c, lo, run, stride, dim_, to);
            if (order == 1) run_on<1>(c, lo, run, stride, dim_, to);
            if (order == 2) run_on<2>(c, lo, run, stride, dim_, to);
            if (t[first] == end) *to = last_point_[k];
        }
        first = last;
    }
}

}  // namespace batten
