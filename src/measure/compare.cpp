#include "batten/measure/compare.hpp"

#include <algorithm>
#include <cmath>

#include "measure/bezier/pieces.hpp"

namespace batten {

CompareReport compare(const Curve& curve, const CompareOptions& options) {
    Tolerance accuracy = options.accuracy;
    double allowed = 0;
    if (options.tolerance) {
        bezier::require_tolerance(*options.tolerance);
        const bezier::Pieces pieces(curve);
        const double normal = pieces.in_normal(*options.tolerance);
        allowed = pieces.in_data(normal, 1);
        const double least = std::fmin(0.01 * normal, pieces.in_normal(accuracy));
        if (pieces.extent() > 0) accuracy = relative(least / pieces.extent());
    }
    const Points* points = std::get_if<Points>(&options.to);
    const Deviation d = points ? deviation(curve, points->view(), accuracy)
                               : deviation(curve, std::get<Curve>(options.to), accuracy);
    CompareReport report{d.max, d.rms, d.mean, d.hausdorff, d.at, std::nullopt, Status::met};
    if (options.tolerance) {
        report.within = std::fabs(d.max) <= allowed;
        if (!*report.within) report.status = Status::not_met;
    }
    return report;
}

}  // namespace batten
