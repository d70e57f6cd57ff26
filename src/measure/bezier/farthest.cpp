#include "measure/bezier/farthest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "num/bernstein.hpp"

namespace batten::bezier {
namespace {

using bernstein::Coefficients;
using Vector = std::vector<double>;
using ArcPoints = std::vector<Coefficients>;  ///< Bernstein, coordinate by coordinate

constexpr std::size_t most_arcs = 100000;

double distance(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

Vector control_point(const ArcPoints& arc, std::size_t j) {
    Vector result;
    for (const Coefficients& c : arc) result.push_back(c[j]);
    return result;
}

/// No point of the arc is farther from `point` than this.
double reach(const ArcPoints& arc, const Vector& point) {
    double most = 0;
    for (std::size_t j = 0; j < arc[0].size(); ++j) {
        most = std::fmax(most, distance(control_point(arc, j), point));
    }
    return most;
}

/// What is nearest on the other side to one point.
struct Match {
    Foot foot;
    Vector point;
    double distance = 0;
};

class CurveTarget {
public:
    explicit CurveTarget(const Pieces& pieces) : pieces_(pieces), feet_(pieces) {}

    Match nearest(const Vector& point) const {
        const Foot foot = feet_.nearest(point);
        return {foot, pieces_.point(foot.piece, foot.u), std::sqrt(foot.distance_sq)};
    }

    /// Not more than the distance between points at the same parameter, when the part of the
    /// other curve between the feet of the ends is run through like the arc.
    double reach_between(const ArcPoints& arc, const Foot& start, const Foot& end) const {
        if (start.piece != end.piece) return std::numeric_limits<double>::infinity();
        const Interval part{std::fmin(start.u, end.u), std::fmax(start.u, end.u)};
        if (!(part.lo < part.hi)) return std::numeric_limits<double>::infinity();
        const std::size_t n = std::max<std::size_t>(
            arc[0].size() - 1, static_cast<std::size_t>(pieces_.degree()));
        ArcPoints gap;
        for (int k = 0; k < pieces_.dim(); ++k) {
            Coefficients other = bernstein::restricted(pieces_.position(start.piece, k), part);
            if (start.u > end.u) std::reverse(other.begin(), other.end());
            gap.push_back(bernstein::combination(bernstein::raised(arc[k], n), -1,
                                                 bernstein::raised(other, n)));
        }
        return reach(gap, Vector(gap.size()));
    }

private:
    const Pieces& pieces_;
    Feet feet_;
};

class PointsTarget {
public:
    PointsTarget(const Pieces& units, PointsView points) : tree_(points.dim(), {}) {
        std::vector<double> boxes;
        for (std::size_t i = 0; i < points.size(); ++i) {
            points_.push_back(units.to_normal_near(points[i]));
            boxes.insert(boxes.end(), points_.back().begin(), points_.back().end());
            boxes.insert(boxes.end(), points_.back().begin(), points_.back().end());
        }
        tree_ = BoxTree(points.dim(), std::move(boxes));
    }

    Match nearest(const Vector& point) const {
        double best = std::numeric_limits<double>::infinity();
        std::size_t which = 0;
        tree_.visit_near(point, best * best, [&](std::size_t i) {
            const double d = distance(points_[i], point);
            if (d < best) {
                best = d;
                which = i;
            }
            return best * best;
        });
        return {{}, points_[which], best};
    }

    double reach_between(const ArcPoints&, const Foot&, const Foot&) const {
        return std::numeric_limits<double>::infinity();
    }

private:
    std::vector<Vector> points_;
    BoxTree tree_;
};

/// Branch and bound: arcs in the order of how far they might reach.
template <class Target>
class FarthestSearch {
public:
    FarthestSearch(const Pieces& pieces, const Target& target, double tolerance)
        : pieces_(pieces), target_(target), tolerance_(tolerance) {}

    Farthest run() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            ArcPoints arc;
            for (int k = 0; k < pieces_.dim(); ++k) arc.emplace_back(pieces_.position(i, k));
            const std::size_t last = arc[0].size() - 1;
            const Match start = look_at(i, 0, control_point(arc, 0));
            const Match end = look_at(i, 1, control_point(arc, last));
            push({i, {0, 1}, arc, start, end, 0});
        }
        std::size_t arcs = 0;
        while (!open_.empty() && open_.top().upper > best_.distance + tolerance_ &&
               arcs++ < most_arcs) {
            const Arc arc = open_.top();
            open_.pop();
            halve(arc);
        }
        double upper = settled_;
        if (!open_.empty()) upper = std::fmax(upper, open_.top().upper);
        best_.error = std::fmax(upper - best_.distance, 0.0);
        return best_;
    }

private:
    struct Arc {
        std::size_t piece;
        Interval u;
        ArcPoints points;
        Match start, end;
        double upper;
        bool operator<(const Arc& other) const { return upper < other.upper; }
    };

    Match look_at(std::size_t piece, double u, const Vector& point) {
        const Match match = target_.nearest(point);
        if (match.distance > best_.distance) best_ = {piece, u, match.distance, 0};
        return match;
    }

    void push(Arc arc) {
        arc.upper = std::fmin(reach(arc.points, arc.start.point), reach(arc.points, arc.end.point));
        arc.upper = std::fmin(
            arc.upper, target_.reach_between(arc.points, arc.start.foot, arc.end.foot));
        if (arc.upper > best_.distance + tolerance_) {
            open_.push(std::move(arc));
        } else {
            settled_ = std::fmax(settled_, arc.upper);
        }
    }

    void halve(const Arc& arc) {
        ArcPoints left, right;
        for (const Coefficients& c : arc.points) {
            const bernstein::Halves halves = bernstein::split(c, 0.5);
            left.push_back(halves.left);
            right.push_back(halves.right);
        }
        const double u = arc.u.middle();
        const Match middle = look_at(arc.piece, u, control_point(right, 0));
        push({arc.piece, {arc.u.lo, u}, std::move(left), arc.start, middle, 0});
        push({arc.piece, {u, arc.u.hi}, std::move(right), middle, arc.end, 0});
    }

    const Pieces& pieces_;
    const Target& target_;
    double tolerance_;
    std::priority_queue<Arc> open_;
    double settled_ = 0;
    Farthest best_;
};

double largest_defect(const Pieces& pieces) {
    double most = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) most = std::fmax(most, pieces.defect(i));
    return most;
}

}  // namespace

Farthest farthest(const Pieces& a, const Pieces& b, double tolerance) {
    const Pieces other = b.in_units_of(a);
    const CurveTarget target(other);
    Farthest result = FarthestSearch(a, target, tolerance).run();
    result.error += largest_defect(a) + largest_defect(other) + a.rounding() + other.rounding();
    return result;
}

Farthest farthest(const Pieces& a, PointsView points, double tolerance) {
    const PointsTarget target(a, points);
    Farthest result = FarthestSearch(a, target, tolerance).run();
    result.error += largest_defect(a) + a.rounding();
    return result;
}

}  // namespace batten::bezier
