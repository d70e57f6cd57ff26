#pragma once

#include <memory>
#include <vector>

#include "make/fit/knot_system.hpp"
#include "make/fit/tally.hpp"
#include "make/fit/tree.hpp"
#include "make/fit/whitney.hpp"

namespace batten::fitting {

/// A spline with simple knots to which knots are added one at a time.
///
/// Up to `tree_from` samples every interval is reduced from its samples when it comes into being;
/// above, one pass builds a tree and halving an interval needs no samples any more.
class Growth {
public:
    static constexpr std::size_t tree_from = 2048;

    Growth(const Samples& samples, const LocalBasis& basis, Ends ends, Interval domain);
    /// The same knots, other weights.
    void reweigh(const Samples& samples);
    /// Starts from these breaks instead of one interval.
    void restart(std::span<const double> breaks);

    /// One interval.
    struct Piece {
        Interval span;
        Rows rows;
        int node = -1;  ///< of the tree, if it is one
        PlaceCounts places = {};
    };
    /// All that depends on the knots.
    struct State {
        KnotSystem system;
        std::vector<Piece> pieces = {};
        std::vector<double> triangles = {}, maps = {}, blocks = {}, knots = {}, part_sums = {};
        std::vector<char> is_stale = {};  ///< pieces whose blocks are older than their knots
        std::vector<int> firsts = {};
        double delta2 = 0;
        bool is_solved = false;
    };
    /// What there is, to come back to it without a look at the samples.
    const State& state() const { return now_; }
    void restore(const State& state) { now_ = state; }

    int intervals() const { return static_cast<int>(now_.pieces.size()); }
    int functions() const;
    Ends ends() const { return now_.system.ends(); }
    const Samples& samples() const { return *samples_; }
    std::vector<double> breaks() const;
    /// The full knot vector of the last refit.
    const std::vector<double>& knots() const { return now_.knots; }

    /// Solves for the present knots, unless that is done.
    void refit();
    double delta2() const { return now_.delta2; }
    const KnotSystem& system() const { return now_.system; }
    /// Weighted squared residuals of interval i.
    double part_sum(int i) const { return now_.part_sums[static_cast<std::size_t>(i)]; }
    Interval span(int i) const { return now_.pieces[static_cast<std::size_t>(i)].span; }
    /// Samples in interval i.
    std::size_t rows(int i) const { return now_.pieces[static_cast<std::size_t>(i)].rows.count(); }
    /// True residuals e = y - S of all samples, in data units, side 0, in rising x.
    void residuals(std::span<double> out) const;

    /// The intervals with the largest part sums that can be split, ties to the lowest: `most` at
    /// most.
    std::vector<int> worst(int most) const;
    /// Whether both halves would still determine the spline.
    bool can_split(int i) const;
    /// Whether the samples determine the spline. Open splines.
    bool is_determined() const;
    /// Whether the samples would determine a spline over these breaks.
    bool can_take(std::span<const double> breaks) const;
    /// Puts a knot in the middle of interval i; refit() is to follow. Returns the knot.
    double split(int i);

    /// How much delta2 would rise if the knot at the left end of one of the intervals 1 ... were
    /// not there: exactly (to rounding). Open splines of one side; after refit().
    std::vector<double> losses() const;
    /// Takes that knot out; refit() is to follow.
    void join(int i);

private:
    void index_knots();
    void age_blocks(std::size_t i, std::size_t count);
    void make_triangle(std::size_t i);
    void make_stale_blocks();
    std::size_t map_size() const {
        return static_cast<std::size_t>(now_.system.order() * now_.system.order());
    }
    double* triangle(std::size_t i) {
        return now_.triangles.data() + i * reducer_->shape().size();
    }
    Piece piece_of(Interval span, Rows rows) const;

    const Samples* samples_;
    const LocalBasis* basis_;
    std::unique_ptr<Reducer> reducer_;
    std::unique_ptr<ReductionTree> tree_;
    State now_;
};

/// n intervals of equal length.
std::vector<double> equal_breaks(Interval domain, std::size_t n);

}  // namespace batten::fitting
