#include "measure/bezier/panel.hpp"

#include <algorithm>
#include <cmath>

namespace batten::bezier {
namespace {

using bernstein::Coefficients;

constexpr double widest_radius = 1024;
/// Beyond this many nodes halving is cheaper, as it at least doubles the distance of the zeros.
constexpr int most_length_nodes = 24, most_power_nodes = 40;
constexpr int most_panel_halvings = 70;

void cut_into_panels(const Panel& panel, int halvings, const auto& accept, const auto& half,
                     std::vector<Panel>& out) {
    Panel judged = panel;
    if (accept(judged, halvings)) {
        out.push_back(judged);
        return;
    }
    cut_into_panels(half(panel, false), halvings + 1, accept, half, out);
    cut_into_panels(half(panel, true), halvings + 1, accept, half, out);
}

double power(double x, int n) {
    double result = 1;
    for (int i = 0; i < n; ++i) result *= x;
    return result;
}

}  // namespace

double Panel::hodograph_sq(double x) const {
    double sum = 0;
    for (int k = 0; k < dim; ++k) {
        const double v = chebyshev::value(coordinate(k), x);
        sum += v * v;
    }
    return sum;
}

double Panel::mean_sq() const {
    double sum = 0;
    for (int k = 0; k < dim; ++k) sum += coordinate(k)[0] * coordinate(k)[0];
    return sum;
}

double Panel::rest_factor(double x) const {
    if (zeros_lo == 0 && zeros_hi == 0) return 1;
    return power(w_of(x), zeros_lo) * power(1 - w_of(x), zeros_hi);
}

double Panel::size_within(double rho) const {
    double sum = coefficient_norm(p, dim, 0), growth = 1;
    for (std::size_t j = 1; j < count(); ++j) {
        growth *= rho;
        sum += coefficient_norm(p, dim, j) * 0.5 * (growth + 1 / growth);
    }
    return sum;
}

double Panel::rest_factor_within(double rho) const {
    const double reach = half * 0.5 * (rho + 1 / rho);
    return power(centre + reach, zeros_lo) * power(1 - centre + reach, zeros_hi);
}

double Panel::analytic_radius(double share) const {
    Coefficients along(count()), size(count());
    for (std::size_t j = 1; j < count(); ++j) {
        double dot = 0;
        for (int k = 0; k < dim; ++k) dot += coordinate(k)[0] * coordinate(k)[j];
        along[j] = 2 * std::fabs(dot);
        size[j] = coefficient_norm(p, dim, j);
    }
    const double mean = mean_sq();
    const auto is_safe = [&](double rho) {
        double linear = 0, square = 0, growth = 1;
        for (std::size_t j = 1; j < count(); ++j) {
            growth *= rho;
            const double t = 0.5 * (growth + 1 / growth);
            linear += along[j] * t;
            square += size[j] * t;
        }
        return linear + square * square <= share * mean;
    };
    if (mean == 0 || !is_safe(1)) return 0;
    double lo = 1, hi = widest_radius;
    if (is_safe(hi)) return hi;
    while (hi > 1.06 * lo) {
        const double middle = std::sqrt(lo * hi);
        (is_safe(middle) ? lo : hi) = middle;
    }
    return lo > 1 ? lo : 0;
}

Panels::Panels(const Pieces& pieces) {
    for (int degree = 0; degree < pieces.degree(); ++degree) {
        bases_.emplace_back(static_cast<std::size_t>(degree));
    }
}

Panel Panels::whole(const Stretch& stretch) const {
    Panel panel;
    panel.dim = stretch.dim;
    panel.zeros_lo = stretch.zeros_lo;
    panel.zeros_hi = stretch.zeros_hi;
    panel.p = Coefficients(stretch.p.size());
    for (int k = 0; k < panel.dim; ++k) {
        bases_[stretch.degree()].from_bernstein(
            stretch.coordinate(k), panel.p.data() + static_cast<std::size_t>(k) * panel.count());
    }
    return panel;
}

Panel Panels::half(const Panel& panel, bool second) const {
    Panel result = panel;
    result.half = 0.5 * panel.half;
    result.centre = panel.centre + (second ? result.half : -result.half);
    const chebyshev::Basis& basis = bases_[panel.count() - 1];
    for (int k = 0; k < panel.dim; ++k) {
        double* const out = result.p.data() + static_cast<std::size_t>(k) * panel.count();
        second ? basis.right_half(panel.coordinate(k), out)
               : basis.left_half(panel.coordinate(k), out);
    }
    return result;
}

std::vector<Panel> Panels::for_length(const Stretch& stretch, double allowed) const {
    const double least = 0x1p-60 * stretch.largest();
    allowed = std::fmax(allowed, least);
    const auto accept = [&](Panel& panel, int halvings) {
        const double most = 2 * panel.half * panel.size_within(1) * panel.rest_factor_within(1);
        panel.nodes = 2;
        panel.error = most;
        if (most <= allowed || halvings == most_panel_halvings) return true;
        const double rho = panel.analytic_radius(1);
        if (rho == 0) return false;
        const double within = panel.half * std::sqrt(2.0) * coefficient_norm(panel.p, panel.dim, 0) *
                              panel.rest_factor_within(rho);
        panel.nodes = chebyshev::gauss_nodes(rho, within, allowed);
        panel.error = chebyshev::gauss_bound(rho, within, panel.nodes);
        return panel.nodes <= most_length_nodes;
    };
    std::vector<Panel> result;
    cut_into_panels(whole(stretch), 0, accept,
                    [this](const Panel& p, bool second) { return half(p, second); }, result);
    return result;
}

std::vector<Panel> Panels::for_powers(const Stretch& stretch) const {
    bool is_complete = true;
    const auto accept = [&](Panel& panel, int halvings) {
        if (halvings == most_panel_halvings) is_complete = false;
        if (!is_complete) return true;
        const double rho = panel.analytic_radius(0.5);
        if (rho < 2) return false;
        panel.nodes = static_cast<int>(std::ceil(32 / std::log2(rho))) +
                      static_cast<int>(stretch.degree()) + 1;
        return panel.nodes <= most_power_nodes;
    };
    std::vector<Panel> result;
    cut_into_panels(whole(stretch), 0, accept,
                    [this](const Panel& p, bool second) { return half(p, second); }, result);
    if (!is_complete) result.clear();
    return result;
}

}  // namespace batten::bezier
