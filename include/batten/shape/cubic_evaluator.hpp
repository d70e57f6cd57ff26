#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace batten {

namespace cubics {
struct Indexed;
}

/// Piecewise cubics prepared for many parameters in any order: what a piece needs lies together,
/// and an index of equal cells finds the piece.
///
/// Immutable; usable from many threads. Cost: 4 dim + 3 numbers a piece.
class CubicEvaluator {
public:
    explicit CubicEvaluator(const PiecewiseCubic& curve);

    int dim() const { return static_cast<int>(dim_); }
    Interval domain() const { return {breaks_.front(), breaks_.back()}; }

    /// For each t the value, then the derivatives up to `order` (0 to 2), dim numbers each: the
    /// bits of `Curve::jets`. A parameter outside the domain continues the first or last piece.
    ///
    /// Requires: out.size() == t.size() * (order + 1) * dim. Allocates nothing.
    /// Cost: sorted parameters 0.2 to 1 ns a value, random ones 4 ns each with 10^4 pieces, by the
    /// vectors that the processor offers; the same bits by each.
    void evaluate(std::span<const double> t, int order, std::span<double> out) const;

private:
    cubics::Indexed indexed() const;

    std::size_t dim_;
    std::vector<double> breaks_;
    std::vector<double> coefficients_;  // for each piece and coordinate c0, c1, c2, c3
    std::vector<double> last_point_;
    std::vector<std::uint32_t> first_;  // the piece each cell begins in, and the last one
    double cells_;                      // a unit of the parameter
};

}  // namespace batten
