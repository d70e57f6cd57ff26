#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "batten/base/points.hpp"

namespace batten {

/// An arc whose radius of curvature satisfies rho^alpha = c s + d (alpha = 0: ln rho = c s + d).
///
/// alpha = -1: clothoid, 0: Nielsen's spiral, 1: logarithmic spiral, 2: circle involute. Curvatures
/// are signed, left positive; equal ones make a circle, two zeros a straight line. Only alpha = -1
/// has a curvature that may vanish or change its sign. Source: [YoshidaSaito2006].
struct LogAestheticSegment {
    double alpha = -1;
    double length = 0;
    double start_curvature = 0;
    double end_curvature = 0;

    /// ln(rho1 / rho0); 0 where a curvature vanishes or they differ in sign.
    double log_radius_ratio() const;
    /// The angle by which the tangent turns, signed.
    double turn() const;
    bool operator==(const LogAestheticSegment&) const = default;
};

/// A chain of log-aesthetic arcs in the plane, the parameter being arc length from 0.
///
/// Joint i is the point where piece i starts; at a break the value is the joint, bit for bit. What
/// the arcs miss their joints by is spread along them.
/// Accuracy: position 4e-16 of the length of a piece, more by 1e-16 of its turn; derivatives of any
/// order by formula. Cost: 12 sines, cosines and exponentials a point.
/// Source: the log-radius form, in which no alpha is special: q = ln rho linear in u,
///     theta(u) = turn expm1(a u) / expm1(a),  s(u) = length expm1(b u) / expm1(b),
///     b = alpha ln(rho1 / rho0), a = b - ln(rho1 / rho0).
class LogAestheticCurve {
public:
    /// From n + 1 joints, the n directions (radians) in which the pieces start, and n arcs.
    /// Throws `log-aesthetic.pieces` where these do not fit or an arc is none (a length not above
    /// 0, numbers not finite, curvatures of different signs with another alpha than -1 or beyond
    /// e^600 of one another, a turn above 1e5), `points.dimension`,
    /// `points.not-finite`, `curve.breaks`.
    LogAestheticCurve(PointsView joints, std::vector<double> angles,
                      std::vector<LogAestheticSegment> segments, bool closed = false);
    /// One arc from a point. Throws as above.
    LogAestheticCurve(std::span<const double> start, double angle, LogAestheticSegment segment);

    int dim() const { return 2; }
    std::span<const double> breaks() const { return breaks_; }
    bool is_closed() const { return closed_; }
    std::optional<int> degree() const { return std::nullopt; }
    const Points& joints() const { return joints_; }
    std::span<const double> angles() const { return angles_; }
    std::span<const LogAestheticSegment> segments() const { return segments_; }

    /// By how much arc i misses the next joint, as a share of its length.
    double miss(std::size_t i) const { return std::abs(misses_[i]) / segments_[i].length; }

    /// Value and derivatives by arc length on one piece; see `CurveShape`.
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    bool operator==(const LogAestheticCurve& other) const {
        return joints_ == other.joints_ && angles_ == other.angles_ &&
               segments_ == other.segments_ && closed_ == other.closed_;
    }

private:
    void prepare();

    Points joints_;
    std::vector<double> angles_;
    std::vector<LogAestheticSegment> segments_;
    bool closed_;
    std::vector<double> breaks_;
    /// Positions (unit length, start tangent along x) at the panel edges of each piece.
    std::vector<std::complex<double>> edges_;
    std::vector<std::size_t> first_edge_;
    std::vector<std::complex<double>> misses_;
};

}  // namespace batten
