#pragma once

#include <cstddef>
#include <vector>

#include "batten/shape/basis.hpp"

namespace batten::surface_fitting {

/// The coefficients of spline i of a coarse basis for the splines of a fine one, which has its knots
/// and more.
///
/// Source: [CohenLycheRiesenfeld1980, algorithm 1].
std::vector<double> refined_spline(const BSplineBasis& coarse, std::size_t i,
                                   const BSplineBasis& fine);

/// The coarse splines as sums of fine ones.
class Inclusion {
public:
    Inclusion(const BSplineBasis& coarse, const BSplineBasis& fine);

    std::size_t coarse() const { return first_.size(); }
    std::size_t fine() const { return fine_; }
    /// From products with the fine splines, each with `width` numbers, those with the coarse ones.
    std::vector<double> reduced(const std::vector<double>& products, std::size_t width) const;
    /// From coefficients of the coarse splines, each of `width` numbers, those of the fine ones.
    std::vector<double> refined(const std::vector<double>& coefficients, std::size_t width) const;

private:
    std::size_t fine_;
    std::vector<std::size_t> first_;  ///< of every coarse spline: its first fine one
    std::vector<std::vector<double>> weights_;
};

/// The same in both directions, x slowest.
struct InclusionPair {
    Inclusion x, y;

    std::vector<double> reduced(const std::vector<double>& products) const;
    std::vector<double> refined(const std::vector<double>& coefficients) const;
};

}  // namespace batten::surface_fitting
