#include "make/fit/growth.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/moments.hpp"
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
    maps_.resize(pieces_.size() * map_size());
    is_stale_.assign(pieces_.size(), 1);
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

void Growth::make_stale_blocks() {
    const std::size_t shift = static_cast<std::size_t>(system_.order()) - 1;
    if (firsts_.size() != pieces_.size()) index_knots();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (!is_stale_[i]) continue;
        is_stale_[i] = 0;
        double* const map = maps_.data() + i * map_size();
        system_.to_chebyshev(knots_, i + shift, map);
        system_.make_block_from(map, triangle(i), blocks_.data() + i * system_.block_size());
    }
}

void Growth::refit() {
    make_stale_blocks();
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
    double p[num::most_order];
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double* const b = maps_.data() + i * map_size();
        const double* const c = system_.coefficients(0).data() + firsts_[i];
        for (int a = 0; a < k; ++a) {
            p[a] = 0;
            for (int j = 0; j < k; ++j) p[a] += b[a * k + j] * c[j];
        }
        const std::size_t first = pieces_[i].rows.first;
        fitting::residuals({samples_->x.data() + first, samples_->sides[0].data() + first, nullptr,
                            pieces_[i].rows.count()},
                           LocalScale(pieces_[i].span), k, p, out.data() + first);
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
    const std::size_t order = static_cast<std::size_t>(system_.order());
    const Rows left = rows_in(*samples_, piece.rows, {piece.span.lo, middle}, RightEnd::open);
    const Rows right{left.last, piece.rows.last};
    // Enough for all functions that live there: then no other interval has to lend any.
    if (has_distinct(left, order) && has_distinct(right, order + 1)) return true;
    return rank_of(cells_with(i), functions() + 1) == functions() + 1;
}

bool Growth::has_distinct(Rows rows, std::size_t count) const {
    if (rows.count() < count + 1) return false;
    // The first may lie on the knot, where one function less is not zero.
    std::size_t found = 0;
    for (std::size_t r = rows.first + 1; r < rows.last && found < count; ++r) {
        found += samples_->x[r] > samples_->x[r - 1];
    }
    return found == count;
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

std::vector<int> Growth::worst(int most) const {
    std::vector<int> order(pieces_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return part_sum(a) > part_sum(b); });
    std::vector<int> result;
    for (const int i : order) {
        if (static_cast<int>(result.size()) == most) break;
        if (can_split(i)) result.push_back(i);
    }
    return result;
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
    const std::size_t block = system_.block_size();
    blocks_.insert(blocks_.begin() + static_cast<std::ptrdiff_t>(i * block), block, 0.0);
    maps_.insert(maps_.begin() + static_cast<std::ptrdiff_t>(i * map_size()), map_size(), 0.0);
    is_stale_.insert(is_stale_.begin() + index, 1);
    age_blocks(i, 2);
    return middle;
}

/// The B-splines of `count` intervals from i on have changed, and those of degree - 1 around.
void Growth::age_blocks(std::size_t i, std::size_t count) {
    const std::size_t reach = static_cast<std::size_t>(system_.order()) - 1;
    const bool is_open = ends() == Ends::open;
    const std::size_t first = is_open && i > reach ? i - reach : 0;
    const std::size_t last = is_open ? std::min(pieces_.size(), i + count + reach) : pieces_.size();
    std::fill(is_stale_.begin() + static_cast<std::ptrdiff_t>(first),
              is_stale_.begin() + static_cast<std::ptrdiff_t>(last), 1);
}

std::vector<double> Growth::losses() const {
    // One equation each, that the highest derivative does not jump [LawsonHanson1974, chapter 20].
    const int k = system_.order(), reach = k + 1;
    const std::vector<double> inverse = system_.qr().inverse_band(reach);
    const double* const c = system_.coefficients(0).data();
    double a[num::most_order + 1], before[num::most_order], after[num::most_order];
    std::vector<double> result;
    for (int i = 1; i < intervals(); ++i) {
        const std::size_t span = static_cast<std::size_t>(i + k - 1);
        num::basis_derivatives(knots_, span - 1, k, knots_[span], k - 1, before);
        num::basis_derivatives(knots_, span, k, knots_[span], k - 1, after);
        for (int j = 0; j <= k; ++j) a[j] = (j > 0 ? after[j - 1] : 0) - (j < k ? before[j] : 0);
        double jump = 0, norm_sq = 0;
        for (int j = 0; j <= k; ++j) {
            const double* const row = inverse.data() + (i - 1 + j) * reach;
            jump += a[j] * c[i - 1 + j];
            norm_sq += a[j] * a[j] * row[0];
            for (int l = j + 1; l <= k; ++l) norm_sq += 2 * a[j] * a[l] * row[l - j];
        }
        result.push_back(jump * jump / norm_sq);
    }
    return result;
}

void Growth::join(int index) {
    const std::size_t i = static_cast<std::size_t>(index), size = reducer_->shape().size();
    const Piece left = pieces_[i - 1], right = pieces_[i];
    const Interval whole{left.span.lo, right.span.hi};
    std::vector<double> merged(size, 0.0);
    reducer_->merge(triangle(i - 1), left.span, whole, merged.data());
    reducer_->merge(triangle(i), right.span, whole, merged.data());
    pieces_[i - 1] = {whole, {left.rows.first, right.rows.last}, -1};
    std::copy(merged.begin(), merged.end(), triangle(i - 1));
    const auto take_out = [i](auto& values, std::size_t count) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * count);
        values.erase(from, from + static_cast<std::ptrdiff_t>(count));
    };
    take_out(pieces_, 1);
    take_out(triangles_, size);
    take_out(blocks_, system_.block_size());
    take_out(maps_, map_size());
    take_out(is_stale_, 1);
    age_blocks(i - 1, 1);
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
