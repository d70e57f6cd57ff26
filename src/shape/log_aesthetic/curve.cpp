#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/log_aesthetic.hpp"
#include "shape/breaks.hpp"
#include "shape/log_aesthetic/profile.hpp"

namespace batten {
namespace {

using spiral::Profile;
using Complex = std::complex<double>;

constexpr double most_turn = 1e5;  ///< radians; of a clothoid that of its tighter end

[[noreturn]] void refuse(std::size_t piece, double value, const char* rule) {
    throw Error("log-aesthetic.pieces", "piece " + std::to_string(piece), format_number(value),
                rule);
}

void require_arc(const LogAestheticSegment& s, double angle, std::size_t piece) {
    for (const double x : {s.alpha, s.start_curvature, s.end_curvature, angle}) {
        if (!std::isfinite(x)) refuse(piece, x, "alpha, curvatures and angles must be finite");
    }
    if (!(s.length > 0) || !std::isfinite(s.length)) {
        refuse(piece, s.length, "a length must be finite and above 0");
    }
    const auto require_turn = [&](double turn) {
        if (!(turn <= most_turn)) refuse(piece, turn, "an arc must turn by at most 1e5 radians");
    };
    if (s.alpha == -1 || s.start_curvature == s.end_curvature) {
        require_turn(std::fmax(std::fabs(s.start_curvature), std::fabs(s.end_curvature)) * s.length);
        return;
    }
    if (!(s.start_curvature / s.end_curvature > 0)) {
        refuse(piece, s.end_curvature, "only with alpha -1 the curvature may change its sign");
    }
    const double r = std::fabs(std::log(s.start_curvature / s.end_curvature));
    if (!(r * std::fmax(1, std::fabs(s.alpha) + 1) <= spiral::largest_exponent)) {
        refuse(piece, r, "the logarithm of the radii's ratio, times |alpha| + 1, must be at most 600");
    }
    require_turn(std::fabs(Profile(s).turn()));
}

Complex point_of(PointsView points, std::size_t row) { return {points(row, 0), points(row, 1)}; }

/// Value and derivatives by arc length of unit length at u, but for the value's constant:
/// from the series E of e^(i theta), k E[k] = i sum j theta[j] E[k - j].
void derivatives(const Profile& profile, double u, Complex tangent, std::span<Complex> out) {
    const int count = static_cast<int>(out.size());
    std::vector<double> kappa(static_cast<std::size_t>(std::max(count - 1, 1)));
    profile.curvature_jet(u, count - 1, kappa.data());
    double factorial = 1;  // of k, for the series of theta: theta[k] = kappa^(k-1) / k!
    out[0] = tangent;
    for (int k = 1; k < count; ++k) {
        factorial *= k;
        kappa[static_cast<std::size_t>(k - 1)] /= factorial;
        Complex sum = 0;
        for (int j = 1; j <= k; ++j) {
            sum += double(j) * kappa[static_cast<std::size_t>(j - 1)] *
                   out[static_cast<std::size_t>(k - j)];
        }
        out[static_cast<std::size_t>(k)] = Complex(0, 1) * sum / double(k);
    }
    factorial = 1;
    for (int k = 1; k < count; ++k) out[static_cast<std::size_t>(k)] *= factorial *= k;
}

}  // namespace

double LogAestheticSegment::log_radius_ratio() const {
    const double ratio = start_curvature / end_curvature;
    return ratio > 0 && std::isfinite(ratio) ? std::log(ratio) : 0;
}

double LogAestheticSegment::turn() const { return Profile(*this).turn(); }

LogAestheticCurve::LogAestheticCurve(PointsView joints, std::vector<double> angles,
                                     std::vector<LogAestheticSegment> segments, bool closed)
    : joints_(joints), angles_(std::move(angles)), segments_(std::move(segments)), closed_(closed) {
    const std::size_t pieces = segments_.size();
    if (pieces == 0 || angles_.size() != pieces || joints_.size() != pieces + 1) {
        throw Error("log-aesthetic.pieces", "curve", std::to_string(pieces) + " arcs",
                    "needs as many directions and one joint more");
    }
    require_dimension(joints, 2, 2);
    require_finite(joints);
    prepare();
}

LogAestheticCurve::LogAestheticCurve(std::span<const double> start, double angle,
                                     LogAestheticSegment segment)
    : joints_(2, 2), angles_{angle}, segments_{segment}, closed_(false) {
    require_arc(segment, angle, 0);
    const PointsView first(start.data(), 1, static_cast<int>(start.size()));
    require_dimension(first, 2, 2);
    require_finite(first);
    const Complex end = segment.length * std::polar(1.0, angle) * Profile(segment).end();
    joints_(0, 0) = start[0];
    joints_(0, 1) = start[1];
    joints_(1, 0) = start[0] + end.real();
    joints_(1, 1) = start[1] + end.imag();
    prepare();
}

void LogAestheticCurve::prepare() {
    breaks_ = {0};
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        require_arc(segments_[i], angles_[i], i);
        breaks_.push_back(breaks_.back() + segments_[i].length);
        const Profile profile(segments_[i]);
        const int panels = profile.panels();
        first_edge_.push_back(edges_.size());
        Complex at = 0;
        for (int k = 0; k < panels; ++k) {
            edges_.push_back(at);
            at += profile.step({double(k) / panels, double(k + 1) / panels});
        }
        misses_.push_back(point_of(joints_, i + 1) - point_of(joints_, i) -
                          segments_[i].length * std::polar(1.0, angles_[i]) * at);
    }
    first_edge_.push_back(edges_.size());
    knots::require_breaks(breaks_);
}

void LogAestheticCurve::jets_on(std::size_t piece, std::span<const double> t, int order,
                                std::span<double> out) const {
    const LogAestheticSegment& segment = segments_[piece];
    const Profile profile(segment);
    const double lo = breaks_[piece], hi = breaks_[piece + 1];
    const Complex start = point_of(joints_, piece), turn = std::polar(1.0, angles_[piece]);
    const std::size_t panels = first_edge_[piece + 1] - first_edge_[piece];
    const std::size_t width = 2 * static_cast<std::size_t>(order + 1);
    std::array<Complex, 4> few;
    std::vector<Complex> many(order > 4 ? static_cast<std::size_t>(order) : 0);
    const std::span<Complex> jet =
        order > 4 ? std::span<Complex>(many) : std::span(few).first(static_cast<std::size_t>(order));
    for (std::size_t i = 0; i < t.size(); ++i) {
        double* const row = out.data() + i * width;
        const double x = (t[i] - lo) / (hi - lo);
        const double u = profile.u_of(x);
        if (t[i] == lo || t[i] == hi) {
            const std::size_t joint = piece + (t[i] == hi);
            row[0] = joints_(joint, 0);
            row[1] = joints_(joint, 1);
        } else {
            const std::size_t panel =
                std::min(panels - 1, static_cast<std::size_t>(std::fmax(0, u * double(panels))));
            const double edge = double(panel) / double(panels);
            const Complex at = edges_[first_edge_[piece] + panel] + profile.step({edge, u});
            const Complex point = start + (segment.length * (turn * at) + x * misses_[piece]);
            row[0] = point.real();
            row[1] = point.imag();
        }
        if (order == 0) continue;
        derivatives(profile, u, turn * std::polar(1.0, profile.angle(u)), jet);
        double scale = 1;
        for (std::size_t k = 0; k < jet.size(); ++k) {
            row[2 * k + 2] = jet[k].real() * scale;
            row[2 * k + 3] = jet[k].imag() * scale;
            scale /= segment.length;
        }
    }
}

}  // namespace batten
