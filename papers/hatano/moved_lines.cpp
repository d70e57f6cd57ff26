#include "moved_lines.hpp"

namespace papers {
namespace {

using namespace batten;

/// Knot lines, both ends included, x first.
struct Lines {
    std::vector<double> x, y;

    std::vector<double>& along(int axis) { return axis == 0 ? x : y; }
};

SurfaceFit fitted(const SurfaceSet& set, const Lines& lines) {
    FitSurfaceOptions options;
    options.knots = SurfaceKnots::given;
    options.x_knots = lines.x;
    options.y_knots = lines.y;
    options.sigma = set.sigma;
    return fit_surface(set.view(), options);
}

/// Golden sections between the neighbours, keeping a tenth of the room away from them.
void move(const SurfaceSet& set, Lines& lines, int axis, std::size_t which, SurfaceFit& best) {
    constexpr int sections = 7;
    constexpr double golden = 0.6180339887498949, away = 0.1;
    std::vector<double>& places = lines.along(axis);
    const double start = places[which];
    const double room = places[which + 1] - places[which - 1];
    Interval range{places[which - 1] + away * room, places[which + 1] - away * room};
    double found = start;
    const auto delta2_at = [&](double place) {
        places[which] = place;
        SurfaceFit made = fitted(set, lines);
        const double delta2 = made.report.delta2;
        if (delta2 < best.report.delta2) {
            best = std::move(made);
            found = place;
        }
        return delta2;
    };
    double a = range.hi - golden * range.length(), b = range.lo + golden * range.length();
    double at_a = delta2_at(a), at_b = delta2_at(b);
    for (int k = 0; k < sections; ++k) {
        if (at_a < at_b) {
            range.hi = b;
            b = a;
            at_b = at_a;
            a = range.hi - golden * range.length();
            at_a = delta2_at(a);
        } else {
            range.lo = a;
            a = b;
            at_a = at_b;
            b = range.lo + golden * range.length();
            at_b = delta2_at(b);
        }
    }
    places[which] = found;
}

}  // namespace

SurfaceFit with_moved_lines(const SurfaceSet& set, const SurfaceFit& start, int sweeps) {
    Lines lines{start.report.breaks_x, start.report.breaks_y};
    SurfaceFit best = start;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (const int axis : {0, 1}) {
            for (std::size_t k = 1; k + 1 < lines.along(axis).size(); ++k) {
                move(set, lines, axis, k, best);
            }
        }
    }
    return best;
}

}  // namespace papers
