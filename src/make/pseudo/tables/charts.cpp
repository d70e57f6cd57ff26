#include "make/pseudo/tables/charts.hpp"

#include <cmath>
#include <numbers>

namespace batten::pseudo {
namespace {

using std::numbers::pi;

/// Where the Hessian of J along the least minima is smallest, against theta0: a polynomial through
/// 44 places found so, good to 4e-5 (1e-3 above theta0 = 1.95).
double crease(double theta0) {
    constexpr std::array<double, 10> c{0.6998417,-0.4886958,0.7482058,-0.9908925,1.2804595,-1.3897460,1.0177032,-0.4545851,0.1119192,-0.0116598};
    double sum = c[9];
    for (std::size_t i = 9; i-- > 0;) sum = sum * theta0 + c[i];
    return sum;
}

/// The unit of the stretched coordinate of the strip: about how far r turns across the crease.
double crease_unit(double theta0) { return 0.004 * theta0; }

double most_stretched() { return std::asinh(strip_half_width / crease_unit(least_angle0)); }

/// J / theta0^2 for small angles.
double small_form(const AnglePair& a) {
    const double s = a.theta1 / a.theta0;
    return 4 * (1 + s + s * s);
}

/// The coordinate that vanishes at the origin.
double origin_scale(const ChartPoint& p) { return p.chart == Chart::far ? p.y : p.x; }

}  // namespace

patches::Box box_of(Chart chart) {
    switch (chart) {
        case Chart::near:
            return {{least_angle0, wide_angle0}, {0, most_bend}};
        case Chart::far:
            return {{0, 1 / most_bend}, {least_angle0, 2}};
        case Chart::wide:
            return {{wide_angle0, pi}, {0, 2}};
        case Chart::strip:
            return {{least_angle0, node_angle0}, {-most_stretched(), most_stretched()}};
        case Chart::node:
            return {{least_distance, pi - node_angle0}, {-1, 1}};
        case Chart::low_corner:
        case Chart::high_corner:
            break;
    }
    return {{least_distance, corner_size}, {0, 1}};
}

ChartPoint chart_point(const AnglePair& a) {
    const double rise = (a.theta0 + a.theta1) / a.theta0;
    const double bend = rise / a.theta0;
    const double size1 = std::fabs(a.theta1);
    if (a.theta0 < node_angle0) {
        // The crease lies between 0.41 and 0.7.
        const bool may_be_near = bend > 0.3 && bend < 0.81;
        const double across = may_be_near ? bend - crease(a.theta0) : 1;
        if (std::fabs(across) < strip_half_width) {
            return {Chart::strip, a.theta0, std::asinh(across / crease_unit(a.theta0))};
        }
        if (a.theta0 >= wide_angle0) return {Chart::wide, a.theta0, rise};
        if (rise <= most_bend * a.theta0) return {Chart::near, a.theta0, bend};
        return {Chart::far, a.theta0 / rise, rise};
    }
    const double rest0 = pi - a.theta0, rest1 = pi - size1;
    if (size1 <= rest0) return {Chart::node, rest0, rest0 > 0 ? a.theta1 / rest0 : 0};
    if (rest1 < corner_size) {
        const Chart corner = a.theta1 < 0 ? Chart::low_corner : Chart::high_corner;
        return {corner, rest1, rest1 > 0 ? rest0 / rest1 : 0};
    }
    return {Chart::wide, a.theta0, rise};
}

AnglePair angles_at(const ChartPoint& p) {
    switch (p.chart) {
        case Chart::near:
            return {p.x, p.x * (p.x * p.y - 1)};
        case Chart::far:
            return {p.x * p.y, p.x * p.y * (p.y - 1)};
        case Chart::wide:
            return {p.x, p.x * (p.y - 1)};
        case Chart::strip:
            return {p.x, p.x * (p.x * (crease(p.x) + crease_unit(p.x) * std::sinh(p.y)) - 1)};
        case Chart::node:
            return {pi - p.x, p.x * p.y};
        case Chart::low_corner:
            return {pi - p.x * p.y, p.x - pi};
        case Chart::high_corner:
            break;
    }
    return {pi - p.x * p.y, pi - p.x};
}

double packed_energy(const ChartPoint& p, const AnglePair& a, double pseudo_energy) {
    const double ratio = pseudo_energy / (a.theta0 * a.theta0);
    switch (p.chart) {
        case Chart::near:
        case Chart::far:
        case Chart::strip: {
            const double scale = origin_scale(p);
            return (ratio - small_form(a)) / (scale * scale);
        }
        case Chart::wide:
            return 1 / ratio;
        case Chart::node:
        case Chart::low_corner:
        case Chart::high_corner:
            break;
    }
    return 1 / (ratio * p.x * p.x);
}

double unpacked_energy(const ChartPoint& p, const AnglePair& a, double packed) {
    const double square = a.theta0 * a.theta0;
    switch (p.chart) {
        case Chart::near:
        case Chart::far:
        case Chart::strip: {
            const double scale = origin_scale(p);
            return square * (small_form(a) + scale * scale * packed);
        }
        case Chart::wide:
            return square / packed;
        case Chart::node:
        case Chart::low_corner:
        case Chart::high_corner:
            break;
    }
    return square / (packed * p.x * p.x);
}

}  // namespace batten::pseudo
