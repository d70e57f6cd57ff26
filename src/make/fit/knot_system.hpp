#pragma once

#include <span>
#include <vector>

#include "make/fit/triangle.hpp"
#include "num/banded_qr.hpp"

namespace batten::fitting {

/// Whether a spline ends, or continues at its start.
enum class Ends { open, closed };

/// `degree + 1` times the ends, the interior knots between.
std::vector<double> open_knots(Interval domain, std::span<const double> inside, int order);
/// Simple knots of one period, both ends included, continued by `degree` knots at both ends.
std::vector<double> closed_knots(std::span<const double> breaks, int order);

/// The spans of positive length of a knot vector, as indices of their left knots.
std::vector<std::size_t> spans_of(std::span<const double> knots, int order);

/// The least-squares problem over one knot vector, from the triangles of its intervals.
class KnotSystem {
public:
    KnotSystem(const LocalBasis& basis, TriangleShape shape, Ends ends)
        : basis_(&basis), shape_(shape), ends_(ends) {}

    /// Numbers of one interval's block: order rows of order + sides.
    std::size_t block_size() const { return shape_.size() - 1; }
    int order() const { return shape_.order; }
    int sides() const { return shape_.sides; }
    Ends ends() const { return ends_; }

    /// The interval's rows in terms of its B-splines' coefficients: R B, where B takes the
    /// coefficients of the span's functions to Chebyshev coefficients.
    void make_block(std::span<const double> knots, std::size_t span, const double* triangle,
                    double* block) const;
    /// The same where B is there already.
    void make_block_from(const double* b, const double* triangle, double* block) const;
    /// B itself (order x order).
    void to_chebyshev(std::span<const double> knots, std::size_t span, double* b) const;
    /// The same for coefficients on a part of the span.
    void to_chebyshev(std::span<const double> knots, std::size_t span, Interval part,
                      double* b) const;

    /// Solves for `functions` coefficients (and `shape.sides` sides): block i touches the
    /// functions firsts[i] ... firsts[i] + order - 1, counted round for a closed spline.
    void solve(int functions, std::span<const int> firsts, std::span<const double> blocks);
    /// The triangle alone, in qr(); blocks of order x (order + sides). `floors`: see BandedQr, one a
    /// function, or none.
    void factor(int functions, std::span<const int> firsts, std::span<const double> blocks,
                std::span<const double> floors = {});
    /// So many right-hand sides from now on.
    void set_sides(int sides) { shape_.sides = sides; }
    /// The same where functions depend on those eliminated before them: of the best coefficients
    /// those whose differences, of order `order` where the rank allows it, have the least sum of
    /// squares.
    void solve_smoothly(int functions, std::span<const int> firsts,
                        std::span<const double> blocks, std::span<const char> is_dependent);

    /// After solve(): the coefficients of one side; closed splines have their first `degree`
    /// repeated at the end.
    std::span<const double> coefficients(int side) const;
    /// |z - E c|^2 of a block.
    double squared_rest(int first, const double* block) const;
    const num::BandedQr& qr() const { return qr_; }
    /// Coefficient j's unknown in qr(), whose border holds the first `degree` of a closed spline.
    int unknown(int j) const;

private:
    void take_solution();
    std::size_t stored_coefficients() const;
    void set_floors(std::span<const double> floors);
    void add_closed(int first, const double* block);

    const LocalBasis* basis_;
    TriangleShape shape_;
    Ends ends_;
    int functions_ = 0;
    num::BandedQr qr_;
    std::vector<double> scratch_, solution_;
};

}  // namespace batten::fitting
