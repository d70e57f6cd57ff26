#pragma once

#include <cstddef>
#include <functional>
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
/// Laws: `expand` gives the same bits however rows are split; sums run in a fixed order.
/// Cost: order operations a place and side, one pass over the array.
class Tensor {
public:
    /// What it is wanted for: products alone need less memory.
    enum class Use { all, products };
    Tensor(const TensorSide& x, const TensorSide& y, Use use = Use::all);

    const TensorSide& x() const { return *x_; }
    const TensorSide& y() const { return *y_; }

    /// out(r, s) = sum over i, j of x_i(r) c(i, j) y_j(s) for the x-places `rows`; `out` holds
    /// their rows only.
    void expand(std::span<const double> c, PlaceRange rows, std::span<double> out) const;
    /// The same block by block, stored nowhere: at (r, s) of a block the sum over i of
    /// x().at(r)[i] lines[i][s].
    struct Block {
        PlaceRange rows, columns;
        const double* const* lines;
    };
    using Visit = std::function<void(const Block& block)>;
    void for_each_block(std::span<const double> c, const Visit& visit) const;
    /// g(i, j) += sum over r, s of x_i(r) z(r, s) y_j(s); `z` holds the rows of the places `rows`
    /// only.
    void contract(std::span<const double> z, PlaceRange rows, std::span<double> g) const;
    /// The two halves of that: by_x(i, s) += sum over r of x_i(r) z(r, s), and of the places `rows`
    /// only by_y(r, j) += sum over s of z(r, s) y_j(s).
    void contract_apart(std::span<const double> z, PlaceRange rows, std::span<double> by_x,
                        std::span<double> by_y) const;

private:
    struct Run {
        std::size_t first, last, function;
    };
    struct Sums {
        const double* from;
        std::size_t stride;
    };
    class Lines;
    class Gathered;
    /// What x-places with the same functions have in common, cut to a few rows.
    PlaceRange rows_alike(std::size_t first, std::size_t last) const;
    std::span<const Run> runs_of(std::size_t block) const;
    void add_products(Sums sums, std::size_t count, std::size_t block, double* g) const;

    const TensorSide* x_;
    const TensorSide* y_;
    std::vector<double> y_turned_;   ///< for expanding: y_j(s) at [j * places + s]
    std::vector<double> y_widened_;  ///< place after place, filled up to whole vectors
    std::size_t y_width_ = 1;        ///< of one place there
    std::vector<Run> runs_;          ///< of y-places with the same functions, cut at blocks
    std::vector<std::size_t> block_runs_;
};

}  // namespace batten::num
