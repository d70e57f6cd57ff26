#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Tensor products of two narrow bands with a full array between: what evaluating and fitting a
/// spline surface on a grid costs.
namespace batten::num {

/// One direction: at place r the functions first[r] ... first[r] + order - 1 have the values
/// values[r * order ...], all others are zero. `first` never falls.
struct TensorSide {
    int order = 1;
    std::size_t functions = 1;
    std::vector<std::size_t> first;
    std::vector<double> values;

    std::size_t places() const { return first.size(); }
    const double* at(std::size_t place) const {
        return values.data() + place * static_cast<std::size_t>(order);
    }
};

/// A run of places.
struct PlaceRange {
    std::size_t first = 0;
    std::size_t last = 0;

    std::size_t count() const { return last - first; }
};

/// The product, prepared for one pair of sides. Borrows both.
///
/// Laws: sums run in a fixed order, so the same bits follow however rows are split.
/// Cost: order operations a place and side, one pass over the array; no allocation in `expand`.
class Tensor {
public:
    Tensor(const TensorSide& x, const TensorSide& y);

    const TensorSide& x() const { return *x_; }
    const TensorSide& y() const { return *y_; }

    /// out(r, s) = sum over i, j of x_i(r) c(i, j) y_j(s) for the x-places `rows`; `out` holds
    /// their rows only.
    void expand(std::span<const double> c, PlaceRange rows, std::span<double> out) const;
    /// g(i, j) += sum over r, s of x_i(r) z(r, s) y_j(s); `z` holds the rows of the places `rows`
    /// only.
    void contract(std::span<const double> z, PlaceRange rows, std::span<double> g) const;

private:
    struct Run {
        std::size_t first, last, function;
    };
    void flush(const double* sums, PlaceRange columns, std::size_t run, std::size_t function,
               std::span<double> g) const;

    const TensorSide* x_;
    const TensorSide* y_;
    std::vector<double> y_turned_;  ///< function after function: y_j(s) at [j * places + s]
    std::vector<Run> runs_;         ///< of y-places with the same functions, cut at blocks
    std::vector<std::size_t> block_runs_;
};

}  // namespace batten::num
