#include "make/fit/growth.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/interval_rows.hpp"
#include "make/fit/moments.hpp"
#include "make/fit/ring_rank.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

/// How much the highest derivatives of the functions that live at a simple knot jump there, but for a
/// factor common to all: each is a divided difference of truncated powers [deBoor2001, IX(1)].
void jumps_of_highest(const double* knot, int order, double* a) {
    const double unit = 1 / (knot[order] - knot[-order]);
    double left[num::most_order + 1], right[num::most_order + 1];
    left[0] = right[0] = 1;
    for (int l = 1; l <= order; ++l) {
        left[l] = left[l - 1] * ((*knot - knot[-l]) * unit);
        right[l] = right[l - 1] * ((*knot - knot[l]) * unit);
    }
    // The function of the knots j - order ... j from here.
    for (int j = 0; j <= order; ++j) {
        a[j] = (knot[j] - knot[j - order]) * unit / (left[order - j] * right[j]);
    }
}

}  // namespace

Growth::Growth(const Samples& samples, const LocalBasis& basis, Ends ends, Interval domain)
    : samples_(&samples),
      basis_(&basis),
      now_{KnotSystem(basis, {basis.order(), static_cast<int>(samples.sides.size())}, ends)} {
    now_.pieces.push_back({domain, {}, -1});
    reweigh(samples);
}

void Growth::reweigh(const Samples& samples) {
    samples_ = &samples;
    reducer_ = std::make_unique<Reducer>(samples, *basis_);
    tree_.reset();
    if (samples.size() > tree_from) {
        const Interval domain{now_.pieces.front().span.lo, now_.pieces.back().span.hi};
        tree_ = std::make_unique<ReductionTree>(*reducer_, domain);
    }
    restart(breaks());
}

void Growth::restart(std::span<const double> breaks) {
    now_.is_solved = false;
    now_.pieces.clear();
    Rows rest{0, samples_->size()};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const RightEnd end = i + 2 == breaks.size() ? RightEnd::closed : RightEnd::open;
        const Interval span{breaks[i], breaks[i + 1]};
        const Rows rows = rows_in(*samples_, rest, span, end);
        rest.first = rows.last;
        now_.pieces.push_back(piece_of(span, rows));
    }
    if (tree_ && now_.pieces.size() == 1) now_.pieces[0].node = 0;
    now_.triangles.assign(now_.pieces.size() * reducer_->shape().size(), 0.0);
    for (std::size_t i = 0; i < now_.pieces.size(); ++i) make_triangle(i);
    index_knots();
    now_.blocks.resize(now_.pieces.size() * now_.system.block_size());
    now_.maps.resize(now_.pieces.size() * map_size());
    now_.is_stale.assign(now_.pieces.size(), 1);
}

Growth::Piece Growth::piece_of(Interval span, Rows rows) const {
    return {span, rows, -1, count_places(*samples_, rows, span, now_.system.order())};
}

void Growth::make_triangle(std::size_t i) {
    const Piece& piece = now_.pieces[i];
    if (piece.node >= 0) {
        std::copy_n(tree_->triangle(piece.node), reducer_->shape().size(), triangle(i));
    } else if (tree_ && piece.rows.count() > 2 * ReductionTree::leaf_rows) {
        const RightEnd end = i + 1 == now_.pieces.size() ? RightEnd::closed : RightEnd::open;
        tree_->over(piece.span, end, triangle(i));
    } else {
        reducer_->reduce(piece.rows, piece.span, Rest::wanted, triangle(i));
    }
}

std::vector<double> Growth::breaks() const {
    std::vector<double> result;
    for (const Piece& piece : now_.pieces) result.push_back(piece.span.lo);
    result.push_back(now_.pieces.back().span.hi);
    return result;
}

int Growth::functions() const {
    return ends() == Ends::closed ? intervals() : intervals() + now_.system.order() - 1;
}

void Growth::index_knots() {
    if (ends() == Ends::closed) {
        now_.knots = closed_knots(breaks(), now_.system.order());
    } else {
        const std::size_t more = static_cast<std::size_t>(now_.system.order()) - 1;
        now_.knots.assign(more, now_.pieces.front().span.lo);
        for (const Piece& piece : now_.pieces) now_.knots.push_back(piece.span.lo);
        now_.knots.insert(now_.knots.end(), more + 1, now_.pieces.back().span.hi);
    }
    now_.firsts.resize(now_.pieces.size());
    for (std::size_t i = 0; i < now_.firsts.size(); ++i) now_.firsts[i] = static_cast<int>(i);
}

void Growth::make_stale_blocks() {
    const std::size_t shift = static_cast<std::size_t>(now_.system.order()) - 1;
    if (now_.firsts.size() != now_.pieces.size()) index_knots();
    for (std::size_t i = 0; i < now_.pieces.size(); ++i) {
        if (!now_.is_stale[i]) continue;
        now_.is_stale[i] = 0;
        double* const map = now_.maps.data() + i * map_size();
        now_.system.to_chebyshev(now_.knots, i + shift, map);
        now_.system.make_block_from(map, triangle(i), now_.blocks.data() + i * now_.system.block_size());
    }
}

void Growth::refit() {
    if (now_.is_solved) return;
    now_.is_solved = true;
    make_stale_blocks();
    now_.system.solve(functions(), now_.firsts, now_.blocks);
    now_.part_sums.resize(now_.pieces.size());
    now_.delta2 = 0;
    const TriangleShape& shape = reducer_->shape();
    for (std::size_t i = 0; i < now_.pieces.size(); ++i) {
        const double* const block = now_.blocks.data() + i * now_.system.block_size();
        now_.part_sums[i] =
            now_.system.squared_rest(now_.firsts[i], block) + triangle(i)[shape.rest()];
        now_.delta2 += now_.part_sums[i];
    }
}

void Growth::residuals(std::span<double> out) const {
    const int k = now_.system.order();
    double p[num::most_order];
    for (std::size_t i = 0; i < now_.pieces.size(); ++i) {
        const double* const b = now_.maps.data() + i * map_size();
        const double* const c = now_.system.coefficients(0).data() + now_.firsts[i];
        for (int a = 0; a < k; ++a) {
            p[a] = 0;
            for (int j = 0; j < k; ++j) p[a] += b[a * k + j] * c[j];
        }
        const std::size_t first = now_.pieces[i].rows.first;
        fitting::residuals({samples_->x.data() + first, samples_->sides[0].data() + first, nullptr,
                            now_.pieces[i].rows.count()},
                           LocalScale(now_.pieces[i].span), k, p, out.data() + first);
    }
}

bool Growth::can_split(int index) const {
    const Piece& piece = now_.pieces[static_cast<std::size_t>(index)];
    const double middle = knot_between(piece.span);
    if (!(piece.span.lo < middle && middle < piece.span.hi)) return false;
    const Rows left = rows_in(*samples_, piece.rows, {piece.span.lo, middle}, RightEnd::open);
    if (piece.rows.count() == 0) return false;
    const int order = now_.system.order();
    const PlaceCounts halves[] = {
        count_places(*samples_, left, {piece.span.lo, middle}, order),
        count_places(*samples_, {left.last, piece.rows.last}, {middle, piece.span.hi}, order)};
    // Enough for all functions that live there: then no other interval has to lend any.
    if (halves[0].inside == order && halves[1].inside == order) return true;
    if (ends() == Ends::closed) {
        std::vector<double> split = breaks();
        split.insert(split.begin() + index + 1, middle);
        return can_take(split);
    }
    SimpleRank rank(order);
    for (int i = 0; i < intervals(); ++i) {
        if (i == index) rank.add(halves[0]);
        rank.add(i == index ? halves[1] : now_.pieces[static_cast<std::size_t>(i)].places);
    }
    return rank.rank() == functions() + 1;
}

bool Growth::is_determined() const {
    SimpleRank rank(now_.system.order());
    for (const Piece& piece : now_.pieces) rank.add(piece.places);
    return rank.rank() == functions();
}

bool Growth::can_take(std::span<const double> breaks) const {
    const int n = static_cast<int>(breaks.size()) - 1;
    if (ends() == Ends::closed) {
        if (static_cast<std::size_t>(n) > samples_->size()) return false;
        return ring_rank(closed_knots(breaks, now_.system.order()), *basis_, *samples_).rank == n;
    }
    const std::vector<double> knots =
        open_knots({breaks.front(), breaks.back()}, breaks.subspan(1, breaks.size() - 2),
                   now_.system.order());
    const int functions = n + now_.system.order() - 1;
    return rank_of(cells_of(knots, now_.system.order(), *samples_), functions) == functions;
}

std::vector<int> Growth::worst(int most) const {
    std::vector<int> order(now_.pieces.size());
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
    const Piece whole = now_.pieces[i];
    const double middle = knot_between(whole.span);
    const Rows left = rows_in(*samples_, whole.rows, {whole.span.lo, middle}, RightEnd::open);
    int node = -1;
    if (whole.node >= 0) node = tree_->node(whole.node).left;
    Piece right = piece_of({middle, whole.span.hi}, {left.last, whole.rows.last});
    right.node = node >= 0 ? node + 1 : -1;
    now_.pieces[i] = piece_of({whole.span.lo, middle}, left);
    now_.pieces[i].node = node;
    now_.pieces.insert(now_.pieces.begin() + index + 1, right);
    const std::size_t size = reducer_->shape().size();
    now_.triangles.insert(now_.triangles.begin() + static_cast<std::ptrdiff_t>(i * size), size, 0.0);
    make_triangle(i);
    make_triangle(i + 1);
    const std::size_t block = now_.system.block_size();
    now_.blocks.insert(now_.blocks.begin() + static_cast<std::ptrdiff_t>(i * block), block, 0.0);
    now_.maps.insert(now_.maps.begin() + static_cast<std::ptrdiff_t>(i * map_size()), map_size(), 0.0);
    now_.is_stale.insert(now_.is_stale.begin() + index, 1);
    age_blocks(i, 2);
    return middle;
}

/// The B-splines of `count` intervals from i on have changed, and those of degree - 1 around.
void Growth::age_blocks(std::size_t i, std::size_t count) {
    now_.is_solved = false;
    const std::size_t reach = static_cast<std::size_t>(now_.system.order()) - 1;
    const bool is_open = ends() == Ends::open;
    const std::size_t first = is_open && i > reach ? i - reach : 0;
    const std::size_t last = is_open ? std::min(now_.pieces.size(), i + count + reach) : now_.pieces.size();
    std::fill(now_.is_stale.begin() + static_cast<std::ptrdiff_t>(first),
              now_.is_stale.begin() + static_cast<std::ptrdiff_t>(last), 1);
}

std::vector<double> Growth::losses() const {
    // One equation each, that the highest derivative does not jump [LawsonHanson1974, chapter 20].
    const int k = now_.system.order(), reach = k + 1;
    const std::vector<double> inverse = now_.system.qr().inverse_band(reach);
    const double* const c = now_.system.coefficients(0).data();
    double a[num::most_order + 1];
    std::vector<double> result;
    result.reserve(now_.pieces.size());
    for (int i = 1; i < intervals(); ++i) {
        jumps_of_highest(now_.knots.data() + i + k - 1, k, a);
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
    const Piece left = now_.pieces[i - 1], right = now_.pieces[i];
    const Interval whole{left.span.lo, right.span.hi};
    const int inside = left.places.inside + right.places.at_left + right.places.inside;
    std::vector<double> merged(size, 0.0);
    reducer_->merge(triangle(i - 1), left.span, whole, merged.data());
    reducer_->merge(triangle(i), right.span, whole, merged.data());
    now_.pieces[i - 1] = {whole, {left.rows.first, right.rows.last}, -1,
                          {left.places.at_left, std::min(inside, now_.system.order()),
                           right.places.at_right}};
    std::copy(merged.begin(), merged.end(), triangle(i - 1));
    const auto take_out = [i](auto& values, std::size_t count) {
        const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * count);
        values.erase(from, from + static_cast<std::ptrdiff_t>(count));
    };
    take_out(now_.pieces, 1);
    take_out(now_.triangles, size);
    take_out(now_.blocks, now_.system.block_size());
    take_out(now_.maps, map_size());
    take_out(now_.is_stale, 1);
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
