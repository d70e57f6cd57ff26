#include "batten/measure/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/bezier/feet.hpp"
#include "num/bernstein.hpp"

namespace batten {
namespace bezier {
namespace {

using bernstein::Coefficients;
using bernstein::View;

std::vector<double> boxes(const Pieces& pieces) {
    std::vector<double> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (int k = 0; k < pieces.dim(); ++k) {
            const auto c = pieces.position(i, k);
            result.push_back(*std::min_element(c.begin(), c.end()));
        }
        for (int k = 0; k < pieces.dim(); ++k) {
            const auto c = pieces.position(i, k);
            result.push_back(*std::max_element(c.begin(), c.end()));
        }
    }
    return result;
}

/// The nearest point of one piece.
class PieceSearch {
public:
    PieceSearch(const Pieces& pieces, std::size_t piece, std::span<const double> point)
        : piece_(piece) {
        for (int k = 0; k < pieces.dim(); ++k) {
            Coefficients c(pieces.position(piece, k));
            for (double& x : c) x -= point[static_cast<std::size_t>(k)];
            away_.push_back(c);
            const View h = pieces.hodograph(piece, k);
            const Coefficients term = bernstein::product(c, h);
            slope_ = k == 0 ? term : bernstein::combination(slope_, 1, term);
            noise_ += 0x1p-50 * bernstein::bound(c) * bernstein::bound(h);
        }
    }

    Foot nearest() const {
        Foot best{piece_, 0, distance_sq(0)};
        const auto look_at = [&](double u) {
            const double d = distance_sq(u);
            if (d < best.distance_sq) best = {piece_, u, d};
        };
        for (const double u : bernstein::roots(slope_, noise_)) look_at(u);
        look_at(1);
        return best;
    }

private:
    double distance_sq(double u) const {
        double sum = 0;
        for (const Coefficients& c : away_) {
            const double x = bernstein::value(c, u);
            sum += x * x;
        }
        return sum;
    }

    std::size_t piece_;
    std::vector<Coefficients> away_;  // r - p
    Coefficients slope_;              // (r - p).r'
    double noise_ = 0;
};

}  // namespace

/// The control points differ from points of the chord by at most that, and so does the piece.
Feet::Feet(const Pieces& pieces) : pieces_(pieces), tree_(pieces.dim(), boxes(pieces)) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        double most_sq = 0;
        for (int j = 1; j < pieces.degree(); ++j) {
            const double share = static_cast<double>(j) / pieces.degree();
            double sum = 0;
            for (int k = 0; k < pieces.dim(); ++k) {
                const View c = pieces.position(i, k);
                const double off = c[static_cast<std::size_t>(j)] - (1 - share) * c.front() -
                                   share * c.back();
                sum += off * off;
            }
            most_sq = std::fmax(most_sq, sum);
        }
        thickness_.push_back(std::sqrt(most_sq) + 0x1p-50);
    }
}

double Feet::end_distance_sq(std::size_t piece, std::span<const double> point) const {
    double start = 0, end = 0;
    for (int k = 0; k < pieces_.dim(); ++k) {
        const View c = pieces_.position(piece, k);
        const double from = c.front() - point[static_cast<std::size_t>(k)];
        const double to = c.back() - point[static_cast<std::size_t>(k)];
        start += from * from;
        end += to * to;
    }
    return std::fmin(start, end);
}

double Feet::chord_distance(std::size_t piece, std::span<const double> point) const {
    double along = 0, length_sq = 0;
    for (int k = 0; k < pieces_.dim(); ++k) {
        const View c = pieces_.position(piece, k);
        const double chord = c.back() - c.front();
        along += chord * (point[static_cast<std::size_t>(k)] - c.front());
        length_sq += chord * chord;
    }
    const double share = length_sq > 0 ? std::clamp(along / length_sq, 0.0, 1.0) : 0;
    double sum = 0;
    for (int k = 0; k < pieces_.dim(); ++k) {
        const View c = pieces_.position(piece, k);
        const double off = point[static_cast<std::size_t>(k)] - c.front() -
                           share * (c.back() - c.front());
        sum += off * off;
    }
    return std::sqrt(sum);
}

/// First with the ends of the pieces only, then with those pieces whose chord, less what they may
/// bulge, is nearer than that.
Foot Feet::nearest(std::span<const double> point) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double limit_sq = tree_.visit_near(
        point, infinity, [&](std::size_t item) { return end_distance_sq(item, point); });
    Foot best{0, 0, infinity};
    tree_.visit_near(point, limit_sq, [&](std::size_t item) {
        const double least = chord_distance(item, point) - thickness_[item];
        const double wanted_sq = std::fmin(best.distance_sq, limit_sq);
        if (least > 0 && least * least > wanted_sq * (1 + 0x1p-45)) return wanted_sq;
        const Foot foot = PieceSearch(pieces_, item, point).nearest();
        if (foot.distance_sq < best.distance_sq ||
            (foot.distance_sq == best.distance_sq && foot.piece < best.piece)) {
            best = foot;
        }
        return best.distance_sq;
    });
    return best;
}

Nearest Feet::told(std::span<const double> point) const {
    const std::vector<double> normal = pieces_.to_normal_near(point);
    const Foot foot = nearest(normal);
    Nearest result;
    result.t = pieces_.t_of(foot.piece, foot.u);
    const Jet jet = pieces_.curve().jet_on(pieces_.source(foot.piece), result.t, 0);
    result.point.assign(jet[0].begin(), jet[0].end());
    double distance = 0;
    const std::vector<double> on_curve = pieces_.to_normal(result.point);
    for (std::size_t k = 0; k < normal.size(); ++k) {
        distance = std::hypot(distance, normal[k] - on_curve[k]);
    }
    result.distance = pieces_.in_data(distance, 1);
    result.side = side(foot, normal, on_curve);
    return result;
}

int Feet::side(const Foot& foot, std::span<const double> point,
               std::span<const double> on_curve) const {
    if (pieces_.dim() != 2) return 0;
    const bool is_closed = pieces_.curve().is_closed();
    const std::size_t last = pieces_.size() - 1;
    std::vector<double> tangent = pieces_.direction(foot.piece, foot.u);
    tangent.resize(2);
    const auto add = [&](const std::vector<double>& other) {
        for (std::size_t k = 0; k < other.size(); ++k) tangent[k] += other[k];
    };
    if (foot.u == 0 && (foot.piece > 0 || is_closed)) {
        add(pieces_.direction(foot.piece > 0 ? foot.piece - 1 : last, 1));
    }
    if (foot.u == 1 && (foot.piece < last || is_closed)) {
        add(pieces_.direction(foot.piece < last ? foot.piece + 1 : 0, 0));
    }
    const double x = point[0] - on_curve[0], y = point[1] - on_curve[1];
    const double left = tangent[0] * y - tangent[1] * x;
    constexpr double straight_ahead = 0x1p-40;
    const double distance = std::hypot(x, y);
    if (distance <= 2 * pieces_.rounding()) return 0;
    if (std::fabs(left) <= straight_ahead * distance) return 0;
    return left > 0 ? 1 : -1;
}

}  // namespace bezier

namespace {

void require_points(const Curve& curve, PointsView points) {
    require_dimension(points, curve.dim(), curve.dim());
    require_finite(points);
}

}  // namespace

Nearest nearest(const Curve& curve, std::span<const double> point) {
    require_points(curve, {point.data(), 1, static_cast<int>(point.size())});
    const bezier::Pieces pieces(curve);
    return bezier::Feet(pieces).told(point);
}

std::vector<Nearest> nearest(const Curve& curve, PointsView points) {
    require_points(curve, points);
    const bezier::Pieces pieces(curve);
    const bezier::Feet feet(pieces);
    std::vector<Nearest> result;
    for (std::size_t i = 0; i < points.size(); ++i) result.push_back(feet.told(points[i]));
    return result;
}

}  // namespace batten
