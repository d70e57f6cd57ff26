#pragma once

#include <vector>

#include "make/fit/fixed_fit.hpp"
#include "make/fit/span_triangles.hpp"

/// delta2 as a function of the knots alone: the coefficients are always the best ones.
namespace batten::fitting {

/// Interior knots: distinct places, rising, and how often each stands.
struct KnotSet {
    std::vector<double> at;
    std::vector<int> times;

    std::size_t size() const { return at.size(); }
    int count() const;
    std::vector<double> flat() const;
};

/// The reduced functional J(t) = min over c of |W (y - A(t) c)|^2, its gradient, and what Levenberg
/// steps need. Open splines of degree >= 1, one side.
///
/// Source: variable projection [GolubPereyra1973]; the gradient is exact, since the derivative with
/// respect to c vanishes (envelope theorem); dS/dt_l as in
/// docs/fitting.md.
class FreeFit {
public:
    FreeFit(const Samples& samples, const LocalBasis& basis);

    Interval domain() const { return samples_.range; }
    int order() const { return basis_.order(); }

    /// J, or infinity where the samples do not determine the spline. Cost: O(intervals) triangles
    /// from a cache, O(p order^3).
    double value(const KnotSet& set);
    /// J and its gradient with respect to set.at; infinity as above.
    double gradient(const KnotSet& set, std::vector<double>& g);
    /// The same with Kaufman's approximation of J^T J, row by row.
    double normal_matrix(const KnotSet& set, std::vector<double>& g, std::vector<double>& matrix);
    /// delta2 of every gap (part sums), for the last set.
    const std::vector<double>& part_sums() const { return part_sums_; }

private:
    bool set_knots(const KnotSet& set);
    void make_slopes(std::size_t knot, double* out);

    const Samples& samples_;
    const LocalBasis& basis_;
    SpanTriangles reduced_;
    KnotSystem system_;
    num::BandedQr slopes_qr_;
    std::vector<double> knots_, blocks_, triangles_, part_sums_, rests_, longer_, slopes_, rows_;
    std::vector<std::size_t> spans_;
    std::vector<int> firsts_;
    std::vector<Cell> cells_;
    double rest_ = 0;
};

}  // namespace batten::fitting
