#include <array>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/shape/bspline.hpp"
#include "batten/shape/jet.hpp"
#include "shape/knots.hpp"

namespace batten {
namespace {

std::vector<double> knots_with(const PiecewiseCubic& curve, std::span<const int> continuity) {
    const std::span<const double> breaks = curve.breaks();
    const std::size_t skipped = curve.is_closed() ? 0 : 1;
    if (continuity.size() + skipped != curve.pieces()) {
        throw Error("bspline.continuity", "continuity", std::to_string(continuity.size()),
                    "one number a joint is needed: " + std::to_string(curve.pieces() - skipped));
    }
    std::vector<double> list(curve.is_closed() ? 0 : 4, breaks.front());
    for (std::size_t i = 0; i < continuity.size(); ++i) {
        if (continuity[i] < 0 || continuity[i] > 2) {
            throw Error("bspline.continuity", "joint " + std::to_string(i + skipped),
                        std::to_string(continuity[i]), "must be 0, 1 or 2");
        }
        list.insert(list.end(), static_cast<std::size_t>(3 - continuity[i]), breaks[i + skipped]);
    }
    list.insert(list.end(), curve.is_closed() ? 1 : 4, breaks.back());
    return list;
}

/// The polar form of one cubic piece: the control point that belongs to three knots.
double polar(const PiecewiseCubic& curve, std::size_t piece, int coordinate,
             std::span<const double> at) {
    const double start = curve.breaks()[piece], end = curve.breaks()[piece + 1];
    const auto c = [&](int power) { return curve.coefficients(power, coordinate)[piece]; };
    if (at[0] == end && at[2] == end) return curve.coefficients(0, coordinate)[piece + 1];
    const double x = at[0] - start, y = at[1] - start, z = at[2] - start;
    return c(0) + (c(1) * (x + y + z) + c(2) * (x * y + y * z + z * x)) / 3 + c(3) * x * y * z;
}

}  // namespace

PiecewiseCubic to_piecewise_cubic(const BSplineCurve& curve) {
    if (curve.is_rational()) {
        throw Error("bspline.weights", "curve", "rational", "only polynomials have cubic pieces");
    }
    if (curve.basis().degree() > 3) {
        throw Error("bspline.degree", "degree", std::to_string(curve.basis().degree()),
                    "cubic pieces hold degree 3 and less");
    }
    constexpr std::array<double, 4> factorial{1, 1, 2, 6};
    const std::span<const double> breaks = curve.breaks();
    const std::size_t joints = breaks.size();
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    std::vector<double> block(4 * dim * joints, 0.0);
    Jet jet(curve.dim(), 3);
    for (std::size_t i = 0; i + 1 < joints; ++i) {
        curve.jets_on(i, breaks.subspan(i, 1), 3, jet.values());
        for (std::size_t j = 0; j < 4 * dim; ++j) {
            block[j * joints + i] = jet.values()[j] / factorial[j / dim];
        }
    }
    curve.jets_on(joints - 2, breaks.last(1), 3, jet.values());
    for (std::size_t k = 0; k < dim; ++k) {
        block[(k + 1) * joints - 1] = curve.is_closed() ? block[k * joints] : jet.values()[k];
    }
    return PiecewiseCubic::power(std::move(block), curve.dim(), {breaks.begin(), breaks.end()},
                                 curve.is_closed());
}

BSplineCurve to_bspline(const PiecewiseCubic& curve, std::span<const int> continuity) {
    BSplineBasis basis = knots::basis_over(knots_with(curve, continuity), 3, curve.is_closed());
    Points control_points(basis.size(), curve.dim());
    std::size_t piece = 0;
    std::vector<std::size_t> piece_of_span(basis.knots().size(), 0);
    for (std::size_t s = 0; s < piece_of_span.size(); ++s) {
        piece_of_span[s] = piece;
        if (piece < curve.pieces() && basis.span_of_piece(piece) == s) ++piece;
    }
    for (std::size_t j = 0; j < control_points.size(); ++j) {
        const std::size_t at = piece_of_span[knots::widest_span(basis, j)];
        for (int k = 0; k < curve.dim(); ++k) {
            control_points(j, k) = polar(curve, at, k, basis.knots().subspan(j + 1, 3));
        }
    }
    return {std::move(basis), std::move(control_points)};
}

}  // namespace batten
