#include "batten/measure/curvature.hpp"

#include <cmath>

#include "measure/bezier/bend.hpp"
#include "measure/bends.hpp"

namespace batten {
namespace bezier {
namespace {

using bernstein::Coefficients;
using bernstein::View;

/// The zeros in w of d|kappa|/dw, where kappa = b / |p|^3.
///
/// One minor: (b / q^(3/2))' = 0 where 2 b' q - 3 b q' = 0, with q = p.p; several: likewise
/// g' q - 3 g q' = 0 with g = b.b.
std::vector<double> critical(const Stretch& stretch, const Bend& bend) {
    Coefficients q, g;
    for (int k = 0; k < stretch.dim; ++k) {
        const Coefficients square =
            bernstein::product(stretch.coordinate(k), stretch.coordinate(k));
        q = k == 0 ? square : bernstein::combination(q, 1, square);
    }
    const bool is_plane = bend.minors.size() == 1;
    g = bend.minors[0];
    for (std::size_t i = 0; i < bend.minors.size() && !is_plane; ++i) {
        const Coefficients square = bernstein::product(bend.minors[i], bend.minors[i]);
        g = i == 0 ? square : bernstein::combination(g, 1, square);
    }
    if (g.size() == 1 && q.size() == 1) return {};
    const Coefficients g_slope = bernstein::derivative(g), q_slope = bernstein::derivative(q);
    Coefficients change(g.size() + q.size() - 2);
    double noise = 0;
    const auto add = [&](double factor, View a, View b) {
        const Coefficients term = bernstein::product(a, b);
        if (term.size() != change.size()) return;  // the derivative of a constant
        change = bernstein::combination(change, factor, term);
        noise += 0x1p-48 * std::fabs(factor) * bernstein::bound(a) * bernstein::bound(b);
    };
    add(is_plane ? 2 : 1, g_slope, q);
    add(-3, g, q_slope);
    return bernstein::roots(change, noise);
}

double curvature_at(const Stretch& stretch, const Bend& bend, double w) {
    double speed = 0;
    for (int k = 0; k < stretch.dim; ++k) {
        speed = std::hypot(speed, bernstein::value(stretch.coordinate(k), w));
    }
    return std::sqrt(bend.size_sq(w)) / speed / speed / speed;
}

}  // namespace

std::optional<MaxCurvature> max_curvature(const Motion& motion) {
    // A later place must be higher by more than rounding: on a circle all are equal.
    constexpr double higher = 1 + 0x1p-46;
    const Pieces& pieces = motion.pieces;
    MaxCurvature best{0, pieces.curve().domain().lo};
    for (const Stretch& stretch : motion.stretches) {
        const std::optional<Bend> bend =
            without_zeros(bend_of(pieces, stretch), stretch.zeros_lo, stretch.zeros_hi);
        if (stretch.u.lo > 0 || !bend) return std::nullopt;
        if (bend->is_straight()) continue;
        std::vector<double> places = critical(stretch, *bend);
        places.insert(places.begin(), 0);
        places.push_back(1);
        for (const double w : places) {
            const double t = pieces.t_of(stretch.piece, stretch.u_of(w));
            std::optional<double> kappa = std::nullopt;
            if (stretch.is_whole_motion()) {
                kappa = curvature(pieces.curve().jet_on(pieces.source(stretch.piece), t, 2));
            } else if (const double limit = curvature_at(stretch, *bend, w);
                       std::isfinite(limit)) {
                kappa = pieces.in_data(limit, -1);
            }
            if (!kappa) return std::nullopt;
            if (std::fabs(*kappa) > higher * best.value) best = {std::fabs(*kappa), t};
        }
    }
    return best;
}

}  // namespace bezier

std::optional<double> curvature(const Jet& jet) {
    double speed = 0;
    for (const double x : jet[1]) speed = std::hypot(speed, x);
    if (speed == 0 || !std::isfinite(speed)) return std::nullopt;
    double signed_bend = 0, size = 0;
    for (int i = 0; i < jet.dim(); ++i) {
        for (int j = i + 1; j < jet.dim(); ++j) {
            signed_bend =
                jet[1][i] / speed * (jet[2][j] / speed) - jet[1][j] / speed * (jet[2][i] / speed);
            size = std::hypot(size, signed_bend);
        }
    }
    const double result = (jet.dim() == 2 ? signed_bend : size) / speed;
    if (!std::isfinite(result)) return std::nullopt;
    return result;
}

std::optional<MaxCurvature> max_curvature(const Curve& curve) {
    return bezier::max_curvature(bezier::Motion(curve));
}

}  // namespace batten
