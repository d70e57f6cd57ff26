#include "batten/measure/area.hpp"

#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "measure/areas.hpp"
#include "num/bernstein.hpp"
#include "num/gauss.hpp"
#include "num/sum.hpp"

namespace batten {
namespace bezier {
namespace {

/// Between a piece and its chord, left of the chord negative: 1/2 int (r - r0) x r' du. The
/// integrand has degree 2 n - 2: n nodes are exact.
double beside_chord(const Pieces& pieces, std::size_t i) {
    const auto x = pieces.position(i, 0), y = pieces.position(i, 1);
    const auto dx = pieces.hodograph(i, 0), dy = pieces.hodograph(i, 1);
    const auto integrand = [&](double u) {
        return 0.5 * ((bernstein::value(x, u) - x[0]) * bernstein::value(dy, u) -
                      (bernstein::value(y, u) - y[0]) * bernstein::value(dx, u));
    };
    const int nodes = std::min(pieces.degree(), num::most_gauss_nodes);
    return num::integrate(integrand, {0, 1}, num::gauss_legendre(nodes));
}

double polygon(const Pieces& pieces, std::size_t i) {
    double sum = 0;
    for (int k = 0; k < 2; ++k) {
        const auto c = pieces.hodograph(i, k);
        for (const double x : c) sum += std::fabs(x) / static_cast<double>(c.size());
    }
    return sum;
}

}  // namespace

void require_dimension(const Curve& curve, int dim) {
    if (curve.dim() != dim) {
        throw Error("curve.dimension", "curve", std::to_string(curve.dim()) + " coordinates",
                    std::to_string(dim) + " coordinates are needed here");
    }
}

Measured area(const Pieces& pieces) {
    num::Sum value, error;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto x = pieces.position(i, 0), y = pieces.position(i, 1);
        const double beside = beside_chord(pieces, i);
        const double left = x.front() * y.back(), right = x.back() * y.front();
        value.add(beside);
        value.add(0.5 * (left - right));
        const double length = polygon(pieces, i);
        error.add(length * (pieces.defect(i) + 0x1p-51 * length) +
                  0x1p-53 * (std::fabs(left) + std::fabs(right)));
    }
    return {value.value(), error.value() + 0x1p-52 * std::fabs(value.value())};
}

}  // namespace bezier

Measured area(const Curve& curve) {
    bezier::require_dimension(curve, 2);
    const bezier::Pieces pieces(curve);
    const Measured normal = bezier::area(pieces);
    return {pieces.in_data(normal.value, 2), pieces.in_data(normal.error, 2)};
}

std::optional<AreasByWinding> areas_by_winding(const Curve& curve) {
    bezier::require_dimension(curve, 2);
    const bezier::Pieces pieces(curve);
    const auto normal = bezier::areas_by_winding(pieces, bezier::area(pieces).value);
    if (!normal) return std::nullopt;
    return AreasByWinding{pieces.in_data(normal->positive, 2),
                          pieces.in_data(normal->negative, 2)};
}

}  // namespace batten
