#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "num/bernstein.hpp"

/// Polynomials c[0] T_0(x) + ... + c[n] T_n(x) on -1 <= x <= 1.
///
/// On the ellipse with foci -1, 1 and semi-axes (rho +- 1 / rho) / 2 |T_k| is at most
/// (rho^k + rho^-k) / 2, which bounds a polynomial in the complex plane [Trefethen2013, chapter 8].
namespace batten::chebyshev {

using bernstein::Coefficients;
using bernstein::View;

/// The sum at x by Clenshaw's recurrence [DLMF, 3.11(ii)].
inline double value(View c, double x) {
    double b1 = 0, b2 = 0;
    for (std::size_t k = c.size() - 1; k > 0; --k) {
        const double b = c[k] + (2 * x * b1 - b2);
        b2 = b1;
        b1 = b;
    }
    return c[0] + (x * b1 - b2);
}

/// Changes of basis for one degree: three matrices made once.
class Basis {
public:
    explicit Basis(std::size_t degree);

    std::size_t degree() const { return degree_; }
    /// From Bernstein coefficients over u = (1 + x) / 2.
    void from_bernstein(View b, double* out) const { apply(from_bernstein_, b, out); }
    /// The same polynomial over x in [-1, 0] or [0, 1], each again on [-1, 1].
    void left_half(View c, double* out) const { apply(left_, c, out); }
    void right_half(View c, double* out) const { apply(right_, c, out); }

private:
    void apply(const std::vector<double>& matrix, View in, double* out) const;

    std::size_t degree_;
    std::vector<double> from_bernstein_, left_, right_;
};

/// The number of nodes, at least 2, with which Gauss-Legendre quadrature over [-1, 1] keeps its error below
/// `allowed`, for a function analytic in the ellipse `rho` > 1 and there not above `most`:
/// |error| <= 64/15 most rho^(-2n) / (1 - rho^-2) [Trefethen2013, theorem 19.3].
int gauss_nodes(double rho, double most, double allowed);

/// That bound for n nodes.
double gauss_bound(double rho, double most, int n);

}  // namespace batten::chebyshev
