#include "make/fair/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "make/log_aesthetic/spline.hpp"

namespace batten::fairing {
namespace {

double direction(const Track& t, std::size_t from, std::size_t to) {
    return std::atan2(t.y[to] - t.y[from], t.x[to] - t.x[from]);
}

/// The tangent at an end of a row: of the circle through the last three points.
double end_tangent(const Track& t, std::size_t end, std::size_t second, std::size_t third) {
    const double first = direction(t, end, second);
    return first - std::remainder(direction(t, second, third) - first, 2 * std::numbers::pi) *
                       std::hypot(t.x[second] - t.x[end], t.y[second] - t.y[end]) /
                       (std::hypot(t.x[second] - t.x[end], t.y[second] - t.y[end]) +
                        std::hypot(t.x[third] - t.x[second], t.y[third] - t.y[second]));
}

LogAestheticCurve curve_through(const Track& track, double alpha,
                                const std::vector<std::size_t>& joints) {
    spiral::SplineRun run;
    run.closed = track.closed;
    const std::size_t n = joints.size(), spans = track.closed ? n : n - 1;
    Points points(0, 2);
    for (std::size_t k = 0; k < spans + 1; ++k) {
        const std::size_t i = joints[k % n];
        points.push_back(std::vector<double>{track.x[i], track.y[i]});
        if (k == spans) break;
        const std::size_t j = joints[(k + 1) % n];
        run.lengths.push_back(std::hypot(track.x[j] - track.x[i], track.y[j] - track.y[i]));
        run.directions.push_back(direction(track, i, j));
    }
    if (!track.closed) {
        const std::size_t last = track.size() - 1;
        run.fixed.resize(n);
        run.fixed[0] = end_tangent(track, 0, 1, 2);
        run.fixed[n - 1] = end_tangent(track, last, last - 1, last - 2) + std::numbers::pi;
    }
    spiral::SplineChain chain = spiral::log_aesthetic_spline(run, alpha);
    return {points, std::move(chain.angles), std::move(chain.segments), track.closed};
}

/// The point of one arc's stretch that is furthest from it.
struct Worst {
    std::size_t at = 0;
    double distance = 0;
};

Worst worst_of(const Track& track, const LogAestheticCurve& curve, std::size_t piece,
               std::size_t from, std::size_t to) {
    double total = 0;
    for (std::size_t i = from; i != to; i = track.next(i)) total += track.edge(i);
    const double lo = curve.breaks()[piece], arc = curve.breaks()[piece + 1] - lo;
    Worst worst;
    double s = 0;
    for (std::size_t i = from; track.next(i) != to;) {
        s += track.edge(i);
        i = track.next(i);
        const double t = lo + arc * (s / total);
        double jet[4];
        curve.jets_on(piece, {&t, 1}, 1, jet);
        const double off = std::fabs((track.y[i] - jet[1]) * jet[2] - (track.x[i] - jet[0]) * jet[3]);
        if (off > worst.distance) worst = {i, off};
    }
    return worst;
}

}  // namespace

Chain chain_along(const Track& track, double alpha, const std::vector<std::size_t>& ends,
                  double tolerance) {
    std::vector<std::size_t> joints = ends;
    const std::size_t n = track.size();
    // A ring needs three joints.
    for (std::size_t k = 0; track.closed && joints.size() < 3; ++k) joints.push_back(k * n / 3);
    std::sort(joints.begin(), joints.end());
    joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    while (true) {
        Chain chain{curve_through(track, alpha, joints), 0};
        std::vector<std::size_t> more;
        for (std::size_t k = 0; k < chain.curve.segments().size(); ++k) {
            const Worst worst = worst_of(track, chain.curve, k, joints[k],
                                         joints[(k + 1) % joints.size()]);
            chain.error = std::fmax(chain.error, worst.distance);
            if (worst.distance > tolerance) more.push_back(worst.at);
        }
        if (more.empty() || joints.size() == n) return chain;
        joints.insert(joints.end(), more.begin(), more.end());
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    }
}

}  // namespace batten::fairing
