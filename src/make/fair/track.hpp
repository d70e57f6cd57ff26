#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "batten/base/points.hpp"

namespace batten::fairing {

/// Points of the plane in a row, or in a ring.
struct Track {
    std::vector<double> x, y;
    bool closed = false;

    std::size_t size() const { return x.size(); }
    std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
    std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
    /// Edges: one more point than edges in a row.
    std::size_t edges() const { return closed ? size() : size() - 1; }
    double edge(std::size_t i) const {
        const double dx = x[next(i)] - x[i], dy = y[next(i)] - y[i];
        return std::sqrt(dx * dx + dy * dy);
    }
};

inline double length_of(const Track& track) {
    double sum = 0;
    for (std::size_t i = 0; i < track.edges(); ++i) sum += track.edge(i);
    return sum;
}

/// How the curvature of the circle through three points is, and moves with each of them.
struct Bend {
    double kappa = 0;
    double before = 0, here = 0, after = 0;  ///< by the displacements along given normals
};

/// Twice the sine of the turn over the chord [MiuraYoshidaSaito, eq. 2], signed.
inline double circle_curvature(double ax, double ay, double bx, double by) {
    const double dx = ax + bx, dy = ay + by;
    return 2 * (ax * by - ay * bx) /
           std::sqrt((ax * ax + ay * ay) * (bx * bx + by * by) * (dx * dx + dy * dy));
}

/// The curvature at inner points (all points of a ring); 0 at the two ends.
inline std::vector<double> curvatures(const Track& t) {
    std::vector<double> kappa(t.size());
    const std::size_t first = t.closed ? 0 : 1, last = t.closed ? t.size() : t.size() - 1;
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t b = t.before(i), a = t.next(i);
        kappa[i] = circle_curvature(t.x[i] - t.x[b], t.y[i] - t.y[b], t.x[a] - t.x[i],
                                    t.y[a] - t.y[i]);
    }
    return kappa;
}

}  // namespace batten::fairing
