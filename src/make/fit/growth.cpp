#include "make/fit/growth.hpp"

#include <algorithm>
#include <cmath>

#include "num/cox_de_boor.hpp"

namespace batten::fitting {

Growth::Growth(const Samples& samples, const LocalBasis& basis, Ends ends, Interval domain)
    : samples_(&samples),
      basis_(&basis),
      system_(basis, {basis.order(), static_cast<int>(samples.sides.size())}, ends) {
    pieces_.push_back({domain, {}, -1});
    reweigh(samples);
}

void Growth::reweigh(const Samples& samples) {
    samples_ = &samples;
    reducer_ = std::make_unique<Reducer>(samples, *basis_);
    tree_.reset();
    if (samples.size() > tree_from) {
        const Interval domain{pieces_.front().span.lo, pieces_.back().span.hi};
        tree_ = std::make_unique<ReductionTree>(*reducer_, domain);
    }
    restart(breaks());
}

void Growth::restart(std::span<const double> breaks) {
    pieces_.clear();
    Rows rest{0, samples_->size()};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const RightEnd end = i + 2 == breaks.size() ? RightEnd::closed : RightEnd::open;
        const Interval span{breaks[i], breaks[i + 1]};
        const Rows rows = rows_in(*samples_, rest, span, end);
        rest.first = rows.last;
        pieces_.push_back({span, rows, -1});
    }
    if (tree_ && pieces_.size() == 1) pieces_[0].node = 0;
    triangles_.assign(pieces_.size() * reducer_->shape().size(), 0.0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) make_triangle(i);
    index_knots();
    blocks_.resize(pieces_.size() * system_.block_size());
    make_blocks(0, pieces_.size());
}

void Growth::make_triangle(std::size_t i) {
    const Piece& piece = pieces_[i];
    if (piece.node >= 0) {
        std::copy_n(tree_->triangle(piece.node), reducer_->shape().size(), triangle(i));
    } else if (tree_ && piece.rows.count() > 2 * ReductionTree::leaf_rows) {
        const RightEnd end = i + 1 == pieces_.size() ? RightEnd::closed : RightEnd::open;
        tree_->over(piece.span, end, triangle(i));
    } else {
        reducer_->reduce(piece.rows, piece.span, Rest::wanted, triangle(i));
    }
}

std::vector<double> Growth::breaks() const {
    std::vector<double> result;
    for (const Piece& piece : pieces_) result.push_back(piece.span.lo);
    result.push_back(pieces_.back().span.hi);
    return result;
}

int Growth::functions() const {
    return ends() == Ends::closed ? intervals() : intervals() + system_.order() - 1;
}

void Growth::index_knots() {
    const std::vector<double> all = breaks();
    knots_ = ends() == Ends::closed
                 ? closed_knots(all, system_.order())
                 : open_knots({all.front(), all.back()}, {all.data() + 1, all.size() - 2},
                              system_.order());
    firsts_.resize(pieces_.size());
    for (std::size_t i = 0; i < firsts_.size(); ++i) firsts_[i] = static_cast<int>(i);
}

void Growth::make_blocks(std::size_t first, std::size_t last) {
    const std::size_t shift = static_cast<std::size_t>(system_.order()) - 1;
    for (std::size_t i = first; i < last; ++i) {
        system_.make_block(knots_, i + shift, triangle(i), blocks_.data() + i * system_.block_size());
    }
}

void Growth::refit() {
    system_.solve(functions(), firsts_, blocks_);
    part_sums_.resize(pieces_.size());
    delta2_ = 0;
    const TriangleShape& shape = reducer_->shape();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        part_sums_[i] = system_.squared_rest(firsts_[i], blocks_.data() + i * system_.block_size()) +
                        triangle(i)[shape.rest()];
        delta2_ += part_sums_[i];
    }
}

void Growth::residuals(std::span<double> out) const {
    const int k = system_.order();
    double b[num::most_order * num::most_order], p[num::most_order];
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        system_.to_chebyshev(knots_, i + static_cast<std::size_t>(k) - 1, b);
        const double* const c = system_.coefficients(0).data() + firsts_[i];
        for (int a = 0; a < k; ++a) {
            p[a] = 0;
            for (int j = 0; j < k; ++j) p[a] += b[a * k + j] * c[j];
        }
        const LocalScale scale(pieces_[i].span);
        for (std::size_t r = pieces_[i].rows.first; r < pieces_[i].rows.last; ++r) {
            const double u = scale(samples_->x[r]);
            double b1 = 0, b2 = 0;
            for (int j = k - 1; j > 0; --j) {
                const double b0 = p[j] + (2 * u * b1 - b2);
                b2 = b1;
                b1 = b0;
            }
            out[r] = samples_->sides[0][r] - (p[0] + (u * b1 - b2));
        }
    }
}

std::vector<Cell> Growth::cells_with(int split) const {
    std::vector<Cell> cells;
    std::vector<double> all = breaks();
    const Piece& halved = pieces_[static_cast<std::size_t>(split)];
    const double middle = knot_between(halved.span);
    all.insert(all.begin() + split + 1, middle);
    const std::vector<double> knots =
        open_knots({all.front(), all.back()}, {all.data() + 1, all.size() - 2}, system_.order());
    std::size_t span = static_cast<std::size_t>(system_.order()) - 1;
    for (int i = 0; i < intervals(); ++i) {
        const Rows rows = pieces_[static_cast<std::size_t>(i)].rows;
        if (i != split) {
            add_cells(knots, system_.order(), span++, *samples_, rows, cells);
            continue;
        }
        const Rows left = rows_in(*samples_, rows, {halved.span.lo, middle}, RightEnd::open);
        add_cells(knots, system_.order(), span++, *samples_, left, cells);
        add_cells(knots, system_.order(), span++, *samples_, {left.last, rows.last}, cells);
    }
    return cells;
}

bool Growth::can_split(int i) const {
    const Piece& piece = pieces_[static_cast<std::size_t>(i)];
    const double middle = knot_between(piece.span);
    if (!(piece.span.lo < middle && middle < piece.span.hi)) return false;
    if (ends() == Ends::closed) {
        const Rows left = rows_in(*samples_, piece.rows, {piece.span.lo, middle}, RightEnd::open);
        return left.count() > 0 && left.count() < piece.rows.count();
    }
    if (piece.rows.count() == 0) return false;
    return rank_of(cells_with(i), functions() + 1) == functions() + 1;
}

bool Growth::can_take(std::span<const double> breaks) const {
    const int n = static_cast<int>(breaks.size()) - 1;
    if (ends() == Ends::closed) return static_cast<std::size_t>(n) <= samples_->size();
    const std::vector<double> knots =
        open_knots({breaks.front(), breaks.back()}, breaks.subspan(1, breaks.size() - 2),
                   system_.order());
    const int functions = n + system_.order() - 1;
    return rank_of(cells_of(knots, system_.order(), *samples_), functions) == functions;
}

int Growth::worst() const {
    std::vector<int> order(pieces_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return part_sum(a) > part_sum(b); });
    for (const int i : order) {
        if (can_split(i)) return i;
    }
    return -1;
}

double Growth::split(int index) {
    const std::size_t i = static_cast<std::size_t>(index);
    const Piece whole = pieces_[i];
    const double middle = knot_between(whole.span);
    const Rows left = rows_in(*samples_, whole.rows, {whole.span.lo, middle}, RightEnd::open);
    int node = -1;
    if (whole.node >= 0) node = tree_->node(whole.node).left;
    pieces_[i] = {{whole.span.lo, middle}, left, node};
    pieces_.insert(pieces_.begin() + index + 1, {{middle, whole.span.hi},
                                                 {left.last, whole.rows.last},
                                                 node >= 0 ? node + 1 : -1});
    const std::size_t size = reducer_->shape().size();
    triangles_.insert(triangles_.begin() + static_cast<std::ptrdiff_t>(i * size), size, 0.0);
    make_triangle(i);
    make_triangle(i + 1);
    index_knots();
    const std::size_t block = system_.block_size();
    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(i * block), block, 0.0);
    const std::size_t reach = static_cast<std::size_t>(system_.order());
    if (ends() == Ends::closed) {
        make_blocks(0, pieces_.size());
    } else {
        make_blocks(i > reach ? i - reach : 0, std::min(pieces_.size(), i + 2 + reach));
    }
    return middle;
}

std::vector<double> equal_breaks(Interval domain, std::size_t n) {
    std::vector<double> breaks(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(n);
        breaks[i] = domain.lo + share * (domain.hi - domain.lo);
    }
    breaks.back() = domain.hi;
    return breaks;
}

}  // namespace batten::fitting
