#include "batten/shape/cubic_evaluator.hpp"

#include <cassert>

#include "shape/cubic_kernel.hpp"

namespace batten {
namespace {

/// Cells a piece: where breaks lie at random, few cells hold more than one.
constexpr std::size_t cells_a_piece = 4;

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
        while (piece + 1 < pieces && cubics::cell_of(indexed(), breaks_[piece + 1]) < cell) ++piece;
        first_[cell] = static_cast<std::uint32_t>(piece);
    }
}

cubics::Indexed CubicEvaluator::indexed() const {
    return {dim_,           breaks_, coefficients_.data(), last_point_.data(), first_.data(),
            cells_, static_cast<double>(first_.size() - 2)};
}

void CubicEvaluator::evaluate(std::span<const double> t, int order, std::span<double> out) const {
    assert(order >= 0 && order <= 2);
    assert(out.size() == t.size() * static_cast<std::size_t>(order + 1) * dim_);
    cubics::evaluate(indexed(), t, order, out);
}

}  // namespace batten
