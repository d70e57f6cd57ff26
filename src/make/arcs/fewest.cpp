#include "make/arcs/fewest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace batten::arc_spline {
namespace {

using plane::Vector;

constexpr std::size_t most_exact = 300;    // points for which every choice is tried
constexpr std::size_t kept_each_count = 6;  // partial rows kept beyond that
constexpr int unreached = std::numeric_limits<int>::max();

/// A point (counted on round the ring where it is closed) and the number of its tangent.
struct State {
    std::size_t point = 0;
    std::size_t tangent = 0;
};

/// What is known of the best row that ends in a state.
struct Reached {
    int moves = unreached;
    State from;
};

class Search {
public:
    Search(const PointTask& task, const Tangents& tangents, std::size_t origin)
        : task_(task), tangents_(tangents), origin_(origin), count_(task.points.size()) {}

    std::optional<std::vector<State>> run(std::size_t first_tangent);
    Station station(State s) const {
        const std::size_t point = row_of(s.point);
        return {plane::at(task_.points, point), tangents_[point][s.tangent]};
    }
    std::optional<Moves> joined(State from, State to) const;
    /// The largest distance of the points between from the moves, arc by arc; nothing where it is
    /// beyond the tolerance or out of order.
    std::optional<std::array<double, 2>> passed(const Moves& moves, State from, State to) const;

private:
    std::size_t row_of(std::size_t point) const { return (origin_ + point) % count_; }
    std::size_t last() const { return task_.closed ? count_ : count_ - 1; }
    std::size_t proposals(std::size_t point) const { return tangents_[row_of(point)].size(); }
    Reached& reached(State s) { return reached_[first_[s.point] + s.tangent]; }
    bool is_target(State s, std::size_t first_tangent) const {
        return s.point == last() && (!task_.closed || s.tangent == first_tangent);
    }
    void expand(State from, int moves);
    /// False where no tangent at `point` can be reached that might be reached with fewer moves.
    bool reach(State from, std::size_t point, int moves);
    std::vector<State> path(State to);

    const PointTask& task_;
    const Tangents& tangents_;
    std::size_t origin_, count_;
    std::vector<std::size_t> first_;
    std::vector<Reached> reached_;
    std::vector<std::vector<State>> by_moves_;
};

std::optional<Moves> Search::joined(State from, State to) const {
    std::optional<Moves> moves = biarc(station(from), station(to));
    if (!moves) return moves;
    for (Arc& arc : moves->arcs) arc = straightened(arc, task_.max_radius);
    return moves;
}

std::optional<std::array<double, 2>> Search::passed(const Moves& moves, State from,
                                                    State to) const {
    const RowRuler ruler(moves);
    const std::size_t quarter = (to.point - from.point) / 4;
    for (std::size_t i = 1; i <= 3 && quarter > 0; ++i) {  // most that miss do so here
        const Vector here = plane::at(task_.points, row_of(from.point + i * quarter));
        if (ruler.foot(here).foot.distance > task_.tolerance) return std::nullopt;
    }
    std::array<double, 2> errors{};
    const double slack = 4 * task_.tolerance;
    double along = 0;
    Vector before = plane::at(task_.points, row_of(from.point));
    const auto in_order = [&](double next, Vector here) {
        const double ahead = next - along;
        const double most = 0.5 * std::numbers::pi * plane::norm(here - before) * (1 + 1e-9);
        return ahead >= -slack && ahead <= most + slack;
    };
    for (std::size_t k = from.point + 1; k < to.point; ++k) {
        const Vector here = plane::at(task_.points, row_of(k));
        const RowFoot nearest = ruler.foot(here);
        if (nearest.foot.distance > task_.tolerance) return std::nullopt;
        if (!in_order(nearest.foot.along, here)) return std::nullopt;
        errors[nearest.arc] = std::max(errors[nearest.arc], nearest.foot.distance);
        along = nearest.foot.along;
        before = here;
    }
    if (!in_order(ruler.length(), plane::at(task_.points, row_of(to.point)))) return std::nullopt;
    return errors;
}

bool Search::reach(State from, std::size_t point, int moves) {
    bool found = false;
    for (std::size_t b = 0; b < proposals(point); ++b) {
        const State to{point, b};
        Reached& known = reached(to);
        if (known.moves <= moves + 1) {
            found = true;
            continue;
        }
        const std::optional<Moves> step = joined(from, to);
        if (!step || !passed(*step, from, to)) continue;
        found = true;
        if (known.moves <= moves + step->count) continue;
        known = {moves + step->count, from};
        const std::size_t level = static_cast<std::size_t>(known.moves);
        if (by_moves_.size() <= level) by_moves_.resize(level + 1);
        by_moves_[level].push_back(to);
    }
    return found;
}

void Search::expand(State from, int moves) {
    const bool exact = count_ <= most_exact;
    std::size_t misses = 0, stride = 1;
    for (std::size_t j = from.point + 1; j <= last(); j += stride) {
        const std::size_t width = j - from.point;
        misses = reach(from, j, moves) ? 0 : misses + 1;
        if (misses > (exact ? 100 : 8)) return;
        if (exact) continue;
        stride = 1 + width / 16;
        if (j < last() && j + stride > last()) stride = last() - j;
    }
}

std::vector<State> Search::path(State to) {
    std::vector<State> states{to};
    while (states.back().point > 0) states.push_back(reached(states.back()).from);
    std::reverse(states.begin(), states.end());
    return states;
}

std::optional<std::vector<State>> Search::run(std::size_t first_tangent) {
    first_.assign(1, 0);
    for (std::size_t i = 0; i <= last(); ++i) first_.push_back(first_.back() + proposals(i));
    reached_.assign(first_.back(), {});
    by_moves_.assign(1, {});
    for (std::size_t a = 0; a < proposals(0); ++a) {
        if (task_.closed && a != first_tangent) continue;
        reached({0, a}).moves = 0;
        by_moves_[0].push_back({0, a});
    }
    for (std::size_t level = 0; level < by_moves_.size(); ++level) {
        std::vector<State> states = by_moves_[level];
        std::stable_sort(states.begin(), states.end(),
                         [](State a, State b) { return a.point > b.point; });
        const int moves = static_cast<int>(level);
        std::size_t expanded = 0;
        for (const State s : states) {
            if (reached(s).moves != moves) continue;  // overtaken by a shorter row
            if (is_target(s, first_tangent)) return path(s);
            if (count_ > most_exact && ++expanded > kept_each_count) break;
            expand(s, moves);
        }
    }
    return std::nullopt;
}

struct Found {
    Row row;
    std::size_t middle = 0;  ///< a joint about half way round
};

std::optional<Found> search(const PointTask& task, const Tangents& tangents, std::size_t origin) {
    std::optional<Found> best;
    const std::size_t starts = task.closed ? tangents[origin].size() : 1;
    for (std::size_t a = 0; a < starts; ++a) {
        Search search(task, tangents, origin);
        const std::optional<std::vector<State>> states = search.run(a);
        if (!states) continue;
        Row row;
        for (std::size_t k = 0; k + 1 < states->size(); ++k) {
            const State from = (*states)[k], to = (*states)[k + 1];
            const Moves moves = *search.joined(from, to);
            const std::array<double, 2> errors = *search.passed(moves, from, to);
            row.arcs.insert(row.arcs.end(), moves.begin(), moves.end());
            row.errors.insert(row.errors.end(), errors.begin(), errors.begin() + moves.count);
        }
        if (best && best->row.arcs.size() <= row.arcs.size()) continue;
        const std::size_t half = (*states)[states->size() / 2].point;
        best = Found{std::move(row), (origin + half) % task.points.size()};
    }
    return best;
}

}  // namespace

std::optional<Row> fewest_biarcs(const PointTask& task, const Tangents& tangents) {
    std::optional<Found> best = search(task, tangents, 0);
    if (!best) return std::nullopt;
    if (task.closed) {
        std::optional<Found> again = search(task, tangents, best->middle);
        if (again && again->row.arcs.size() < best->row.arcs.size()) best = std::move(again);
    }
    return std::move(best->row);
}

Row neighbour_biarcs(const PointTask& task, const Tangents& tangents) {
    const std::size_t n = task.points.size();
    Row row;
    for (std::size_t i = 0; i + 1 < n + (task.closed ? 1 : 0); ++i) {
        const std::size_t j = (i + 1) % n;
        const Station from{plane::at(task.points, i), tangents[i][0]};
        const Station to{plane::at(task.points, j), tangents[j][0]};
        Moves moves{{Arc{{from.point.x, from.point.y}, {to.point.x, to.point.y}, 0}}, 1};
        if (const std::optional<Moves> pair = biarc(from, to)) moves = *pair;
        for (const Arc& arc : moves) row.arcs.push_back(straightened(arc, task.max_radius));
    }
    row.errors.assign(row.arcs.size(), 0.0);
    return row;
}

}  // namespace batten::arc_spline
