#include "batten/measure/arc_length_map.hpp"

#include <algorithm>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "measure/arc/cells.hpp"

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
    : cells_(std::make_shared<const arc::Cells>(curve, tolerance)) {}

double ArcLengthMap::length() const { return cells_->length(); }
double ArcLengthMap::error() const { return cells_->error(); }
std::span<const double> ArcLengthMap::joints() const { return cells_->joints(); }

double ArcLengthMap::t_of(double s) const {
    require_inside(s, {0, length()}, "arc length");
    // Also where the curve begins or ends with a piece that stands still.
    if (s == 0) return joints().front();
    if (s == length()) return joints().back();
    return cells_->t_in(cells_->cell_at_s(s), s);
}

double ArcLengthMap::s_of(double t) const {
    require_inside(t, {joints().front(), joints().back()}, "parameter");
    return cells_->s_in(cells_->cell_at_t(t), t);
}

void ArcLengthMap::t_of(std::span<const double> s, std::span<double> t) const {
    const Interval range{0, length()};
    std::size_t cell = 0, first = 0;
    while (first < s.size()) {
        require_inside(s[first], range, "arc length");
        if (s[first] == 0 || s[first] == range.hi) {
            t[first] = s[first] == 0 ? joints().front() : joints().back();
            ++first;
            continue;
        }
        const bool is_ahead = s[first] >= cells_->s(cell).lo;
        const bool is_near = is_ahead && cell + 8 < cells_->size() &&
                             s[first] < cells_->s(cell + 8).hi;
        if (is_near) {
            while (s[first] >= cells_->s(cell).hi) ++cell;
        } else {
            cell = cells_->cell_at_s(s[first]);
        }
        const Interval arc = cells_->s(cell);
        std::size_t last = first + 1;
        while (last < s.size() && s[last] >= arc.lo && s[last] < arc.hi) ++last;
        cells_->t_in(cell, s.subspan(first, last - first), t.subspan(first, last - first));
        first = last;
    }
}

}  // namespace batten
