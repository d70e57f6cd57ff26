#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

/// Curves whose numbers are known.
namespace batten::testing {

/// A cubic Bezier piece over [0, 1] with 4 control points of `dim` coordinates.
inline Curve bezier(const std::vector<double>& control, int dim = 2) {
    const std::size_t size = static_cast<std::size_t>(dim);
    std::vector<double> block(8 * size);
    for (std::size_t k = 0; k < size; ++k) {
        const double p0 = control[k], p1 = control[size + k];
        const double p2 = control[2 * size + k], p3 = control[3 * size + k];
        block[2 * k] = p0;
        block[2 * k + 1] = p3;
        block[2 * (size + k)] = 3 * (p1 - p0);
        block[2 * (2 * size + k)] = 3 * (p0 - 2 * p1 + p2);
        block[2 * (3 * size + k)] = p3 - p0 + 3 * (p1 - p2);
    }
    return PiecewiseCubic::power(block, dim, {0, 1}, false);
}

/// Cubic pieces through `points` with the given derivatives, over 0, 1, 2, ...
inline Curve hermite(const Points& points, const Points& slopes, bool closed = false) {
    std::vector<double> breaks;
    for (std::size_t i = 0; i < points.size(); ++i) breaks.push_back(static_cast<double>(i));
    const std::size_t pieces = points.size() - 1;
    return PiecewiseCubic::hermite(points, slopes.view().part(0, pieces),
                                   slopes.view().part(1, pieces), breaks, closed);
}

/// Straight pieces through points, over 0, 1, 2, ...
inline Curve polyline(const Points& points, bool closed = false) {
    const std::size_t pieces = points.size() - 1;
    Points chords(pieces, points.dim());
    std::vector<double> breaks{0};
    for (std::size_t i = 0; i < pieces; ++i) {
        for (int k = 0; k < points.dim(); ++k) chords(i, k) = points(i + 1, k) - points(i, k);
        breaks.push_back(static_cast<double>(i + 1));
    }
    return PiecewiseCubic::hermite(points, chords, chords, breaks, closed);
}

/// A term amplitude cos(rate t + phase) of one coordinate.
struct Wave {
    double amplitude, rate, phase;

    double derivative(double t, int k) const {
        return amplitude * std::pow(rate, k) *
               std::cos(rate * t + phase + k * std::numbers::pi / 2);
    }
};

/// A curve given by its own function: each coordinate is a sum of waves.
inline Curve waves(std::vector<std::vector<Wave>> coordinates, std::vector<double> breaks,
                   bool closed = true) {
    const int dim = static_cast<int>(coordinates.size());
    const auto f = [coordinates](double t, int order, std::span<double> out) {
        std::size_t place = 0;
        for (int k = 0; k <= order; ++k) {
            for (const std::vector<Wave>& terms : coordinates) {
                double sum = 0;
                for (const Wave& wave : terms) sum += wave.derivative(t, k);
                out[place++] = sum;
            }
        }
    };
    return CallableCurve{f, dim, std::move(breaks), closed};
}

inline constexpr double quarter = std::numbers::pi / 2;

/// x = a cos t, y = b sin t, once around.
inline Curve ellipse(double a, double b) {
    return waves({{{a, 1, 0}}, {{b, 1, -quarter}}}, {0, 2 * std::numbers::pi});
}

/// x = radius cos t, y = radius sin t, z = slope t, over [0, 1].
inline Curve helix(double radius, double slope) {
    const auto f = [radius, slope](double t, int order, std::span<double> out) {
        const Wave x{radius, 1, 0}, y{radius, 1, -quarter};
        for (int k = 0; k <= order; ++k) {
            out[3 * k] = x.derivative(t, k);
            out[3 * k + 1] = y.derivative(t, k);
            out[3 * k + 2] = k == 0 ? slope * t : k == 1 ? slope : 0;
        }
    };
    return CallableCurve{f, 3, {0, 1}, false};
}

/// The curve with its coordinates mapped by matrix and offset (row by row), in the plane.
struct Affine {
    double xx = 1, xy = 0, yx = 0, yy = 1, x = 0, y = 0;
};

struct MappedCurve {
    Curve original;
    Affine map;

    int dim() const { return 2; }
    std::span<const double> breaks() const { return original.breaks(); }
    bool is_closed() const { return original.is_closed(); }
    std::optional<int> degree() const { return original.degree(); }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        original.jets_on(piece, t, order, out);
        const std::size_t width = 2 * static_cast<std::size_t>(order + 1);
        for (std::size_t i = 0; i < out.size() && i < t.size() * width; i += 2) {
            const double x = out[i], y = out[i + 1];
            const bool is_point = i % width == 0;
            out[i] = map.xx * x + map.xy * y + (is_point ? map.x : 0);
            out[i + 1] = map.yx * x + map.yy * y + (is_point ? map.y : 0);
        }
    }
};

inline Curve mapped(const Curve& curve, const Affine& map) { return MappedCurve{curve, map}; }

inline Affine rotation(double angle) {
    return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0};
}

}  // namespace batten::testing
