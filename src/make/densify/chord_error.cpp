#include "make/densify/chord_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "num/roots.hpp"

namespace batten::lagrange {
namespace {

double norm(std::span<const double> a) {
    if (a.size() == 2) return std::hypot(a[0], a[1]);
    double sum = 0;
    for (const double x : a) sum = std::hypot(sum, x);
    return sum;
}

/// The distance of the points of a cell from the chord between two of them.
class ChordDistance {
public:
    explicit ChordDistance(const CellCurve& curve)
        : curve_(curve), start_(width()), chord_(width()), off_(width()) {}

    /// The largest one over `part` of a cell.
    double largest(std::size_t cell, Interval part) {
        set(cell, part);
        if (curve_.terms() == 0) return 0;
        if (curve_.terms() <= 2) {
            if (const std::optional<double> exact = largest_of_cubic()) return *exact;
        }
        return largest_by_search();
    }

private:
    std::size_t width() const { return static_cast<std::size_t>(curve_.dim()); }
    void set(std::size_t cell, Interval part);
    std::optional<double> largest_of_cubic();
    double largest_by_search();
    double at(double s);

    const CellCurve& curve_;
    std::size_t cell_ = 0;
    Interval part_;
    std::vector<double> start_, chord_, off_;
    double length_ = 0;
};

void ChordDistance::set(std::size_t cell, Interval part) {
    cell_ = cell;
    part_ = part;
    curve_.point(cell, part.lo, start_);
    curve_.point(cell, part.hi, chord_);
    for (std::size_t k = 0; k < width(); ++k) chord_[k] -= start_[k];
    length_ = norm(chord_);
    if (length_ > 0) {
        for (double& x : chord_) x /= length_;
    }
}

double ChordDistance::at(double s) {
    curve_.point(cell_, s, off_);
    double along = 0;
    for (std::size_t k = 0; k < width(); ++k) {
        off_[k] -= start_[k];
        along += off_[k] * chord_[k];
    }
    along = std::clamp(along, 0.0, length_);
    for (std::size_t k = 0; k < width(); ++k) off_[k] -= along * chord_[k];
    return norm(off_);
}

/// With s = lo + w u the curve is off its chord by -w^2 u (1 - u) (A + B u). The part across the
/// chord is largest at a root of a cubic. Nothing where a foot may lie beside the chord.
std::optional<double> ChordDistance::largest_of_cubic() {
    const double w = part_.length();
    const double* const g = curve_.bubble(cell_);
    const bool is_cubic = curve_.terms() == 2;
    double a_along = 0, b_along = 0, size = 0;
    for (std::size_t k = 0; k < width(); ++k) {
        const double c3 = is_cubic ? g[width() + k] : 0, c2 = g[k] - c3;
        const double a = c2 + c3 * (2 * part_.lo + part_.hi), b = w * c3;
        a_along += a * chord_[k];
        b_along += b * chord_[k];
        size = std::max({size, std::fabs(a), std::fabs(b)});
    }
    if (!(w * w * (std::fabs(a_along) + std::fabs(b_along)) < length_)) return std::nullopt;
    double aa = 0, ab = 0, bb = 0;  // of the parts across, in units of `size`
    for (std::size_t k = 0; k < width() && size > 0; ++k) {
        const double c3 = is_cubic ? g[width() + k] : 0, c2 = g[k] - c3;
        const double a = c2 + c3 * (2 * part_.lo + part_.hi) - a_along * chord_[k];
        const double b = w * c3 - b_along * chord_[k];
        aa += a / size * (a / size);
        ab += a / size * (b / size);
        bb += b / size * (b / size);
    }
    const auto off = [&](double u) {
        const double across = std::sqrt(std::max(0.0, aa + u * (2 * ab + u * bb)));
        return w * w * u * (1 - u) * across * size;
    };
    // 0 = 2 (1 - 2u) |A + B u|^2 + u (1 - u) d|A + B u|^2/du, halved
    const std::array<double, 4> slope{aa, 3 * ab - 2 * aa, 2 * bb - 5 * ab, -3 * bb};
    if (25 * bb < aa) {  // hardly a cubic: one peak near the middle
        double u = 0.5;
        for (int step = 0; step < 4; ++step) {
            const double value = slope[0] + u * (slope[1] + u * (slope[2] + u * slope[3]));
            u -= value / (slope[1] + u * (2 * slope[2] + 3 * u * slope[3]));
        }
        return off(u);
    }
    double largest = 0;
    for (const double u : num::real_roots(slope)) {
        if (u > 0 && u < 1) largest = std::max(largest, off(u));
    }
    return largest;
}

double ChordDistance::largest_by_search() {
    const int steps = 4 * static_cast<int>(curve_.terms() + 1);
    const double step = part_.length() / steps;
    double best = 0, best_s = part_.lo;
    for (int i = 1; i < steps; ++i) {
        const double s = part_.lo + i * step;
        const double distance = at(s);
        if (distance > best) {
            best = distance;
            best_s = s;
        }
    }
    if (best == 0) return 0;
    const auto closeness = [&](double s) { return -at(s); };
    const Interval around{std::max(part_.lo, best_s - step), std::min(part_.hi, best_s + step)};
    return -num::find_minimum(closeness, around, best_s, 1e-4 * step).value;
}

/// Signed in the plane.
double angle(std::span<const double> in, std::span<const double> out) {
    const double a = norm(in), b = norm(out);
    if (a == 0 || b == 0) return 0;
    if (in.size() == 2) {
        const double ux = in[0] / a, uy = in[1] / a, vx = out[0] / b, vy = out[1] / b;
        return std::atan2(ux * vy - uy * vx, ux * vx + uy * vy);
    }
    double apart = 0, together = 0;
    for (std::size_t k = 0; k < in.size(); ++k) {
        apart = std::hypot(apart, in[k] / a - out[k] / b);
        together = std::hypot(together, in[k] / a + out[k] / b);
    }
    return 2 * std::atan2(apart, together);
}

}  // namespace

double largest_chord_error(const CellCurve& curve, const Division& division) {
    constexpr double no_news = 1 + 1e-6;
    ChordDistance distance(curve);
    double largest = 0;
    for (std::size_t cell = 0; cell < curve.cells(); ++cell) {
        const std::size_t steps = division.of(cell);
        const double width = 1 / static_cast<double>(steps);
        const double bound = curve.second_derivative_bound(cell) * width * width / 8;
        // From both ends inwards: up to degree 3, |f''| is largest at an end of the cell.
        for (std::size_t i = 0; i < steps && bound > largest * no_news; ++i) {
            const std::size_t place = i % 2 == 0 ? i / 2 : steps - 1 - i / 2;
            const double lo = static_cast<double>(place) * width;
            largest = std::max(largest, distance.largest(cell, {lo, lo + width}));
        }
    }
    return largest;
}

std::vector<double> tangent_jumps(const CellCurve& curve) {
    std::vector<double> jumps;
    const std::size_t n = curve.cells();
    std::vector<double> in(static_cast<std::size_t>(curve.dim())), out(in.size());
    for (std::size_t cell = curve.is_closed() ? 0 : 1; cell < n; ++cell) {
        curve.end_slope((cell + n - 1) % n, in);
        curve.start_slope(cell, out);
        jumps.push_back(angle(in, out));
    }
    return jumps;
}

}  // namespace batten::lagrange
