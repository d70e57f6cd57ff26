#include "measure/surface/level_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/surface/edge_crossings.hpp"

namespace batten::contouring {
namespace {

using surfaces::Sheet;

constexpr int island_halvings = 3;  // of cells that no line is seen to enter
constexpr int most_halvings = 24;
constexpr std::size_t most_parts = 20000;  // a level

/// Whether a parabola of twice the bend that was seen crosses zero more often than its ends tell.
bool may_hide_crossings(double a, double b, double bend) {
    const double most = 2 * bend, depth = 0.5 * most - std::fabs(b - a);
    if (!(depth > 0)) return false;
    if ((a >= 0) != (b >= 0)) return true;
    return std::min(std::fabs(a), std::fabs(b)) < depth * depth / (2 * most);
}

/// Whether such parabolas may be level somewhere between two edges.
bool may_be_level(double first, double second, double bend) {
    return (first >= 0) != (second >= 0) ||
           std::min(std::fabs(first), std::fabs(second)) < bend;
}

/// Sixteen Bezier ordinates of a part of a cell, of its bicubic interpolant.
using Ordinates = std::array<std::array<double, 4>, 4>;

Ordinates ordinates_of(Ordinates f) {
    for (std::array<double, 4>& row : f) row = cubic_ordinates(row);
    for (std::size_t k = 0; k < 4; ++k) {
        const std::array<double, 4> column =
            cubic_ordinates({f[0][k], f[1][k], f[2][k], f[3][k]});
        for (std::size_t i = 0; i < 4; ++i) f[i][k] = column[i];
    }
    return f;
}

/// Whether all ordinates but those of rounding's size are on one side of zero.
bool is_on_one_side(const Ordinates& b, bool above, double noise) {
    for (const std::array<double, 4>& row : b) {
        for (const double each : row) {
            if (above ? each < -noise : each > noise) return false;
        }
    }
    return true;
}

/// Whether the ordinates rise everywhere in one direction, or fall.
bool is_monotone(const Ordinates& b) {
    bool rises[2] = {true, true}, falls[2] = {true, true};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double steps[2] = {b[i][k + 1] - b[i][k], b[k + 1][i] - b[k][i]};
            for (int way = 0; way < 2; ++way) {
                rises[way] = rises[way] && steps[way] >= 0;
                falls[way] = falls[way] && steps[way] <= 0;
            }
        }
    }
    return rises[0] || falls[0] || rises[1] || falls[1];
}

double largest_of(GridView z) {
    double largest = 0;
    for (const double each : z.values()) largest = std::max(largest, std::fabs(each));
    return largest;
}

/// Crossings below `at` and the others.
std::array<std::vector<std::size_t>, 2> parted(const std::vector<std::size_t>& points,
                                               const std::vector<Crossing>& crossings, double at) {
    std::array<std::vector<std::size_t>, 2> parts;
    for (const std::size_t p : points) parts[crossings[p].along < at ? 0 : 1].push_back(p);
    return parts;
}

}  // namespace

std::size_t CellPart::count() const {
    return crossings[0].size() + crossings[1].size() + crossings[2].size() + crossings[3].size();
}

LevelLattice::LevelLattice(const Sheet& sheet, double level, double tolerance)
    : sheet_(sheet), level_(level), tolerance_(tolerance), lattice_(lattice_of(sheet)),
      heights_(lattice_.heights(sheet)), bends_(bends_of(lattice_, heights_)),
      has_kinks_(sheet.has_kinks()), parts_left_(most_parts) {
    for (const double y : lattice_.rows) knots_.push_back(sheet_.knots(y));
    noise_ = 32 * std::numeric_limits<double>::epsilon() *
             std::max(std::fabs(level), largest_of(heights_));
    const std::size_t nu = heights_.nu(), nv = heights_.nv();
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) heights_(i, j) -= level;
    }
    first_.reserve(2 * nu * nv + 1);
    for (std::size_t i = 0; i < nu; ++i) {
        for (std::size_t j = 0; j < nv; ++j) {
            for (const bool is_along_x : {true, false}) {
                first_.push_back(crossings_.size());
                if (is_along_x ? i + 1 < nu : j + 1 < nv) find_crossings({i, j, is_along_x});
            }
        }
    }
    first_.push_back(crossings_.size());
    for (std::size_t i = 0; i + 1 < nu; ++i) {
        for (std::size_t j = 0; j + 1 < nv; ++j) join_cell(i, j);
    }
}

double LevelLattice::height(std::size_t column, double share, double y) const {
    const std::size_t interval = lattice_.lines[column].interval;
    return sheet_.value_in(interval, Sheet::place({interval, share}, sheet_.knots(y)), y) - level_;
}

/// The share at which a line stands as a side of a column.
double LevelLattice::share_at(std::size_t line, std::size_t column) const {
    return line == column ? lattice_.lines[line].share
           : lattice_.lines[line].interval == lattice_.lines[column].interval
               ? lattice_.lines[line].share
               : 1;
}

void LevelLattice::find_crossings(const Edge& edge) {
    const std::size_t i = edge.i, j = edge.j;
    const double a = heights_(i, j), b = edge.is_along_x ? heights_(i + 1, j) : heights_(i, j + 1);
    const bool is_crossed = (a >= 0) != (b >= 0);
    const double bend = edge.is_along_x ? bends_.along_x(i, j) : bends_.along_y(i, j);
    const bool may_hide = may_hide_crossings(a, b, bend);
    if (!is_crossed && !may_hide) return;
    const double y = lattice_.rows[j];
    std::vector<double> found;
    const auto search = [&](const auto& value, Interval range) {
        const EdgeCrossings crossings(value, noise_);
        if (may_hide) crossings.all(range, a >= 0, b >= 0, found);
        else found.push_back(crossings.only(range));
    };
    if (edge.is_along_x) {
        const std::size_t interval = lattice_.lines[i].interval;
        const double left = Sheet::place(lattice_.lines[i], knots_[j]);
        const Interval range{left, Sheet::place(lattice_.lines[i + 1], knots_[j])};
        const Interval share{share_at(i, i), share_at(i + 1, i)};
        if (!(range.lo < range.hi)) {
            if (is_crossed) crossings_.push_back({left, y, share.lo});
            return;
        }
        search([&](double x) { return sheet_.value_in(interval, x, y) - level_; }, range);
        for (const double x : found) {
            const double along = share.lo + share.length() * (x - range.lo) / range.length();
            crossings_.push_back({x, y, share.clamp(along)});
        }
        return;
    }
    search(
        [&](double t) {
            const std::vector<double> knots = sheet_.knots(t);
            return sheet_.value_in(Sheet::home_of(lattice_.lines, i, knots),
                                   Sheet::place(lattice_.lines[i], knots), t) -
                   level_;
        },
        {y, lattice_.rows[j + 1]});
    for (const double t : found) crossings_.push_back({place(i, t), t, t});
}

std::vector<std::size_t> LevelLattice::crossings_of(const Edge& edge) const {
    const std::size_t number = 2 * (edge.i * heights_.nv() + edge.j) + (edge.is_along_x ? 0 : 1);
    std::vector<std::size_t> points;
    for (std::size_t p = first_[number]; p < first_[number + 1]; ++p) points.push_back(p);
    return points;
}

CellPart LevelLattice::cell_at(std::size_t i, std::size_t j) const {
    return {i,
            {share_at(i, i), share_at(i + 1, i)},
            {lattice_.rows[j], lattice_.rows[j + 1]},
            {heights_(i, j) >= 0, heights_(i + 1, j) >= 0, heights_(i + 1, j + 1) >= 0,
             heights_(i, j + 1) >= 0},
            {crossings_of({i, j, true}), crossings_of({i + 1, j, false}),
             crossings_of({i, j + 1, true}), crossings_of({i, j, false})},
            0};
}

void LevelLattice::join_cell(std::size_t i, std::size_t j) {
    const std::size_t nv = heights_.nv(), node = 2 * (i * nv + j);
    const auto count = [&](std::size_t edge) { return first_[edge + 1] - first_[edge]; };
    const std::size_t below = count(node), left = count(node + 1), above = count(node + 2);
    const std::size_t right = count(node + 2 * nv + 1);
    const std::size_t all = below + left + above + right;
    const double z00 = heights_(i, j), z10 = heights_(i + 1, j);
    const double z01 = heights_(i, j + 1), z11 = heights_(i + 1, j + 1);
    const double bend_x = std::max(bends_.along_x(i, j), bends_.along_x(i, j + 1));
    const double bend_y = std::max(bends_.along_y(i, j), bends_.along_y(i + 1, j));
    const double least = std::min({std::fabs(z00), std::fabs(z10), std::fabs(z01), std::fabs(z11)});
    if (all == 0 && least > 0.25 * (bend_x + bend_y)) return;
    if (column(i).is_wall) return join_wall(cell_at(i, j));
    const bool is_smooth = !may_be_level(z10 - z00, z11 - z01, bend_x) ||
                           !may_be_level(z01 - z00, z11 - z10, bend_y);
    if (is_smooth && all == 0) return;
    if (is_smooth && all == 2) {
        std::size_t ends[2], found = 0;
        for (const std::size_t edge : {node, node + 2 * nv + 1, node + 2, node + 1}) {
            for (std::size_t p = first_[edge]; p < first_[edge + 1]; ++p) ends[found++] = p;
        }
        if (join_plainly(ends, i)) return;
    }
    join_part(cell_at(i, j));
}

/// A wall has no width: lines run along it between crossings, one after the other.
void LevelLattice::join_wall(const CellPart& cell) {
    std::vector<std::size_t> points = cell.crossings[0];
    points.insert(points.end(), cell.crossings[1].begin(), cell.crossings[1].end());
    points.insert(points.end(), cell.crossings[3].begin(), cell.crossings[3].end());
    std::stable_sort(points.begin() + static_cast<std::ptrdiff_t>(cell.crossings[0].size()),
                     points.end(), [&](std::size_t a, std::size_t b) {
                         return crossings_[a].y < crossings_[b].y;
                     });
    points.insert(points.end(), cell.crossings[2].begin(), cell.crossings[2].end());
    for (std::size_t k = 0; k + 1 < points.size(); k += 2) {
        join(points[k], points[k + 1], cell.column);
    }
}

LinePiece LevelLattice::piece_between(std::size_t a, std::size_t b, std::size_t column) const {
    return {end_point(column, crossings_[a], crossings_[b]),
            end_point(column, crossings_[b], crossings_[a]), column};
}

void LevelLattice::join(std::size_t a, std::size_t b, std::size_t column) {
    graph_.join(a, b, piece_between(a, b, column));
}

/// Joins two points between which one cubic may be tried: the line turns by less than a right
/// angle. False elsewhere.
bool LevelLattice::join_plainly(const std::size_t (&ends)[2], std::size_t column) {
    const LinePiece piece = piece_between(ends[0], ends[1], column);
    const LinePoint &p = piece.a, &q = piece.b;
    const double x = q.x - p.x, y = q.y - p.y;
    const double ahead = p.dx * x + p.dy * y, onward = q.dx * x + q.dy * y;
    const bool is_plain = (ahead * onward > 0 && p.dx * q.dx + p.dy * q.dy > 0) ||
                          std::hypot(x, y) <= 1e-3 * tolerance_;
    if (is_plain) graph_.join(ends[0], ends[1], piece);
    return is_plain;
}

bool LevelLattice::is_small(const CellPart& part) const {
    const double y = part.y.middle();
    const std::vector<double> knots = sheet_.knots(y);
    const std::size_t interval = lattice_.lines[part.column].interval;
    const double width = part.share.length() * (knots[interval + 1] - knots[interval]);
    return std::hypot(width, part.y.length()) <= 0.5 * tolerance_;
}

bool LevelLattice::may_hide_more(const CellPart& part) const {
    if (part.halvings >= island_halvings) return false;
    Ordinates f;
    constexpr double thirds[] = {0, 1.0 / 3, 2.0 / 3, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 4; ++k) {
            f[i][k] = height(part.column, part.share.lo + part.share.length() * thirds[i],
                             part.y.lo + part.y.length() * thirds[k]);
        }
    }
    const Ordinates b = ordinates_of(f);
    return part.count() == 0 ? !is_on_one_side(b, part.is_above[0], noise_) : !is_monotone(b);
}

void LevelLattice::join_part(const CellPart& part) {
    const std::size_t count = part.count();
    if (count == 0 && !may_hide_more(part)) return;
    if (count == 2) {
        std::size_t ends[2], found = 0;
        for (const std::vector<std::size_t>& side : part.crossings) {
            for (const std::size_t p : side) ends[found++] = p;
        }
        if (!may_hide_more(part) && join_plainly(ends, part.column)) return;
    }
    const bool is_small_enough = is_small(part);
    if (is_small_enough || part.halvings == most_halvings || parts_left_ == 0) {
        is_certain_ = is_certain_ && is_small_enough;
        return join_ends(part);
    }
    --parts_left_;
    quarter(part);
}

/// Neighbours round the part are joined: the middle belongs to the corners of its own sign, the
/// others are cut off.
void LevelLattice::join_ends(const CellPart& part) {
    std::vector<std::size_t> round;
    for (std::size_t side = 0; side < 4; ++side) {
        const std::vector<std::size_t>& points = part.crossings[side];
        if (side < 2) round.insert(round.end(), points.begin(), points.end());
        else round.insert(round.end(), points.rbegin(), points.rend());
    }
    if (round.empty()) return;
    const bool middle =
        height(part.column, part.share.middle(), part.y.middle()) >= 0;
    // Between crossings 0 and 1 the border is on the other side than at the first corner.
    if (part.is_above[0] != middle) std::rotate(round.begin(), round.begin() + 1, round.end());
    for (std::size_t k = 0; k + 1 < round.size(); k += 2) {
        join(round[k], round[k + 1], part.column);
    }
}

std::vector<std::size_t> LevelLattice::inner_crossings(const CellPart& part, bool is_along_x,
                                                       double at, Interval range, bool lo_is_above,
                                                       bool hi_is_above) {
    const std::size_t c = part.column, interval = lattice_.lines[c].interval;
    const auto value = [&](double t) { return is_along_x ? height(c, t, at) : height(c, at, t); };
    std::vector<double> found;
    EdgeCrossings(value, noise_).all(range, lo_is_above, hi_is_above, found);
    std::vector<std::size_t> points;
    for (const double t : found) {
        const double share = is_along_x ? t : at, y = is_along_x ? at : t;
        points.push_back(crossings_.size());
        crossings_.push_back({Sheet::place({interval, share}, sheet_.knots(y)), y, t});
    }
    return points;
}

void LevelLattice::quarter(const CellPart& part) {
    const double s = part.share.middle(), t = part.y.middle();
    std::array<std::vector<std::size_t>, 2> sides[4];
    bool middles[4];
    for (std::size_t k = 0; k < 4; ++k) {
        sides[k] = parted(part.crossings[k], crossings_, k % 2 == 0 ? s : t);
        const bool lower = part.is_above[k < 2 ? k : (k + 1) % 4];
        middles[k] = lower != (sides[k][0].size() % 2 == 1);
    }
    const bool centre = height(part.column, s, t) >= 0;
    const Interval left{part.share.lo, s}, right{s, part.share.hi};
    const Interval below{part.y.lo, t}, above{t, part.y.hi};
    const auto to_left = inner_crossings(part, true, t, left, middles[3], centre);
    const auto to_right = inner_crossings(part, true, t, right, centre, middles[1]);
    const auto down = inner_crossings(part, false, s, below, middles[0], centre);
    const auto up = inner_crossings(part, false, s, above, centre, middles[2]);
    const std::size_t c = part.column;
    const int next = part.halvings + 1;
    const bool* const corner = part.is_above;
    join_part({c, left, below, {corner[0], middles[0], centre, middles[3]},
               {sides[0][0], down, to_left, sides[3][0]}, next});
    join_part({c, right, below, {middles[0], corner[1], middles[1], centre},
               {sides[0][1], sides[1][0], to_right, down}, next});
    join_part({c, right, above, {centre, middles[1], corner[2], middles[2]},
               {to_right, sides[1][1], sides[2][1], up}, next});
    join_part({c, left, above, {middles[3], centre, middles[2], corner[3]},
               {to_left, up, sides[2][0], sides[3][1]}, next});
}

/// On a wall lines run along it; which way is told by the heights beside.
LinePoint LevelLattice::point_on_wall(std::size_t c, double x, double y) const {
    const Interval domain = sheet_.domain().y;
    const double step = 1e-5 * domain.length();
    const double lo = domain.clamp(y - step), hi = domain.clamp(y + step);
    const double dx = place(c, hi) - place(c, lo), dy = hi - lo, length = std::hypot(dx, dy);
    const bool rises = sheet_.value_in(interval(c + 1), x, y) > sheet_.value_in(interval(c), x, y);
    const double sign = rises ? -1 : 1;  // the higher ground on the left
    return {x, y, sign * dx / length, sign * dy / length};
}

LinePoint LevelLattice::point_in(std::size_t c, double x, double y) const {
    if (column(c).is_wall) return point_on_wall(c, x, y);
    const HeightJet jet = sheet_.jet_in(interval(c), x, y);
    const double slope = std::hypot(jet.x, jet.y);
    if (!(slope > 0)) return {x, y, 0, 0};
    return {x, y, jet.y / slope, -jet.x / slope};
}

/// The end of a piece to `other`: where slopes jump, on the side on which the piece is.
LinePoint LevelLattice::end_point(std::size_t c, const Crossing& end,
                                  const Crossing& other) const {
    if (!has_kinks_ || column(c).is_wall) return point_in(c, end.x, end.y);
    constexpr double beside = 1e-8;  // of the piece
    LinePoint point = point_in(c, end.x + beside * (other.x - end.x),
                               end.y + beside * (other.y - end.y));
    point.x = end.x;
    point.y = end.y;
    return point;
}

}  // namespace batten::contouring
