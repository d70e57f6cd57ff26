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
    /// Of a full knot vector, those inside `range`.
    static KnotSet of(std::span<const double> knots, Interval range);
};

/// The reduced functional J(t) = min over c of |W (y - A(t) c)|^2, its gradient, and what Levenberg
/// steps need. Splines of degree >= 1; of several sides, which share the knots, J is the sum. The
/// start of a closed one is a knot that stays.
///
/// Source: variable projection [GolubPereyra1973]; the gradient is exact, since the derivative with
/// respect to c vanishes (envelope theorem); dS/dt_l as in
/// docs/fitting.md.
class FreeFit {
public:
    FreeFit(const Samples& samples, const LocalBasis& basis, Ends ends = Ends::open);

    Interval domain() const { return samples_.range; }
    int order() const { return basis_.order(); }
    /// How often a knot may stand: once less than a jump where that is no curve.
    int most_times() const;
    /// The full knot vector, and how many functions there are over it.
    std::vector<double> knots_of(const KnotSet& set) const;
    int functions_of(const KnotSet& set) const;
    /// Coefficients of all sides.
    int parameters_of(const KnotSet& set) const;

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
    bool is_determined(int functions);
    std::size_t sides() const { return samples_.sides.size(); }
    /// Numbers of one side's slopes by one knot.
    std::size_t slope_size() const {
        return spans_.size() * static_cast<std::size_t>(order());
    }
    double* slopes_of(std::size_t side, std::size_t knot, std::size_t knots) {
        return slopes_.data() + (side * knots + knot) * slope_size();
    }
    void make_all_slopes(const KnotSet& set);
    void make_falls(std::size_t l);
    void add_slopes(std::size_t l, std::size_t v, std::size_t m);

    const Samples& samples_;
    const LocalBasis& basis_;
    SpanTriangles reduced_;
    Ends ends_;
    KnotSystem system_, slopes_system_;
    std::vector<double> knots_, blocks_, triangles_, part_sums_, rests_, longer_, slopes_,
        falls_, rows_;
    std::vector<std::size_t> spans_;
    std::vector<int> firsts_;
    std::vector<Cell> cells_;
    double rest_ = 0;
};

}  // namespace batten::fitting
