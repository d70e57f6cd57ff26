#pragma once

#include <optional>
#include <span>
#include <vector>

#include "make/fit/growth.hpp"

namespace batten::fitting {

/// A derivative that does not jump at a knot, though the knot's multiplicity would let it.
struct HeldDerivative {
    double at = 0;
    int derivative = 0;
};

/// The fit over one knot vector of any multiplicities.
struct FixedFit {
    std::vector<double> knots;
    KnotSystem system;
    int functions = 0;
    int rank = 0;
    std::vector<int> undetermined;
    std::vector<std::vector<double>> limited;  ///< each side's coefficients, where limits moved them
    std::vector<std::vector<double>> held;   ///< linear forms of the coefficients that limits hold
    int fixed_count = 0;                     ///< the first of these, fixed whatever the data
};

/// Solves; where coefficients are open, takes of the best those of the least squared differences.
///
/// Cost: one pass over the samples, O(p order^3).
FixedFit solve_fixed(const Samples& samples, std::vector<double> knots, const LocalBasis& basis,
                     Ends ends);

/// The same of samples that are only believed to be as they should; nothing where they are not.
std::optional<FixedFit> solve_looking(const Samples& samples, std::vector<double> knots,
                                      const LocalBasis& basis, Ends ends);

/// The same from triangles that are there already (one a span, in order). Open splines.
FixedFit solve_from(std::vector<double> knots, const LocalBasis& basis, const TriangleShape& shape,
                    Ends ends, std::span<const double> triangles, std::span<const Cell> cells);

/// S of one side as a function.
SplineFunction spline_of(const FixedFit& fixed, int side = 0);

}  // namespace batten::fitting
