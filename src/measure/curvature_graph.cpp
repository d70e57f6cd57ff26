#include "batten/measure/curvature_graph.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "shape/space.hpp"

namespace batten {
namespace {

using space::cross;
using space::dot;
using space::Vector;

/// A curvature that changes by less than this over the extent is constant but for rounding.
constexpr double steady = 1e-11;

Vector vector_of(const Jet& jet, int order) {
    const auto v = jet[order];
    return {v[0], v[1], v.size() > 2 ? v[2] : 0};
}

/// A quantity along the curve and its derivative by arc length.
struct Rate {
    double value = 0, change = 0;
};

Rate curvature_rate(const Jet& jet) {
    const Vector d1 = vector_of(jet, 1), d2 = vector_of(jet, 2), d3 = vector_of(jet, 3);
    const double speed = std::sqrt(dot(d1, d1)), faster = dot(d1, d2) / speed;
    const Vector turn = cross(d1, d2);
    const double size = std::sqrt(dot(turn, turn));
    const double growth = dot(turn, cross(d1, d3)) / size;
    const double cube = speed * speed * speed;
    return {size / cube, (growth - 3 * size * faster / speed) / (cube * speed)};
}

Rate torsion_rate(const Jet& jet) {
    const Vector d1 = vector_of(jet, 1), d2 = vector_of(jet, 2), d3 = vector_of(jet, 3),
                 d4 = vector_of(jet, 4);
    const Vector turn = cross(d1, d2);
    const double size = dot(turn, turn), growth = 2 * dot(turn, cross(d1, d3));
    const double volume = dot(turn, d3), swelling = dot(turn, d4);
    return {volume / size, (swelling * size - volume * growth) / (size * size) /
                               std::sqrt(dot(d1, d1))};
}

std::optional<GraphLine> line_through(const Points& points) {
    const double n = static_cast<double>(points.size());
    if (points.size() < 3) return std::nullopt;
    double x = 0, y = 0, xx = 0, xy = 0, rest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) x += points(i, 0) / n, y += points(i, 1) / n;
    for (std::size_t i = 0; i < points.size(); ++i) {
        xx += (points(i, 0) - x) * (points(i, 0) - x);
        xy += (points(i, 0) - x) * (points(i, 1) - y);
    }
    if (!(xx > 0)) return std::nullopt;
    const double slope = xy / xx;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = points(i, 1) - y - slope * (points(i, 0) - x);
        rest += r * r;
    }
    return GraphLine{slope, std::sqrt(rest / (n - 2) / xx), y - slope * x};
}

template <class Measure>
LogarithmicGraph graph(const Curve& curve, int samples, int order, Measure measure) {
    LogarithmicGraph result;
    const double least = steady / extent(curve);
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Interval piece = curve.piece(i);
        for (int k = 0; k < samples; ++k) {
            const Jet jet = curve.jet_on(i, piece.lo + piece.length() * (k + 0.5) / samples, order);
            const Rate rate = measure(jet);
            // rho ds / d rho = -kappa / kappa'
            const std::array<double, 2> row{-std::log(std::fabs(rate.value)),
                                            std::log(std::fabs(rate.value / rate.change))};
            const bool changes = std::fabs(rate.change) > least * std::fabs(rate.value);
            if (changes && std::isfinite(row[0]) && std::isfinite(row[1])) {
                result.points.push_back(row);
            }
        }
    }
    result.line = line_through(result.points);
    return result;
}

void require_dimensions(const Curve& curve, int lowest) {
    if (curve.dim() >= lowest && curve.dim() <= 3) return;
    throw Error("curve.dimension", "curve", std::to_string(curve.dim()) + " coordinates",
                lowest == 3 ? "torsion exists in space" : "curvature needs a plane or space curve");
}

}  // namespace

LogarithmicGraph curvature_graph(const Curve& curve, int samples) {
    require_dimensions(curve, 2);
    return graph(curve, samples, 3, curvature_rate);
}

LogarithmicGraph torsion_graph(const Curve& curve, int samples) {
    require_dimensions(curve, 3);
    return graph(curve, samples, 4, torsion_rate);
}

}  // namespace batten
