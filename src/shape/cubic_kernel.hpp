#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "num/patch_kernel.hpp"

/// Piecewise cubics at many parameters, by the best the processor offers.
namespace batten::cubics {

/// Cubic pieces and an index of equal cells over their parameter, borrowed.
struct Indexed {
    std::size_t dim;
    std::span<const double> breaks;
    const double* coefficients;  ///< for each piece and coordinate c0, c1, c2, c3
    const double* last_point;
    const std::uint32_t* first;  ///< the piece each cell begins in, and the last one
    double cells;                ///< a unit of the parameter
    double last_cell;
};

/// The cell of t; parameters outside the domain belong to the first or last one. Grows with t,
/// roundings included: so a parameter's piece begins in its cell or is the one the cell begins in.
inline std::size_t cell_of(const Indexed& c, double t) {
    const double place = (t - c.breaks[0]) * c.cells;
    const double inner = place > 0 ? place : 0;
    return static_cast<std::size_t>(
        static_cast<std::int64_t>(inner < c.last_cell ? inner : c.last_cell));
}

/// As `CubicEvaluator::evaluate`: no sum of products is fused, so every level gives the same bits.
void evaluate(const Indexed& curve, std::span<const double> t, int order, std::span<double> out);

/// The same at a level that the processor offers, for comparisons.
void evaluate_at(patches::Level level, const Indexed& curve, std::span<const double> t, int order,
                 std::span<double> out);

}  // namespace batten::cubics
