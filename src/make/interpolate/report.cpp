#include "make/interpolate/report.hpp"

#include <cmath>
#include <numbers>

#include "batten/measure/area.hpp"
#include "batten/measure/curvature.hpp"
#include "batten/measure/energy.hpp"
#include "batten/measure/length.hpp"

namespace batten::interpolation {
namespace {

std::optional<double> value_of(const std::optional<Measured>& measured) {
    return measured ? std::optional(measured->value) : std::nullopt;
}

/// The angle of the first derivative that is not zero; arriving at a cusp, even derivatives point
/// backwards.
double angle_at(const Curve& curve, std::size_t piece, double t, Side side) {
    const Jet jet = curve.jet_on(piece, t, 3);
    int order = 1;
    while (order < 3 && jet[order][0] == 0 && jet[order][1] == 0) ++order;
    const double sign = side == Side::arriving && order == 2 ? -1 : 1;
    const double angle = std::atan2(sign * jet[order][1], sign * jet[order][0]);
    return angle == -std::numbers::pi ? std::numbers::pi : angle;
}

}  // namespace

void add_measures(const Curve& curve, InterpolateReport& report) {
    const Measured arc = length(curve);
    report.length = arc.value;
    report.length_error = arc.error;
    report.pseudo_energy = value_of(pseudo_energy(curve));
    report.bending_energy = value_of(bending_energy(curve));
    report.energy_length = value_of(energy_length(curve));
    report.max_curvature = max_curvature(curve);
    if (!report.bending_energy || !report.max_curvature) {
        report.notes.push_back(
            "the curve stops and turns back: there it has no curvature and no bending energy");
    }
    if (curve.dim() == 2) {
        report.area = area(curve).value;
    } else {
        report.notes.push_back("area and tangent angles exist in the plane only");
    }
}

std::vector<double> joint_angles(const Curve& curve, Side side) {
    const std::size_t pieces = curve.pieces();
    const std::size_t joints = curve.is_closed() ? pieces : pieces + 1;
    std::vector<double> angles(joints);
    for (std::size_t i = 0; i < joints; ++i) {
        const bool has_next = i<pieces, has_last = i> 0 || curve.is_closed();
        if (side == Side::leaving ? has_next : !has_last) {
            angles[i] = angle_at(curve, i, curve.piece(i).lo, Side::leaving);
        } else {
            const std::size_t before = (i + pieces - 1) % pieces;
            angles[i] = angle_at(curve, before, curve.piece(before).hi, Side::arriving);
        }
    }
    return angles;
}

}  // namespace batten::interpolation
