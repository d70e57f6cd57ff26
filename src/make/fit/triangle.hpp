#pragma once

#include <cstddef>

#include "make/fit/local_basis.hpp"
#include "make/fit/samples.hpp"

/// The samples of one interval, reduced to what any spline needs to know of them.
///
/// A triangle is `order` rows of order + sides numbers, the weighted samples' QR triangle in the
/// interval's Chebyshev basis with the rotated ordinates beside it, and one number more: the
/// squared rest that no polynomial reaches. So sum w^2 (y - p)^2 = |z - R p|^2 + rest.
namespace batten::fitting {

struct TriangleShape {
    int order = 4;
    int sides = 1;

    int width() const { return order + sides; }
    std::size_t size() const { return static_cast<std::size_t>(order * width()) + 1; }
    std::size_t rest() const { return size() - 1; }
};

/// Whether the squared rest is needed (a second pass over samples that are in the cache).
enum class Rest { wanted, unwanted };

class Reducer {
public:
    Reducer(const Samples& samples, const LocalBasis& basis);

    const TriangleShape& shape() const { return shape_; }
    const LocalBasis& basis() const { return basis_; }
    const Samples& samples() const { return samples_; }

    /// The triangle of `rows` over `span`.
    ///
    /// By moments and Cholesky where the weights differ by less than 1e4 and the samples spread
    /// over the interval (scaled pivots above 1e-3), else by Householder reflections: so the
    /// error is below 1e-12 of the largest term in any case.
    void reduce(Rows rows, Interval span, Rest rest, double* out) const;

    /// Adds `part`, a triangle over `of`, to `out`, one over `whole`.
    void merge(const double* part, Interval of, Interval whole, double* out) const;

private:
    bool reduce_by_moments(Rows rows, LocalScale scale, Rest rest, double* out) const;
    void reduce_by_reflections(Rows rows, LocalScale scale, double* out) const;

    const Samples& samples_;
    const LocalBasis& basis_;
    TriangleShape shape_;
};

}  // namespace batten::fitting
