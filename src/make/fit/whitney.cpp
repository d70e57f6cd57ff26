#include "make/fit/whitney.hpp"

#include <algorithm>

#include "make/fit/knot_system.hpp"

namespace batten::fitting {
namespace {

/// Distinct abscissae in rows, up to `most`.
int distinct(const Samples& samples, Rows rows, int most) {
    int count = 0;
    for (std::size_t r = rows.first; r < rows.last && count < most;) {
        ++count;
        const double x = samples.x[r];
        while (r < rows.last && samples.x[r] == x) ++r;
    }
    return count;
}

}  // namespace

void add_cells(std::span<const double> knots, int order, std::size_t span, const Samples& samples,
               Rows rows, std::vector<Cell>& out) {
    const int s = static_cast<int>(span);
    const double lo = knots[span], hi = knots[span + 1];
    const std::size_t functions = knots.size() - static_cast<std::size_t>(order);
    Rows inside = rows;
    while (inside.first < inside.last && samples.x[inside.first] == lo) ++inside.first;
    if (inside.first > rows.first) {
        int repeated = 0;  // functions that start here are zero here, but for a jump
        for (std::size_t i = span; knots[i] == lo; --i) {
            ++repeated;
            if (i == 0) break;
        }
        out.push_back({1, s - order + 1, std::max(s - repeated, s - order + 1)});
    }
    const bool is_last = span + 1 == functions;
    if (is_last) {
        while (inside.first < inside.last && samples.x[inside.last - 1] == hi) --inside.last;
    }
    const int count = distinct(samples, inside, order);
    if (count > 0) out.push_back({count, s - order + 1, s});
    if (is_last && inside.last < rows.last) out.push_back({1, s, s});
}

std::vector<Cell> cells_of(std::span<const double> knots, int order, const Samples& samples) {
    std::vector<Cell> cells;
    const std::vector<std::size_t> spans = spans_of(knots, order);
    Rows rest{0, samples.size()};
    for (const std::size_t s : spans) {
        const RightEnd end = s == spans.back() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples, rest, {knots[s], knots[s + 1]}, end);
        add_cells(knots, order, s, samples, rows, cells);
        rest.first = rows.last;
    }
    return cells;
}

PlaceCounts count_places(const Samples& samples, Rows rows, Interval span, int order) {
    PlaceCounts counts;
    Rows inside = rows;
    while (inside.first < inside.last && samples.x[inside.first] == span.lo) ++inside.first;
    while (inside.first < inside.last && samples.x[inside.last - 1] == span.hi) --inside.last;
    counts.at_left = inside.first > rows.first;
    counts.at_right = inside.last < rows.last;
    counts.inside = distinct(samples, inside, order);
    return counts;
}

void SimpleRank::add(const PlaceCounts& counts) {
    const int first = intervals_++, last = first + order_ - 1;
    // At a knot the function that ends there is zero, and at the left end all but the first.
    const int last_at_left = first == 0 ? 0 : std::max(first, last - 1);
    give(counts.at_left, first, last_at_left);
    give(counts.inside, first, last);
    give(counts.at_right, last, last);
}

/// To the leftmost functions without a datum of their own, as in rank_of.
void SimpleRank::give(int count, int first, int last) {
    if (count == 0) return;
    next_ = std::max(next_, first);
    const int given = std::clamp(last + 1 - next_, 0, count);
    next_ += given;
    rank_ += given;
}

namespace {

/// Calls `give(j)` for every function that gets a datum of its own.
template <class Give>
void give_data(std::span<const Cell> cells, int functions, int without, Give&& give) {
    // The cells' ranges rise with the cells: giving each datum the leftmost free function is best.
    int next = 0;
    for (const Cell& cell : cells) {
        next = std::max(next, cell.first);
        for (int i = 0; i < cell.count; ++i) {
            if (next == without) ++next;
            if (next > cell.last || next >= functions) break;
            give(next++);
        }
    }
}

}  // namespace

int rank_of(std::span<const Cell> cells, int functions, int without) {
    int rank = 0;
    give_data(cells, functions, without, [&](int) { ++rank; });
    return rank;
}

std::vector<char> dependent_functions(std::span<const Cell> cells, int functions) {
    std::vector<char> is_dependent(static_cast<std::size_t>(functions), 1);
    give_data(cells, functions, -1, [&](int j) { is_dependent[static_cast<std::size_t>(j)] = 0; });
    return is_dependent;
}

std::vector<int> undetermined_coefficients(std::span<const Cell> cells, int functions) {
    std::vector<int> open;
    const int rank = rank_of(cells, functions);
    if (rank == functions) return open;
    for (int j = 0; j < functions; ++j) {
        if (rank_of(cells, functions, j) == rank) open.push_back(j);
    }
    return open;
}

void remember_places(std::vector<double>& places, std::span<const double> x, Interval span,
                     std::size_t order) {
    const auto is_end = [&](double p) { return p == span.lo || p == span.hi; };
    std::size_t inside = 0;
    for (const double p : places) inside += !is_end(p);
    for (const double p : x) {
        if (inside >= order && !is_end(p)) continue;
        if (std::find(places.begin(), places.end(), p) != places.end()) continue;
        places.push_back(p);
        inside += !is_end(p);
    }
    std::sort(places.begin(), places.end());
}

}  // namespace batten::fitting
