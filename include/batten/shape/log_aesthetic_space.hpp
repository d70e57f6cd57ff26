#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace batten {

/// A radius that obeys radius^exponent = c s + d (exponent 0: radius = c e^(d s)), as a curvature.
struct RadiusLaw {
    double exponent = -1;
    double c = 0;
    double d = 1;

    /// 1 / radius at arc length s.
    double curvature(double s) const;
    /// Derivatives of the curvature by s, out.size() of them from the 0th.
    void jet(double s, std::span<double> out) const;
};

/// Where a curve starts, and which way it goes: tangent and principal normal, orthonormal.
struct SpaceFrame {
    std::array<double, 3> point{0, 0, 0};
    std::array<double, 3> tangent{1, 0, 0};
    std::array<double, 3> normal{0, 1, 0};
};

/// A log-aesthetic curve in space: radii of curvature and of torsion each obey a radius law. The
/// parameter is arc length, 0 to `length`.
///
/// Source: Frenet's equations [MiuraYoshidaSaito, eq. 10-12], by Magnus steps of order 6 on the
/// rigid motions [BlanesCasasOteoRos2009, eq. 253]. Accuracy: 1e-13 of the length for curves that
/// turn and twist by up to 10. Cost: 0.3 us a point.
class LogAestheticSpaceCurve {
public:
    /// Throws `log-aesthetic.pieces` unless the length is above 0 and both radii are finite and
    /// above 0 all along it, the frame orthonormal to 1e-9.
    LogAestheticSpaceCurve(RadiusLaw curvature, RadiusLaw torsion, double length,
                           const SpaceFrame& start = {});

    int dim() const { return 3; }
    std::span<const double> breaks() const { return breaks_; }
    bool is_closed() const { return false; }
    std::optional<int> degree() const { return std::nullopt; }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    /// A point with the three vectors of its frame.
    struct Motion {
        std::array<double, 3> point, tangent, normal, binormal;
    };
    Motion motion(double s) const;

private:
    Motion stepped(const Motion& from, double s, double step) const;

    RadiusLaw curvature_, torsion_;
    std::array<double, 2> breaks_;
    std::vector<Motion> nodes_;
};

}  // namespace batten
