#include "make/fair/space_arc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "batten/shape/log_aesthetic_space.hpp"
#include "num/symmetric.hpp"

namespace batten::fairing {
namespace {

constexpr std::size_t most_arc_points = 100;
constexpr std::size_t space_unknowns = 10;  ///< start, rotation, radii
constexpr int most_arc_steps = 40;
constexpr double settled = 1e-7;  ///< of the sum of squares
constexpr double widest_ratio = 50;  ///< logarithm of radii

/// Start, how it is turned, and the logarithms of both radii at both ends.
struct SpaceArc {
    SpaceFrame frame;
    std::array<double, 2> radii, torsion_radii;
};

RadiusLaw law_of(double exponent, const std::array<double, 2>& logs, double length) {
    if (exponent == 0) return {0, std::exp(logs[0]), (logs[1] - logs[0]) / length};
    const double first = std::exp(exponent * logs[0]), last = std::exp(exponent * logs[1]);
    return {exponent, (last - first) / length, first};
}

void square_up(SpaceFrame& frame) {
    frame.tangent = (1 / norm(frame.tangent)) * frame.tangent;
    frame.normal = frame.normal + -dot(frame.tangent, frame.normal) * frame.tangent;
    frame.normal = (1 / norm(frame.normal)) * frame.normal;
}

/// The arc with unknown k changed: start, rotation about the axes, radii.
SpaceArc changed(SpaceArc arc, std::size_t k, double by) {
    if (k < 3) {
        arc.frame.point[k] += by;
    } else if (k < 6) {
        SpacePoint axis{0, 0, 0};
        axis[k - 3] = by;
        arc.frame.tangent = arc.frame.tangent + cross(axis, arc.frame.tangent);
        arc.frame.normal = arc.frame.normal + cross(axis, arc.frame.normal);
        square_up(arc.frame);
    } else {
        (k < 8 ? arc.radii[k - 6] : arc.torsion_radii[k - 8]) += by;
    }
    return arc;
}

class ArcSearch {
public:
    ArcSearch(const SpaceGoal& goal, const SpaceTrack& smooth);
    std::optional<SpaceTrack> run();

private:
    bool place(const SpaceArc& arc, const std::vector<double>& s, SpaceTrack& at,
               SpaceTrack* along) const;
    double residuals(const SpaceArc& arc);
    void linearise();
    bool improve();

    const SpaceGoal& goal_;
    bool is_left_ = false;  ///< torsion below 0: everything is mirrored
    double length_ = 0;
    std::vector<double> all_s_, s_;
    SpaceTrack data_, at_, along_, trial_at_, trial_along_;
    SpaceArc arc_;
    double value_ = std::numeric_limits<double>::infinity(), damping_ = 1e-3;
    num::SymmetricMatrix normal_{space_unknowns};
    std::vector<double> right_;
};

SpacePoint mirrored(const SpacePoint& p) { return {p[0], p[1], -p[2]}; }

/// The mean of a logarithm over the first and the last third of positive values.
std::array<double, 2> end_logs(const std::vector<double>& values) {
    const std::size_t third = std::max<std::size_t>(1, values.size() / 3);
    std::array<double, 2> logs{0, 0};
    for (std::size_t i = 0; i < third; ++i) {
        logs[0] -= std::log(values[i]) / static_cast<double>(third);
        logs[1] -= std::log(values[values.size() - 1 - i]) / static_cast<double>(third);
    }
    return logs;
}

ArcSearch::ArcSearch(const SpaceGoal& goal, const SpaceTrack& smooth) : goal_(goal) {
    const std::size_t n = smooth.size();
    std::vector<double> kappa, tau;
    double twist = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (i > 0) length_ += norm(smooth[i] - smooth[i - 1]);
        all_s_.push_back(length_);
        if (i < 3) continue;
        const double t = torsion(smooth[i - 3], smooth[i - 2], smooth[i - 1], smooth[i]);
        tau.push_back(std::fabs(t));
        kappa.push_back(curvature(smooth[i - 2], smooth[i - 1], smooth[i]));
        twist += t;
    }
    is_left_ = twist < 0;
    const double mean_tau = std::accumulate(tau.begin(), tau.end(), 1e-3 / length_) /
                            static_cast<double>(tau.size());
    // Noise makes single torsions as small as it likes.
    for (double& t : tau) t = std::fmax(t, 0.2 * mean_tau);
    for (double& k : kappa) k = std::fmax(k, 1e-3 / length_);
    arc_.radii = end_logs(kappa);
    arc_.torsion_radii = end_logs(tau);
    const std::size_t step = n / 8 + 1;
    const auto point = [&](std::size_t i) { return is_left_ ? mirrored(smooth[i]) : smooth[i]; };
    arc_.frame.point = point(0);
    arc_.frame.tangent = point(step) - point(0);
    arc_.frame.normal = point(2 * step) + -2.0 * point(step) + point(0);
    square_up(arc_.frame);
    for (std::size_t i = 0; i < n; i += n / most_arc_points + 1) {
        data_.push_back(is_left_ ? mirrored(goal.data[i]) : goal.data[i]);
        s_.push_back(all_s_[i]);
    }
}

bool ArcSearch::place(const SpaceArc& arc, const std::vector<double>& s, SpaceTrack& at,
                      SpaceTrack* along) const {
    for (const auto& logs : {arc.radii, arc.torsion_radii}) {
        for (const double log : logs) {
            if (!(std::fabs(log) * std::fmax(1, std::fabs(goal_.alpha) + std::fabs(goal_.beta)) <
                  widest_ratio)) {
                return false;
            }
            if (std::exp(-log) * length_ > 100) return false;  // turns more than any row of points
        }
    }
    const LogAestheticSpaceCurve curve(law_of(goal_.alpha, arc.radii, length_),
                                       law_of(goal_.beta, arc.torsion_radii, length_), length_,
                                       arc.frame);
    at.clear();
    if (along) along->clear();
    for (const double x : s) {
        const LogAestheticSpaceCurve::Motion motion = curve.motion(x);
        at.push_back(motion.point);
        if (along) along->push_back(motion.tangent);
    }
    return true;
}

/// The sum of squares across the arc and of the mean along it.
double ArcSearch::residuals(const SpaceArc& arc) {
    if (!place(arc, s_, trial_at_, &trial_along_)) return std::numeric_limits<double>::infinity();
    double sum = 0, slide = 0;
    for (std::size_t i = 0; i < s_.size(); ++i) {
        const SpacePoint off = data_[i] - trial_at_[i];
        const double along = dot(off, trial_along_[i]);
        sum += dot(off, off) - along * along;
        slide += along;
    }
    return sum + slide * slide / static_cast<double>(s_.size());
}

/// The normal equations at the present arc, by forward differences.
void ArcSearch::linearise() {
    place(arc_, s_, at_, &along_);
    std::array<SpaceTrack, space_unknowns> moved;
    constexpr double step = 1e-6;
    for (std::size_t k = 0; k < space_unknowns; ++k) {
        SpaceTrack there;
        if (!place(changed(arc_, k, step), s_, there, nullptr)) there = at_;
        for (std::size_t i = 0; i < s_.size(); ++i) {
            moved[k].push_back((1 / step) * (there[i] - at_[i]));
        }
    }
    normal_ = num::SymmetricMatrix(space_unknowns);
    right_.assign(space_unknowns, 0);
    std::array<double, space_unknowns> slide{};
    double slide_rest = 0;
    for (std::size_t i = 0; i < s_.size(); ++i) {
        const SpacePoint off = data_[i] - at_[i], t = along_[i];
        slide_rest += dot(off, t);
        for (std::size_t k = 0; k < space_unknowns; ++k) {
            const SpacePoint across = moved[k][i] + -dot(moved[k][i], t) * t;
            slide[k] += dot(moved[k][i], t);
            right_[k] += dot(across, off);
            for (std::size_t l = 0; l <= k; ++l) normal_(k, l) += dot(across, moved[l][i]);
        }
    }
    const double n = static_cast<double>(s_.size());
    for (std::size_t k = 0; k < space_unknowns; ++k) {
        right_[k] += slide[k] * slide_rest / n;
        for (std::size_t l = 0; l <= k; ++l) {
            normal_(k, l) += slide[k] * slide[l] / n;
            normal_(l, k) = normal_(k, l);
        }
    }
}

/// One step; whether the sum of squares still falls.
bool ArcSearch::improve() {
    linearise();
    for (; damping_ < 1e8; damping_ *= 8) {
        num::SymmetricMatrix damped = normal_;
        for (std::size_t k = 0; k < space_unknowns; ++k) damped(k, k) *= 1 + damping_;
        const auto change = num::solve_positive(damped, right_);
        if (!change) continue;
        SpaceArc next = arc_;
        for (std::size_t k = 0; k < space_unknowns; ++k) next = changed(next, k, (*change)[k]);
        const double value = residuals(next);
        if (!(value < value_)) continue;
        const bool falls = value < (1 - settled) * value_;
        arc_ = next;
        value_ = value;
        damping_ = std::fmax(0.1 * damping_, 1e-12);
        return falls;
    }
    return false;
}

std::optional<SpaceTrack> ArcSearch::run() {
    value_ = residuals(arc_);
    if (!std::isfinite(value_)) return std::nullopt;
    for (int i = 0; i < most_arc_steps && improve(); ++i) {
    }
    SpaceTrack track;
    place(arc_, all_s_, track, nullptr);
    if (is_left_) {
        for (SpacePoint& p : track) p = mirrored(p);
    }
    return track;
}

}  // namespace

std::optional<SpaceTrack> arc_along(const SpaceGoal& goal, const SpaceTrack& smooth) {
    return ArcSearch(goal, smooth).run();
}

}  // namespace batten::fairing
