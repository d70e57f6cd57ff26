#include "shape/log_aesthetic/profile.hpp"

#include <algorithm>

#include "num/gauss.hpp"

namespace batten::spiral {
namespace {

/// The angle, or the logarithms of radius and speed, change by 3 at most on a panel.
constexpr double panel_change = 3;

/// So many nodes leave an error below rounding: (change / 2)^n / n! of the rule's own.
int nodes_for(double change) {
    return change < 0.005 ? 4 : change < 0.06 ? 5 : change < 0.2 ? 6 : change < 1 ? 8 : 12;
}

}  // namespace

Profile Profile::by_ratio(double alpha, double log_ratio, double turn) {
    Profile p;
    p.is_clothoid_ = false;
    p.alpha_ = alpha;
    p.r_ = log_ratio;
    const double b = alpha * log_ratio, a = b - log_ratio;
    p.angle_ = Rise(a);
    p.arc_ = Rise(b);
    p.turn_ = turn;
    p.k0_ = turn * expm1_share(b) / expm1_share(a);
    p.k1_ = p.k0_ * std::exp(-log_ratio);
    return p;
}

Profile::Profile(const LogAestheticSegment& segment) {
    alpha_ = segment.alpha;
    k0_ = segment.start_curvature * segment.length;
    k1_ = segment.end_curvature * segment.length;
    is_clothoid_ = alpha_ == -1 || k0_ == k1_;
    if (is_clothoid_) {
        turn_ = 0.5 * (k0_ + k1_);
        return;
    }
    r_ = std::log(k0_ / k1_);
    const double b = alpha_ * r_, a = b - r_;
    angle_ = Rise(a);
    arc_ = Rise(b);
    turn_ = k0_ * expm1_share(a) / expm1_share(b);
}

double Profile::u_of(double x) const {
    const double b = arc_.exponent();
    if (is_clothoid_ || b == 0) return x;
    // b > 0: from the far end, where e^b would be large.
    if (b > 0) return std::clamp(1 + std::log1p((1 - x) * std::expm1(-b)) / b, 0.0, 1.0);
    return std::clamp(std::log1p(x * std::expm1(b)) / b, 0.0, 1.0);
}

double Profile::angle(double u) const {
    if (is_clothoid_) return u * (k0_ + 0.5 * u * (k1_ - k0_));
    return turn_ * angle_(u);
}

double Profile::curvature(double u) const {
    if (is_clothoid_) return k0_ + u * (k1_ - k0_);
    return k0_ * std::exp(-r_ * u);
}

double Profile::log_slope(double u) const { return -r_ / arc_.speed(u); }

void Profile::curvature_jet(double u, int count, double* out) const {
    if (count == 0) return;
    out[0] = curvature(u);
    if (is_clothoid_) {
        if (count > 1) out[1] = k1_ - k0_;
        std::fill(out + std::min(count, 2), out + count, 0.0);
        return;
    }
    // kappa'/kappa = g and g' = alpha g^2, whatever alpha is.
    const double g = log_slope(u);
    for (int j = 1; j < count; ++j) out[j] = out[j - 1] * g * (1 + (j - 1) * alpha_);
}

double Profile::change() const {
    // A clothoid's angle may go there and back.
    return is_clothoid_ ? std::fabs(k0_) + std::fabs(k1_)
                        : std::fabs(angle_.exponent()) + std::fabs(arc_.exponent()) +
                              std::fabs(r_) + std::fabs(turn_);
}

int Profile::panels() const {
    return std::max(1, static_cast<int>(std::ceil(std::fmin(change() / panel_change, 1e6))));
}

std::complex<double> Profile::step(Interval part) const {
    return integral(part, nodes_for(change() * part.length()));
}

std::complex<double> Profile::rough_step(Interval part) const {
    const double much = change() * part.length();
    return integral(part, much < 0.3 ? 3 : nodes_for(much));
}

std::complex<double> Profile::integral(Interval part, int nodes) const {
    const num::GaussRule rule = num::gauss_legendre(nodes);
    const double half = 0.5 * part.length(), middle = part.middle();
    double x = 0, y = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double u = middle + half * rule.nodes[i];
        const double weight = rule.weights[i] * (is_clothoid_ ? 1 : arc_.speed(u));
        const double theta = angle(u);
        x += weight * std::cos(theta);
        y += weight * std::sin(theta);
    }
    return {half * x, half * y};
}

std::complex<double> Profile::end() const {
    const int count = panels();
    std::complex<double> sum = 0;
    for (int i = 0; i < count; ++i) {
        sum += step({static_cast<double>(i) / count, static_cast<double>(i + 1) / count});
    }
    return sum;
}

}  // namespace batten::spiral
