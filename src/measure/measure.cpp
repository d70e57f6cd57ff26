#include "batten/measure/measure.hpp"

#include "batten/base/text.hpp"
#include "measure/areas.hpp"
#include "measure/bends.hpp"
#include "measure/energies.hpp"
#include "measure/joints.hpp"
#include "measure/lengths.hpp"

namespace batten {
namespace {

using bezier::Motion;

std::string places(const Motion& motion) {
    return std::to_string(motion.pieces.dim()) + " coordinates";
}

void add_areas(const Motion& motion, MeasureReport& report) {
    const bezier::Pieces& pieces = motion.pieces;
    if (pieces.dim() != 2) {
        report.notes.push_back("no area: the curve has " + places(motion));
        return;
    }
    const Measured area = bezier::area(pieces);
    report.area = pieces.in_data(area.value, 2);
    report.area_error = pieces.in_data(area.error, 2);
    if (const auto parts = bezier::areas_by_winding(pieces, area.value)) {
        report.area_positive = pieces.in_data(parts->positive, 2);
        report.area_negative = pieces.in_data(parts->negative, 2);
    } else {
        report.notes.push_back("no area by winding: the curve crosses itself too often");
    }
}

void add_energies(const Motion& motion, const std::vector<Measured>& lengths,
                  MeasureReport& report) {
    const bezier::Pieces& pieces = motion.pieces;
    const bezier::Energies energies = bezier::energies(motion);
    if (energies.diverges_at) {
        report.notes.push_back("no bending energy: the curve stops with infinite curvature at t = " +
                               format_number(*energies.diverges_at));
        return;
    }
    const Measured energy = bezier::total(energies.pieces);
    report.bending_energy = pieces.in_data(energy.value, -1);
    report.bending_energy_error = pieces.in_data(energy.error, -1);
    report.energy_length = energy.value * bezier::total(lengths).value;
    report.pseudo_energy = pieces.in_data(bezier::pseudo_energy(energies, lengths).value, 1);
}

void add_bends(const Motion& motion, MeasureReport& report) {
    report.max_curvature = bezier::max_curvature(motion);
    if (!report.max_curvature) {
        report.notes.push_back("no largest curvature: it is infinite where the curve stops");
    }
    if (motion.pieces.dim() != 2) {
        report.notes.push_back("no turning, no inflections: the curve has " + places(motion));
        return;
    }
    report.turning = bezier::turning(motion);
    report.inflections = bezier::inflections(motion);
    if (bezier::turns_back(motion)) {
        report.notes.push_back("the curve turns back: counted as half a turn to the left");
    }
}

}  // namespace

MeasureReport measure(const Curve& curve, const MeasureOptions& options) {
    bezier::require_tolerance(options.tolerance);
    const Motion motion(curve);
    const bezier::Pieces& pieces = motion.pieces;
    const double tolerance = pieces.in_normal(options.tolerance);
    const std::vector<Measured> lengths = bezier::lengths(motion, tolerance);
    const Measured length = bezier::total(lengths);
    MeasureReport report;
    report.length = pieces.in_data(length.value, 1);
    report.length_error = pieces.in_data(length.error, 1);
    if (length.error > tolerance + 0x1p-48 * length.value) report.status = Status::not_met;
    std::vector<double> moment = bezier::first_moment(motion, tolerance);
    for (double& x : moment) x = length.value > 0 ? x / length.value : 0;
    report.centroid = pieces.to_data(moment);
    add_areas(motion, report);
    add_energies(motion, lengths, report);
    add_bends(motion, report);
    report.joints = bezier::continuity(pieces);
    return report;
}

}  // namespace batten
