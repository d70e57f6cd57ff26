#include "measure/bezier/stretch.hpp"

#include <algorithm>
#include <cmath>

namespace batten::bezier {
namespace {

using bernstein::Coefficients;
using bernstein::View;

constexpr double rest_at_end = 0x1p-50, rest_inside = 0x1p-40;

/// Whether all coefficients point into one half-space, well away from its border: then no
/// combination of them with weights from [0, 1] that add up to 1 is near zero.
bool is_moving_ahead(const Stretch& s, double largest) {
    Coefficients mean(static_cast<std::size_t>(s.dim));
    for (int k = 0; k < s.dim; ++k) {
        for (const double x : s.coordinate(k)) mean[k] += x;
    }
    const double length = coefficient_norm(mean, s.dim, 0);
    for (std::size_t j = 0; j < s.count(); ++j) {
        double along = 0;
        for (int k = 0; k < s.dim; ++k) along += mean[k] * s.coordinate(k)[j];
        if (!(along > rest_inside * largest * length)) return false;
    }
    return true;
}

/// Where the curve is at rest inside the stretch: minima of the speed, zeros of p.p'.
std::vector<double> rests(const Stretch& s, double largest) {
    if (s.degree() == 0 || is_moving_ahead(s, largest)) return {};
    Coefficients slope(2 * s.degree());
    double noise = 0;
    for (int k = 0; k < s.dim; ++k) {
        const Coefficients p_slope = bernstein::derivative(s.coordinate(k));
        const Coefficients term = bernstein::product(s.coordinate(k), p_slope);
        slope = bernstein::combination(slope, 1, term);
        noise += 0x1p-50 * bernstein::bound(s.coordinate(k)) * bernstein::bound(p_slope);
    }
    std::vector<double> result;
    for (const double w : bernstein::roots(slope, noise)) {
        double speed = 0;
        for (int k = 0; k < s.dim; ++k) {
            speed = std::hypot(speed, bernstein::value(s.coordinate(k), w));
        }
        if (speed <= rest_inside * largest && w > rest_at_end && 1 - w > rest_at_end) {
            result.push_back(w);
        }
    }
    return result;
}

enum class Tip { start, end };

Stretch without_rest(const Stretch& s, Tip tip) {
    Stretch result = s;
    result.p = Coefficients(static_cast<std::size_t>(s.dim) * s.degree());
    for (int k = 0; k < s.dim; ++k) {
        const Coefficients c = tip == Tip::start
                                   ? bernstein::without_zero_at_start(s.coordinate(k))
                                   : bernstein::without_zero_at_end(s.coordinate(k));
        std::copy(c.begin(), c.end(), result.p.data() + static_cast<std::size_t>(k) * c.size());
    }
    ++(tip == Tip::start ? result.zeros_lo : result.zeros_hi);
    return result;
}

/// Takes the factors w and 1 - w out of p.
Stretch in_motion(Stretch s) {
    while (s.degree() > 0 && coefficient_norm(s.p, s.dim, 0) <= rest_at_end * s.largest()) {
        s = without_rest(s, Tip::start);
    }
    while (s.degree() > 0 && coefficient_norm(s.p, s.dim, s.degree()) <= rest_at_end * s.largest()) {
        s = without_rest(s, Tip::end);
    }
    return s;
}

/// The part `w` of s; an end inside s is a rest, so p is set to zero there.
Stretch cut(const Stretch& s, Interval w) {
    Stretch result = s;
    result.u = w;
    for (int k = 0; k < s.dim; ++k) {
        Coefficients c = bernstein::restricted(s.coordinate(k), w);
        if (w.lo > 0) c[0] = 0;
        if (w.hi < 1) c[c.size() - 1] = 0;
        for (std::size_t j = 0; j < c.size(); ++j) {
            result.p[static_cast<std::size_t>(k) * s.count() + j] = c[j] * w.length();
        }
    }
    return result;
}

Stretch whole_piece(const Pieces& pieces, std::size_t i) {
    Stretch s;
    s.piece = i;
    s.dim = pieces.dim();
    s.p = Coefficients(static_cast<std::size_t>(s.dim * pieces.degree()));
    for (int k = 0; k < s.dim; ++k) {
        const View h = pieces.hodograph(i, k);
        std::copy(h.begin(), h.end(), s.p.data() + static_cast<std::size_t>(k) * h.size());
    }
    return s;
}

}  // namespace

double coefficient_norm(const Coefficients& c, int dim, std::size_t j) {
    const std::size_t count = c.size() / static_cast<std::size_t>(dim);
    double sum = 0;
    for (int k = 0; k < dim; ++k) {
        const double x = c[static_cast<std::size_t>(k) * count + j];
        sum += x * x;
    }
    return std::sqrt(sum);
}

double Stretch::largest() const {
    double result = 0;
    for (std::size_t j = 0; j < count(); ++j) {
        result = std::fmax(result, coefficient_norm(p, dim, j));
    }
    return result;
}

std::vector<Stretch> stretches(const Pieces& pieces) {
    std::vector<Stretch> result;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Stretch whole = whole_piece(pieces, i);
        const double largest = whole.largest();
        if (largest == 0) continue;
        double from = 0;
        for (const double w : rests(whole, largest)) {
            result.push_back(in_motion(cut(whole, {from, w})));
            from = w;
        }
        result.push_back(in_motion(from == 0 ? whole : cut(whole, {from, 1})));
    }
    return result;
}

double polygon_length(const Pieces& pieces, std::size_t piece) {
    const Stretch s = whole_piece(pieces, piece);
    double sum = 0;
    for (std::size_t j = 0; j < s.count(); ++j) sum += coefficient_norm(s.p, s.dim, j);
    return sum / static_cast<double>(s.count());
}

}  // namespace batten::bezier
