#include "batten/make/interpolate.hpp"

#include <utility>

#include "make/interpolate/build.hpp"
#include "make/interpolate/log_aesthetic.hpp"
#include "make/interpolate/natural_pass.hpp"
#include "make/interpolate/report.hpp"

namespace batten {
namespace {

Curve part_of(Curve curve, const InterpolateOptions& options) {
    if (!options.part) return curve;
    if (const auto* arcs = curve.shape<LogAestheticCurve>()) {
        return interpolation::between_joints(*arcs, *options.part);
    }
    return interpolation::between_joints(curve, *options.part);
}

}  // namespace

Interpolation interpolate(PointsView points, const InterpolateOptions& options) {
    using interpolation::Side;
    interpolation::Request request = interpolation::checked(points, options);
    InterpolateOptions building = options;
    building.progress = options.progress.stage(0, 0.95);
    interpolation::Built built = interpolation::built(request, building);
    Interpolation result{part_of(std::move(built.curve), options), {}};
    InterpolateReport& report = result.report;
    report.status = built.status;
    report.notes = std::move(request.notes);
    for (std::string& note : built.notes) report.notes.push_back(std::move(note));
    interpolation::add_measures(result.curve, report);
    if (result.curve.dim() == 2) {
        report.tangent_angles = interpolation::joint_angles(result.curve, Side::leaving);
        if (!options.corner.empty()) {
            report.tangent_angles_in = interpolation::joint_angles(result.curve, Side::arriving);
        }
    }
    options.progress.at(1, 1);
    return result;
}

Curve curve_through(PointsView points, const InterpolateOptions& options) {
    interpolation::Request request = interpolation::checked_but_for_chords(points, options);
    if (options.method == Method::natural_chord && !options.closed) {
        if (auto plain = interpolation::plain_natural_curve(request.outline.points)) {
            return part_of(*std::move(plain), options);
        }
    }
    request = interpolation::with_chords(std::move(request), options);
    return part_of(interpolation::built(request, options).curve, options);
}

}  // namespace batten
