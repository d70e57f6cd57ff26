#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "make/fit_surface/search_space.hpp"

namespace batten::surface_fitting {

/// Fits over strips that are halved one at a time.
///
/// A knot line more is a function more in its direction. Made orthonormal to those before it, it
/// leaves what they found as it is: the residuals only lose the product of a column and a row.
///
/// Cost: order M p + N q operations a line, p and q the functions so far, and one pass over the
///         coordinates of the space.
/// Accuracy: Gram-Schmidt, twice: orthonormal to rounding.
class Nested {
public:
    /// Nothing where the space does not tell the polynomials over it apart.
    static std::unique_ptr<Nested> over(const SearchSpace& space, int degree, StripRule rule);

    /// Takes in what these breaks have more. False where that is not possible; it is then no
    /// longer to be used.
    bool go_to(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks);

    /// delta2, the rule's measures, and psi where the space is of nodes.
    Misfit misfit();

private:
    /// One direction: rows of numbers, one for each of its functions or of those across.
    struct Side {
        std::vector<double> breaks;
        std::size_t functions = 0;
        std::vector<double> coordinates;  ///< of its functions
        std::vector<double> rest;         ///< residuals of its lines by the functions across
        std::vector<double> rest_sq;      ///< their squares, a sum for each line
    };

    Nested(const SearchSpace& space, int degree, StripRule rule);
    Side& side(Way way) { return sides_[way == Way::x ? 0 : 1]; }
    const Side& side(Way way) const { return sides_[way == Way::x ? 0 : 1]; }
    bool add_break(Way way, double t);
    bool add_function(Way way, const BSplineBasis& basis, std::size_t function);
    std::optional<std::vector<double>> made_orthonormal(Way way,
                                                        std::vector<double> function) const;
    void take_off(Way way, std::span<const double> function);
    std::vector<double> strips(Way way) const;
    std::vector<double> marginal_sums_sq(Way way) const;

    const SearchSpace& space_;
    int degree_;
    StripRule rule_;
    std::array<Side, 2> sides_;
    std::vector<double> residuals_;  ///< by the coordinates of the space
};

}  // namespace batten::surface_fitting
