#include "batten/measure/deviation.hpp"

#include <algorithm>
#include <cmath>

#include "measure/areas.hpp"
#include "measure/bezier/farthest.hpp"
#include "num/gauss.hpp"
#include "num/sum.hpp"

namespace batten {
namespace {

using bezier::Farthest;
using bezier::Feet;
using bezier::Pieces;

double signed_distance(const Nearest& nearest) {
    return nearest.side < 0 ? -nearest.distance : nearest.distance;
}

void require_comparable(const Curve& curve, PointsView points) {
    require_dimension(points, curve.dim(), curve.dim());
    require_count(points, 1);
    require_finite(points);
}

/// int ds, int d ds and int d^2 ds along a part of the other curve.
struct Moments {
    double length = 0, first = 0, second = 0;

    Moments plus(const Moments& o) const {
        return {length + o.length, first + o.first, second + o.second};
    }
};

/// Means of the signed deviation d along the other curve.
class MeanDeviation {
public:
    MeanDeviation(const Feet& feet, const Pieces& other, double unit)
        : feet_(feet), other_(other), unit_(unit) {}

    Moments total() const {
        Moments sum;
        for (std::size_t i = 0; i < other_.size(); ++i) {
            sum = sum.plus(refined(i, {0, 1}, over(i, {0, 1}), 0));
        }
        return sum;
    }

private:
    static constexpr int nodes = 5, most_halvings = 7;
    static constexpr double tolerance = 1e-7;

    Moments over(std::size_t i, Interval u) const {
        const num::GaussRule rule = num::gauss_legendre(nodes);
        Moments sum;
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const double at = u.middle() + 0.5 * u.length() * rule.nodes[j];
            double speed = 0;
            for (int k = 0; k < other_.dim(); ++k) {
                speed = std::hypot(speed, bernstein::value(other_.hodograph(i, k), at));
            }
            const double ds = 0.5 * u.length() * rule.weights[j] * speed;
            const Nearest foot = feet_.told(other_.to_data(other_.point(i, at)));
            const double d = signed_distance(foot) / unit_;
            sum = sum.plus({ds, d * ds, d * d * ds});
        }
        return sum;
    }

    Moments refined(std::size_t i, Interval u, const Moments& whole, int halvings) const {
        const Interval left{u.lo, u.middle()}, right{u.middle(), u.hi};
        const Moments a = over(i, left), b = over(i, right);
        const Moments sum = a.plus(b);
        const bool agree = std::fabs(sum.first - whole.first) <= tolerance * sum.length &&
                           std::fabs(sum.second - whole.second) <= tolerance * sum.length;
        if (agree || halvings == most_halvings) return sum;
        return refined(i, left, a, halvings + 1).plus(refined(i, right, b, halvings + 1));
    }

    const Feet& feet_;
    const Pieces& other_;
    double unit_;
};

/// The power of two next to a deviation: in its units squares stay within a double.
double unit_of(double deviation) {
    int exponent = 0;
    std::frexp(deviation, &exponent);
    return std::ldexp(1.0, std::clamp(exponent, -1000, 1000));
}

void set_means(Deviation& result, double mean, double mean_sq, double unit) {
    result.mean = mean * unit;
    result.rms = std::sqrt(mean_sq) * unit;
}

Measured told(const Pieces& units, double value, double error) {
    return {units.in_data(value, 1), units.in_data(error, 1)};
}

}  // namespace

Deviation deviation(const Curve& curve, PointsView points, Tolerance tolerance) {
    require_comparable(curve, points);
    bezier::require_tolerance(tolerance);
    const Pieces pieces(curve);
    const Feet feet(pieces);
    std::vector<double> all;
    Deviation result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Nearest nearest = feet.told(points[i]);
        all.push_back(signed_distance(nearest));
        if (i == 0 || std::fabs(all.back()) > std::fabs(result.max)) {
            result.max = all.back();
            result.at = {nearest.t, {points[i].begin(), points[i].end()}};
        }
    }
    const double unit = unit_of(result.max), n = static_cast<double>(all.size());
    num::Sum sum, sum_sq;
    for (const double d : all) {
        sum.add(d / unit);
        sum_sq.add(d / unit * (d / unit));
    }
    set_means(result, sum.value() / n, sum_sq.value() / n, unit);
    const Farthest back = bezier::farthest(pieces, points, pieces.in_normal(tolerance));
    result.hausdorff = std::fmax(std::fabs(result.max), pieces.in_data(back.distance, 1));
    return result;
}

Deviation deviation(const Curve& curve, const Curve& other, Tolerance tolerance) {
    bezier::require_dimension(other, curve.dim());
    bezier::require_tolerance(tolerance);
    const Pieces pieces(curve), others(other);
    const Feet feet(pieces);
    const double asked = pieces.in_normal(tolerance);
    const Pieces comparable = others.in_units_of(pieces);
    const Farthest there = bezier::farthest(comparable, pieces, asked);
    const Farthest back = bezier::farthest(pieces, others, asked);
    const double t = others.t_of(there.piece, there.u);
    const Jet jet = other.jet_on(others.source(there.piece), t, 0);
    const Nearest nearest = feet.told(jet[0]);
    Deviation result;
    result.max = signed_distance(nearest);
    result.at = {nearest.t, {jet[0].begin(), jet[0].end()}};
    const double unit = unit_of(result.max);
    const Moments sum = MeanDeviation(feet, others, unit).total();
    if (sum.length > 0) set_means(result, sum.first / sum.length, sum.second / sum.length, unit);
    result.hausdorff = std::fmax(std::fabs(result.max), pieces.in_data(back.distance, 1));
    return result;
}

Measured hausdorff(const Curve& a, const Curve& b, Tolerance tolerance) {
    bezier::require_dimension(b, a.dim());
    bezier::require_tolerance(tolerance);
    const Pieces first(a), second(b);
    const double asked = first.in_normal(tolerance);
    const Farthest there = bezier::farthest(first, second, asked);
    const Farthest back = bezier::farthest(second.in_units_of(first), first, asked);
    const double value = std::fmax(there.distance, back.distance);
    const double upper =
        std::fmax(there.distance + there.error, back.distance + back.error);
    return told(first, value, upper - value);
}

Measured hausdorff(const Curve& curve, PointsView points, Tolerance tolerance) {
    require_comparable(curve, points);
    bezier::require_tolerance(tolerance);
    const Pieces pieces(curve);
    const Feet feet(pieces);
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        largest = std::fmax(largest, std::sqrt(feet.nearest(pieces.to_normal_near(points[i]))
                                                   .distance_sq));
    }
    const Farthest back = bezier::farthest(pieces, points, pieces.in_normal(tolerance));
    const double value = std::fmax(largest, back.distance);
    return told(pieces, value, std::fmax(back.distance + back.error, value) - value);
}

}  // namespace batten
