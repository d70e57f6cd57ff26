#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/transform.hpp"
#include "make/arcs/along_curve.hpp"
#include "make/arcs/curve_distance.hpp"
#include "make/arcs/fit.hpp"
#include "make/arcs/tangent_chain.hpp"

namespace batten {
namespace {

using namespace arc_spline;
using plane::Vector;

/// A smooth part of a curve: its joints, and the curve's points there, no two alike in a row.
struct Section {
    std::vector<double> joints;
    Points points{2};
};

Section section_of(const Curve& curve, std::span<const double> joints) {
    Section section;
    for (const double t : joints) {
        const Vector p = station(curve, t, Side::after).point;
        const std::size_t n = section.points.size();
        if (n > 0 && p == plane::at(section.points, n - 1)) continue;
        section.joints.push_back(t);
        section.points.push_back(std::array<double, 2>{p.x, p.y});
    }
    return section;
}

/// The breaks, and `parts` - 1 equally spaced parameters in each piece.
std::vector<double> subdivided(std::span<const double> breaks, int parts) {
    std::vector<double> joints{breaks[0]};
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        for (int k = 1; k < parts; ++k) {
            joints.push_back(breaks[i] + k * ((breaks[i + 1] - breaks[i]) / parts));
        }
        joints.push_back(breaks[i + 1]);
    }
    return joints;
}

class CurveChain {
public:
    CurveChain(const CurveTask& task, const ArcsOptions& options)
        : task_(task), options_(options), corners_(corners(task.curve)) {}

    /// The chain through the curve's points at `joints`, corner to corner, and its errors.
    Row row(const std::vector<double>& joints);
    bool closes() const { return closes_; }

private:
    std::optional<Vector> start_of(const Section& section, bool is_first);

    const CurveTask& task_;
    const ArcsOptions& options_;
    std::vector<double> corners_;
    bool closes_ = true;
};

std::optional<Vector> CurveChain::start_of(const Section& section, bool is_first) {
    const Points& points = section.points;
    const Vector chord = plane::at(points, 1) - plane::at(points, 0);
    const std::optional<Vector> asked = is_first ? asked_start(options_, chord) : std::nullopt;
    if (asked) return asked;
    const std::size_t last = points.size() - 1;
    const bool is_ring = corners_.size() == 2 && task_.curve.is_closed() && last >= 3 &&
                         plane::at(points, 0) == plane::at(points, last);
    return is_ring ? closing_start(points) : smoothest_start(points, false);
}

Row CurveChain::row(const std::vector<double>& joints) {
    Row all;
    closes_ = true;
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
        const auto lo = std::lower_bound(joints.begin(), joints.end(), corners_[i]);
        const auto hi = std::upper_bound(lo, joints.end(), corners_[i + 1]);
        const std::span<const double> between = std::span<const double>(joints).subspan(
            static_cast<std::size_t>(lo - joints.begin()), static_cast<std::size_t>(hi - lo));
        const Section section = section_of(task_.curve, between);
        if (section.points.size() < 2) continue;
        const std::optional<Vector> start = start_of(section, i == 0);
        closes_ = closes_ && start.has_value();
        if (!start) return biarcs_between(task_, joints);
        const Row part = chain_row(section.points, *start, task_.max_radius);
        const std::vector<double> errors = arc_errors(task_.curve, part.arcs, section.joints);
        all.arcs.insert(all.arcs.end(), part.arcs.begin(), part.arcs.end());
        all.errors.insert(all.errors.end(), errors.begin(), errors.end());
    }
    return all;
}

double largest(const Row& row) { return *std::max_element(row.errors.begin(), row.errors.end()); }

/// A chain through more and more points of each piece until it is within the tolerance.
Row chain_along(const CurveTask& task, const ArcsOptions& options, ArcsReport& said) {
    constexpr int most_parts = 1 << 12;
    CurveChain chain(task, options);
    Row row;
    for (int parts = 1; parts <= most_parts; parts *= 2) {
        row = chain.row(subdivided(task.curve.breaks(), parts));
        if (row.arcs.empty() || !options.tolerance || largest(row) <= task.tolerance) break;
    }
    if (!chain.closes()) {
        said.status = Status::not_met;
        said.notes.push_back("no tangent chain closes smoothly over these points: biarcs instead");
    }
    return row;
}

/// What distances from a curve are good to: a tolerance below asks for nothing but rounding.
double rounding_of(const Curve& curve) {
    double largest = 0;
    for (const double t : curve.breaks()) {
        const Vector p = station(curve, t, Side::after).point;
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
    return 0x1p-44 * std::max(largest, extent(curve));
}

void require_sound_curve(const Curve& curve, const ArcsOptions& options) {
    if (curve.dim() != 2) {
        throw Error("curve.dimension", "curve", std::to_string(curve.dim()) + " coordinates",
                    "arcs lie in the plane: 2 coordinates are needed");
    }
    if (!options.tangent.empty()) {
        throw Error("arcs.tangent-not-taken", "tangent", std::to_string(options.tangent[0].index),
                    "a curve has tangents of its own");
    }
    const bool is_chain = options.method == ArcMethod::chain;
    if ((options.start_angle || options.start_normal) && !is_chain) {
        throw Error("arcs.start-not-taken", "start", "given",
                    "biarcs along a curve start as the curve does: use method chain");
    }
}

}  // namespace

ArcFit arcs(const Curve& curve, const ArcsOptions& options) {
    require_sound(options);
    require_sound_curve(curve, options);
    const double scale = safe_scale(finite_extent(extent(curve)));
    if (scale != 1) {
        ArcsOptions same = options;
        if (same.tolerance && !same.tolerance->is_relative) same.tolerance->value /= scale;
        if (same.max_radius) *same.max_radius /= scale;
        return scaled(arcs(batten::scaled(curve, 1 / scale), same), scale);
    }
    CurveTask task{curve, std::numeric_limits<double>::infinity(), radius_limit(options)};
    double asked = task.tolerance;
    if (options.tolerance) asked = options.tolerance->in_units(extent(curve));
    task.tolerance = std::max(asked, rounding_of(curve));
    ArcsReport said;
    Row row;
    if (options.method == ArcMethod::chain) {
        row = chain_along(task, options, said);
    } else if (options.tolerance) {
        row = fewest_biarcs(task);
    } else {
        row = biarcs_between(task, {curve.breaks().begin(), curve.breaks().end()});
    }
    if (row.arcs.empty()) {
        throw Error("curve.one-point", "curve", "no length", "arcs need a curve with a length");
    }
    const bool closed = curve.is_closed() && row.arcs.size() > 1;
    ArcFit fit = assembled(row, closed);
    fit.report.status = said.status;
    fit.report.notes = std::move(said.notes);
    if (options.tolerance && !(fit.report.max_error <= asked)) {
        fit.report.status = Status::not_met;
        if (asked < task.tolerance) {
            fit.report.notes.push_back("tolerance: less than distances are good to: the arcs are "
                                       "laid within " + format_number(task.tolerance));
        }
    }
    return fit;
}

}  // namespace batten
