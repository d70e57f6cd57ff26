#include "batten/measure/energy.hpp"

#include <algorithm>
#include <cmath>

#include "measure/bezier/bend.hpp"
#include "measure/energies.hpp"
#include "measure/lengths.hpp"
#include "num/gauss.hpp"

namespace batten {
namespace bezier {
namespace {

/// The share by which p.p may vary in the ellipses of Panels::for_powers.
constexpr double share = 0.5;

/// int w^lo (1 - w)^hi |b|^2 / |p|^5 dw, b being what is left of p x p'.
class EnergyIntegral {
public:
    EnergyIntegral(const Stretch& stretch, const Bend& bend, int lo, int hi)
        : stretch_(stretch), bend_(bend), lo_(lo), hi_(hi) {}

    Measured over(const Panel& panel) const {
        const num::GaussRule rule = num::gauss_legendre(std::min(panel.nodes, 64));
        double sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double x = rule.nodes[i], w = panel.w_of(x);
            const double speed_sq = panel.hodograph_sq(x);
            sum += rule.weights[i] * std::pow(w, lo_) * std::pow(1 - w, hi_) *
                   bend_.size_sq(w) / (speed_sq * speed_sq * std::sqrt(speed_sq));
        }
        const double value = panel.half * sum;
        return {value, bound(panel) + rounding(panel) * value};
    }

private:
    double bound(const Panel& panel) const {
        const double rho = panel.analytic_radius(share);
        double size_sq = 0;
        for (const bernstein::Coefficients& minor : bend_.minors) {
            const Interval part{panel.centre - panel.half, panel.centre + panel.half};
            const double size = within(bernstein::restricted(minor, part), rho);
            size_sq += size * size;
        }
        const double reach = panel.half * 0.5 * (rho + 1 / rho);
        const double least = std::sqrt((1 - share) * panel.mean_sq());
        const double most = size_sq * std::pow(panel.centre + reach, lo_) *
                            std::pow(1 - panel.centre + reach, hi_) / std::pow(least, 5);
        return panel.half * chebyshev::gauss_bound(rho, most, panel.nodes);
    }

    /// A bound on a polynomial in the ellipse: with Bernstein coefficients c it is at most
    /// max |c| (|u| + |1 - u|)^n, and the sum of the two distances is constant on an ellipse.
    static double within(bernstein::View c, double rho) {
        const double axis = 0.5 * (rho + 1 / rho);
        return bernstein::bound(c) * std::pow(axis, static_cast<double>(c.size() - 1));
    }

    /// Rounding of p, relative to p where it is small.
    double rounding(const Panel& panel) const {
        double size = 0;
        for (int k = 0; k < stretch_.dim; ++k) {
            size = std::fmax(size, bernstein::bound(stretch_.coordinate(k)));
        }
        return 0x1p-49 * (1 + size / std::sqrt(panel.mean_sq()));
    }

    const Stretch& stretch_;
    const Bend& bend_;
    int lo_, hi_;
};

}  // namespace

Energies energies(const Motion& motion) {
    Energies result{std::vector<Measured>(motion.pieces.curve().pieces()), std::nullopt};
    for (const Stretch& stretch : motion.stretches) {
        const auto t_of = [&](double w) {
            return motion.pieces.t_of(stretch.piece, stretch.u_of(w));
        };
        const Bend whole = bend_of(motion.pieces, stretch);
        // With b = w^r c the integrand is w^(2r - a) |c|^2 / |p|^5.
        const int lo = (stretch.zeros_lo + 1) / 2, hi = (stretch.zeros_hi + 1) / 2;
        const std::optional<Bend> bend = without_zeros(whole, lo, hi);
        if (stretch.u.lo > 0 || !bend) {
            result.diverges_at = t_of(stretch.u.lo > 0 || !without_zeros(whole, lo, 0) ? 0 : 1);
            return result;
        }
        if (bend->is_straight()) continue;
        const std::vector<Panel> panels = motion.panels.for_powers(stretch);
        if (panels.empty()) {
            result.diverges_at = t_of(0.5);
            return result;
        }
        Measured& piece = result.pieces[motion.pieces.source(stretch.piece)];
        const EnergyIntegral integral(stretch, *bend, 2 * lo - stretch.zeros_lo,
                                      2 * hi - stretch.zeros_hi);
        for (const Panel& panel : panels) {
            const Measured part = integral.over(panel);
            piece.value += part.value;
            piece.error += part.error + 0x1p-53 * piece.value;
        }
    }
    return result;
}

Measured product(const Measured& a, const Measured& b) {
    return {a.value * b.value, std::fabs(a.value) * b.error + std::fabs(b.value) * a.error +
                                   a.error * b.error + 0x1p-52 * std::fabs(a.value * b.value)};
}

Measured pseudo_energy(const Energies& energies, const std::vector<Measured>& lengths) {
    std::vector<Measured> terms;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        terms.push_back(product(energies.pieces[i], product(lengths[i], lengths[i])));
    }
    return total(terms);
}

namespace {

Measured in_data(const Pieces& pieces, const Measured& x, int power) {
    return {pieces.in_data(x.value, power), pieces.in_data(x.error, power)};
}

/// Lengths in passing need no more than rounding allows.
constexpr double length_tolerance = 1e-14;

}  // namespace
}  // namespace bezier

std::optional<Measured> bending_energy(const Curve& curve) {
    const bezier::Motion motion(curve);
    const bezier::Energies energies = bezier::energies(motion);
    if (energies.diverges_at) return std::nullopt;
    return bezier::in_data(motion.pieces, bezier::total(energies.pieces), -1);
}

std::optional<Measured> energy_length(const Curve& curve) {
    const bezier::Motion motion(curve);
    const bezier::Energies energies = bezier::energies(motion);
    if (energies.diverges_at) return std::nullopt;
    const Measured length = bezier::total(bezier::lengths(motion, bezier::length_tolerance));
    return bezier::product(bezier::total(energies.pieces), length);
}

std::optional<Measured> pseudo_energy(const Curve& curve) {
    const bezier::Motion motion(curve);
    const bezier::Energies energies = bezier::energies(motion);
    if (energies.diverges_at) return std::nullopt;
    const std::vector<Measured> lengths = bezier::lengths(motion, bezier::length_tolerance);
    return bezier::in_data(motion.pieces, bezier::pseudo_energy(energies, lengths), 1);
}

}  // namespace batten
