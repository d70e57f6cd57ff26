#include "batten/measure/arc_length_map.hpp"

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "measure/arc/sections.hpp"

namespace batten {
namespace {

void require_inside(double x, Interval range, const char* what) {
    if (range.contains(x)) return;
    throw Error("curve.outside", what, format_number(x),
                "must lie on the curve, in [" + format_number(range.lo) + ", " +
                    format_number(range.hi) + "]");
}

}  // namespace

ArcLengthMap::ArcLengthMap(const Curve& curve, Tolerance tolerance)
    : sections_(std::make_shared<const arc::Sections>(curve, tolerance)) {}

double ArcLengthMap::length() const { return sections_->length(); }
double ArcLengthMap::error() const { return sections_->error(); }
std::span<const double> ArcLengthMap::joints() const { return sections_->joints(); }

double ArcLengthMap::t_of(double s) const {
    double t;
    t_of({&s, 1}, {&t, 1});
    return t;
}

double ArcLengthMap::s_of(double t) const {
    require_inside(t, sections_->domain(), "parameter");
    return sections_->s_at(t);
}

void ArcLengthMap::t_of(std::span<const double> s, std::span<double> t) const {
    const Interval range{0, length()}, domain = sections_->domain();
    for (const double x : s) require_inside(x, range, "arc length");
    sections_->t_at(s, t);
    // Also where the curve begins or ends with a piece that stands still.
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (s[i] == 0) t[i] = domain.lo;
        if (s[i] == range.hi) t[i] = domain.hi;
    }
}

}  // namespace batten
