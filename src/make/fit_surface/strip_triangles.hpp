#pragma once

#include <span>
#include <vector>

#include "make/fit_surface/row_fits.hpp"

namespace batten::surface_fitting {

/// The splines that data at these rising places leave open, rising.
std::vector<int> open_splines(const BSplineBasis& basis, std::span<const double> places);

/// Triangles of the strips of a basis put together from left to right; the right-hand sides are
/// rows of coefficients in y.
class StripTriangles {
public:
    /// `tie`: the weight of differences between neighbouring coefficients, which continue them
    /// smoothly where data leave splines open; 0 for none. Borrows both.
    StripTriangles(const BSplineBasis& basis, const RowFits& fits, double tie);

    /// The triangle of the next strip: order rows of order splines and a right-hand side, or none.
    void take(std::span<const double> triangle);
    /// Coefficients, x functions x y functions. To be called once, after the last strip.
    std::vector<double> solve();
    /// The square sum of what no coefficients reach.
    double left_sq() const { return left_sq_; }

private:
    void absorb(std::span<const double> rows, std::size_t width, std::size_t shift);
    void advance();

    const BSplineBasis& basis_;
    const RowFits& fits_;
    std::size_t functions_, order_, sides_, band_;
    std::vector<double> difference_;     ///< times the tie; empty: none
    std::vector<double> window_;         ///< band rows of band + sides numbers
    std::size_t strip_ = 0, first_ = 0;  ///< the next strip; the window's first function
    std::vector<double> rows_;           ///< finished ones
    double left_sq_ = 0;
};

}  // namespace batten::surface_fitting
