#include "make/fair/filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::fairing {
namespace {

constexpr double least_share = 0.2, most_share = 5;  ///< of the window's mean |kappa|
constexpr std::size_t fewest_samples = 3;
constexpr double sharpest_bend = 1.9;  ///< curvature times chord: at 2 the chord is a diameter

/// rho^alpha from the curvature (alpha = 0: ln rho), and back.
class Power {
public:
    explicit Power(double alpha) : alpha_(alpha) {}
    double of(double kappa) const {
        if (alpha_ == 0.5) return 1 / std::sqrt(kappa);
        if (alpha_ == -1) return kappa;
        if (alpha_ == 1) return 1 / kappa;
        if (alpha_ == 0) return -std::log(kappa);
        return std::pow(kappa, -alpha_);
    }
    /// Nothing sensible below 0, unless alpha is 0.
    double kappa(double value) const {
        if (alpha_ == 0.5) return 1 / (value * value);
        if (alpha_ == -1) return value;
        if (alpha_ == 1) return 1 / value;
        if (alpha_ == 0) return std::exp(-value);
        return std::pow(value, -1 / alpha_);
    }
    bool accepts(double value) const { return alpha_ == 0 || value > 0; }

private:
    double alpha_;
};

/// A least-squares line through (s, f), read at s = 0.
struct LineSums {
    double count = 0, s = 0, ss = 0, f = 0, sf = 0;
    void add(double at, double value) {
        count += 1;
        s += at, ss += at * at, f += value, sf += at * value;
    }
    double at_zero() const { return (ss * f - s * sf) / (count * ss - s * s); }
};

class Filter {
public:
    Filter(const Track& data, const FilterPlan& plan)
        : data_(data), plan_(plan), power_(plan.alpha), track_(data), kappa_(data.size()),
          value_(data.size()), edge_(data.size()) {
        for (std::size_t i = 0; i < data.edges(); ++i) edge_[i] = data.edge(i);
        for (std::size_t i = first_inner(); i < end_inner(); ++i) refresh(i);
        if (plan.foot == Foot::kept) {
            for (std::size_t i = first_inner(); i < end_inner(); ++i) {
                const double h0 = edge_[track_.before(i)], h1 = edge_[i];
                share_.push_back(h0 / (h0 + h1));
            }
        }
    }

    FilterResult run() {
        FilterResult result;
        const double unit = length_of(data_) / static_cast<double>(data_.edges());
        for (; result.sweeps < plan_.sweeps; ++result.sweeps) {
            double most = 0;
            for (std::size_t i = first_inner(); i < end_inner(); ++i) {
                if (!is_split(i)) most = std::fmax(most, move(i));
            }
            result.last_move = most / unit;
        }
        result.track = track_;
        return result;
    }

private:
    std::size_t first_inner() const { return data_.closed ? 0 : 1; }
    std::size_t end_inner() const { return data_.closed ? data_.size() : data_.size() - 1; }
    bool is_split(std::size_t i) const { return !plan_.split.empty() && plan_.split[i]; }

    void refresh(std::size_t i) {
        const std::size_t b = track_.before(i), a = track_.next(i);
        const double ax = track_.x[i] - track_.x[b], ay = track_.y[i] - track_.y[b];
        const double bx = track_.x[a] - track_.x[i], by = track_.y[a] - track_.y[i];
        if (plan_.foot == Foot::kept) {
            kappa_[i] = circle_curvature(ax, ay, bx, by);
        } else {  // U x V / |U|^3 with equal steps
            const double dx = ax + bx, dy = ay + by, d_sq = dx * dx + dy * dy;
            kappa_[i] = 8 * (ax * by - ay * bx) / (d_sq * std::sqrt(d_sq));
        }
        value_[i] = power_.of(std::fabs(kappa_[i]));
    }

    /// Calls sample(j, s) for the window around i, s being arc length from i.
    template <class Sample>
    void for_window(std::size_t i, Sample sample) const {
        sample(i, 0.0);
        double s = 0;
        std::size_t j = i;
        for (int k = 0; k < plan_.window && j + 1 != end_of_row(); ++k) {
            s += edge_[j];
            j = track_.next(j);
            if (is_split(j) || j == i) break;
            sample(j, s);
        }
        s = 0;
        j = i;
        for (int k = 0; k < plan_.window && (data_.closed || j > 1); ++k) {
            j = track_.before(j);
            s -= edge_[j];
            if (is_split(j) || j == i) break;
            sample(j, s);
        }
    }
    /// Rows end before the last point, rings never.
    std::size_t end_of_row() const {
        return data_.closed ? std::numeric_limits<std::size_t>::max() : data_.size() - 1;
    }

    /// The curvature that the window's line wants at i, signed; 0 where it wants nothing.
    double wanted(std::size_t i) const {
        double sum = 0, size = 0, least = std::numeric_limits<double>::infinity(), most = 0;
        LineSums line;
        for_window(i, [&](std::size_t j, double s) {
            const double k = kappa_[j], magnitude = std::fabs(k);
            sum += k;
            size += magnitude;
            // Not fmin and fmax, which are calls.
            least = magnitude < least ? magnitude : least;
            most = magnitude > most ? magnitude : most;
            line.add(s, value_[j]);
        });
        if (line.count < static_cast<double>(fewest_samples)) return 0;
        const double sign = sum < 0 ? -1 : 1, mean = size / line.count;
        const bool is_plain = std::fabs(sum) == size && least >= least_share * mean &&
                              most <= most_share * mean;
        if (!is_plain) {
            line = {};
            for_window(i, [&](std::size_t j, double s) {
                line.add(s, power_.of(std::clamp(sign * kappa_[j], least_share * mean,
                                                 most_share * mean)));
            });
        }
        const double value = line.at_zero();
        return std::isfinite(value) && power_.accepts(value) ? sign * power_.kappa(value) : 0;
    }

    /// Moves point i; by how much.
    double move(std::size_t i) {
        const double kappa = wanted(i);
        if (kappa == 0 || !std::isfinite(kappa)) return 0;
        const std::size_t b = track_.before(i), a = track_.next(i);
        const double dx = track_.x[a] - track_.x[b], dy = track_.y[a] - track_.y[b];
        const double chord_sq = dx * dx + dy * dy;
        double t = 0.5, sagitta = kappa * chord_sq / 8;
        const double chord = std::sqrt(chord_sq), bend = kappa * chord;
        if (!(std::fabs(bend) < sharpest_bend)) return 0;
        if (plan_.foot == Foot::kept) {
            t = share_[i - first_inner()];
            const double x = t * chord;
            const double off = kappa * (x - 0.5 * chord);
            sagitta = kappa * x * (chord - x) /
                      (std::sqrt(1 - off * off) + std::sqrt(1 - 0.25 * bend * bend));
        }
        // A left turn's point lies to the right of the chord.
        const double scale = sagitta / chord;
        double x = track_.x[b] + t * dx + scale * dy, y = track_.y[b] + t * dy - scale * dx;
        keep_within_bound(i, x, y);
        const double mx = x - track_.x[i], my = y - track_.y[i];
        track_.x[i] = x;
        track_.y[i] = y;
        edge_[b] = track_.edge(b);
        edge_[i] = track_.edge(i);
        for (const std::size_t j : {b, i, a}) {
            if (data_.closed || (j > 0 && j + 1 < data_.size())) refresh(j);
        }
        return std::sqrt(mx * mx + my * my);  // working units are near 1: squares are safe
    }

    void keep_within_bound(std::size_t i, double& x, double& y) const {
        if (plan_.bound == 0) return;
        const double ox = x - data_.x[i], oy = y - data_.y[i], distance = std::hypot(ox, oy);
        if (distance <= plan_.bound) return;
        x = data_.x[i] + plan_.bound / distance * ox;
        y = data_.y[i] + plan_.bound / distance * oy;
    }

    const Track& data_;
    const FilterPlan& plan_;
    Power power_;
    Track track_;
    std::vector<double> kappa_, value_, edge_, share_;
};

}  // namespace

FilterResult filtered(const Track& data, const FilterPlan& plan) { return Filter(data, plan).run(); }

double linearity_residual(const Track& track, double alpha) {
    std::vector<double> kappa = curvatures(track), s(track.size(), 0.0);
    for (std::size_t i = 1; i < s.size(); ++i) s[i] = s[i - 1] + track.edge(i - 1);
    if (!track.closed) {
        kappa.pop_back(), kappa.erase(kappa.begin());
        s.pop_back(), s.erase(s.begin());
    }
    return linearity_residual(s, kappa, alpha);
}

double linearity_residual(const std::vector<double>& s, const std::vector<double>& kappa,
                          double alpha) {
    const Power power(alpha);
    LineSums line;
    std::vector<double> at, value;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double radius = power.of(std::fabs(kappa[i]));
        if (kappa[i] == 0 || !std::isfinite(radius)) continue;
        at.push_back(s[i]);
        value.push_back(radius);
        line.add(s[i], value.back());
    }
    const double spread = line.count * line.ss - line.s * line.s;
    if (!(spread > 0)) return 0;
    const double slope = (line.count * line.sf - line.s * line.f) / spread;
    const double mean = line.f / line.count, middle = line.s / line.count;
    double sum = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double rest = value[i] - mean - slope * (at[i] - middle);
        sum += rest * rest;
    }
    const double residual = std::sqrt(sum / line.count) / std::fabs(mean);
    return std::isfinite(residual) ? residual : 0;
}

}  // namespace batten::fairing
