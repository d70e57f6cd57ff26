#include "batten/make/pseudo_segment.hpp"

#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/pseudo/segment/kernel.hpp"
#include "make/pseudo/segment/minima.hpp"

namespace batten {
namespace {

void require_angle(double angle, const char* name) {
    if (std::isfinite(angle)) return;
    throw Error("pseudo.angle", name, format_number(angle), "angles must be finite");
}

void require_magnitude(double r, const char* name) {
    if (1e-9 <= r && r <= 1e9) return;
    throw Error("pseudo.magnitude", name, format_number(r),
                "magnitudes must lie between 1e-9 and 1e9");
}

}  // namespace

PseudoMeasures measure(const PseudoSegment& s) {
    require_angle(s.theta0, "theta0");
    require_angle(s.theta1, "theta1");
    require_magnitude(s.r0, "r0");
    require_magnitude(s.r1, "r1");
    const pseudo::Expansion<0> j = pseudo::expand_value(s);
    if (!std::isfinite(j.value)) {
        throw Error("pseudo.cusp", "segment", "infinite", "a curve with a cusp has no energy");
    }
    const double y0 = s.r0 * std::sin(s.theta0);
    const double y1 = s.r1 * std::sin(s.theta1);
    const double cross = s.r0 * s.r1 * std::sin(s.theta1 - s.theta0);
    PseudoMeasures m{j.energy, j.length, j.value};
    m.area = (y0 - y1) / 10 + cross / 60;
    const double start = -3 * y0 - cross;  // N(0) / 2, [InoueShibata, eq. 14] with its sign turned
    const double end = 3 * y1 - cross;
    m.start_curvature = 2 * start / (s.r0 * s.r0 * s.r0);
    m.end_curvature = 2 * end / (s.r1 * s.r1 * s.r1);
    m.type = start * end >= 0 ? PseudoType::c : PseudoType::s;
    return m;
}

PseudoSegment least_pseudo_segment(double theta0, double theta1) {
    require_angle(theta0, "theta0");
    require_angle(theta1, "theta1");
    return pseudo::least_minimum(theta0, theta1).segment;
}

std::vector<PseudoSegment> pseudo_minima(double theta0, double theta1) {
    require_angle(theta0, "theta0");
    require_angle(theta1, "theta1");
    std::vector<PseudoSegment> segments;
    for (const pseudo::Minimum& minimum : pseudo::all_minima(theta0, theta1)) {
        segments.push_back(minimum.segment);
    }
    return segments;
}

}  // namespace batten
