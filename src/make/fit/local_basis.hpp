#pragma once

#include <span>
#include <vector>

#include "batten/base/interval.hpp"

/// Polynomials of one interval in its Chebyshev basis T_0(u) ... T_{order-1}(u), u in [-1, 1].
namespace batten::fitting {

/// Where a point of an interval stands: u = (x - middle) * scale.
struct LocalScale {
    double middle = 0;
    double scale = 1;

    explicit LocalScale(Interval span)
        : middle(span.lo + 0.5 * (span.hi - span.lo)), scale(2 / (span.hi - span.lo)) {}
    double operator()(double x) const { return (x - middle) * scale; }
};

/// What belongs to one order and to no interval: nodes and the matrices between values at the
/// nodes, Chebyshev coefficients, and coefficients on halves of the interval.
class LocalBasis {
public:
    explicit LocalBasis(int order);

    int order() const { return order_; }
    /// The Chebyshev points of the first kind, falling.
    std::span<const double> nodes() const { return nodes_; }
    /// T_j at all u into out[j].
    void values(double u, double* out) const;
    /// Coefficients, out[j * columns + c], from values at the nodes, values[c * order + i].
    void coefficients(const double* values, int columns, double* out) const;
    /// The matrix (order x order, upper triangular) that takes the coefficients on `whole` to the
    /// coefficients on `part`.
    void restriction(Interval whole, Interval part, double* out) const;
    /// The integral of T_j over [-1, 1].
    std::span<const double> integrals() const { return integrals_; }

private:
    void restriction(double scale, double shift, double* out) const;

    int order_;
    std::vector<double> nodes_, to_coefficients_, integrals_, left_, right_;
};

}  // namespace batten::fitting
