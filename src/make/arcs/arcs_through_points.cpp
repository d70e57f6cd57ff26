#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/arcs/fewest.hpp"
#include "make/arcs/fit.hpp"
#include "make/arcs/tangent_chain.hpp"
#include "make/arcs/tangents.hpp"

namespace batten {
namespace {

using namespace arc_spline;
using plane::Vector;

/// The points to join: none equal to the one before.
struct Polygon {
    Points points{2};
    std::vector<std::size_t> row_of_input;  ///< for each point given, its row here
    bool closed = false;

    std::size_t chords() const { return points.size() - (closed ? 0 : 1); }
    std::size_t skipped() const { return row_of_input.size() - points.size(); }
    /// Closed: with the first point repeated at the end.
    Points path() const {
        Points result = points;
        if (closed) result.push_back(points.view()[0]);
        return result;
    }
};

Polygon polygon_of(PointsView points, bool closed) {
    Polygon result;
    result.closed = closed;
    result.points.reserve(points.size());
    result.row_of_input.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t n = result.points.size();
        if (n == 0 || !(plane::at(points, i) == plane::at(result.points, n - 1))) {
            result.points.push_back(points[i]);
        }
        result.row_of_input.push_back(result.points.size() - 1);
    }
    const std::size_t last = result.points.size() - 1;
    if (closed && last > 0 && plane::at(result.points, 0) == plane::at(result.points, last)) {
        result.points = Points(result.points.view().part(0, last));
        for (std::size_t& row : result.row_of_input) row %= last;
    }
    return result;
}

void require_sound_points(PointsView points, const ArcsOptions& options) {
    require_dimension(points, 2, 2);
    require_count(points, options.closed ? 3 : 2);
    batten::require_finite(points);
    for (const FixedTangent& tangent : options.tangent) {
        const bool inside =
            tangent.index >= 0 && static_cast<std::size_t>(tangent.index) < points.size();
        if (!inside || !std::isfinite(tangent.angle.radians)) {
            throw Error("arcs.tangent-index", "tangent",
                        std::to_string(tangent.index) + ":" + format_number(tangent.angle.radians),
                        "must be the index of a point, from 0, and a finite angle");
        }
    }
    if (options.method == ArcMethod::chain && !options.tangent.empty()) {
        throw Error("arcs.tangent-not-taken", "tangent", std::to_string(options.tangent[0].index),
                    "a chain takes a direction at its start only: give start_angle");
    }
}

void require_sound_polygon(const Polygon& polygon) {
    if (polygon.points.size() < 2) require_distinct(polygon.path(), false);
    if (polygon.points.size() < 2) {
        throw Error("points.all-equal", "points", std::to_string(polygon.row_of_input.size()),
                    "arcs need two different points");
    }
    require_count(polygon.points, polygon.closed ? 3 : 2);
}

/// The polygon as one chain, if its start is asked for or can be chosen well.
struct Chain {
    Vector start;
    bool is_smooth = true;  ///< closes, and has no arc of more than half a circle
};

/// One task: a polygon, how to join it, and what to say about it.
class Joiner {
public:
    Joiner(const Polygon& polygon, const ArcsOptions& options)
        : polygon_(polygon),
          options_(options),
          path_(polygon.path()),
          start_(asked_start(options, plane::at(path_, 1) - plane::at(path_, 0))) {}

    ArcFit chain();
    ArcFit biarcs();

private:
    std::optional<Vector> good_start() const;
    std::vector<FixedTangent> given_tangents() const;
    PointTask task() const;
    Tangents tangents(std::span<const std::size_t> reaches) const;
    Row chain_or_lines();
    ArcFit finished(const Row& row);

    const Polygon& polygon_;
    const ArcsOptions& options_;
    Points path_;
    std::optional<Vector> start_;
    Status status_ = Status::met;
    std::vector<std::string> notes_;
};

/// A start for which the chain closes, if it should, without an arc of more than half a circle.
std::optional<Vector> Joiner::good_start() const {
    if (polygon_.closed) return closing_start(path_);
    const Vector start = smoothest_start(path_, false);
    std::vector<double> bulges(polygon_.chords());
    tangent_chain(path_, start, bulges);
    return steepest(bulges) <= 1 ? std::optional(start) : std::nullopt;
}

std::vector<FixedTangent> Joiner::given_tangents() const {
    std::vector<FixedTangent> given;
    for (FixedTangent tangent : options_.tangent) {
        const std::size_t row = polygon_.row_of_input[static_cast<std::size_t>(tangent.index)];
        tangent.index = static_cast<int>(row);
        given.push_back(tangent);
    }
    if (start_) given.push_back({0, {std::atan2(start_->y, start_->x)}});
    return given;
}

PointTask Joiner::task() const {
    const double tolerance =
        options_.tolerance ? options_.tolerance->in_units(extent(polygon_.points)) : 0;
    return {polygon_.points, polygon_.closed, tolerance, radius_limit(options_)};
}

Tangents Joiner::tangents(std::span<const std::size_t> reaches) const {
    return {polygon_.points, reaches, polygon_.closed, given_tangents()};
}

ArcFit Joiner::finished(const Row& row) {
    ArcFit fit = assembled(row, polygon_.closed);
    fit.report.status = status_;
    if (const std::size_t skipped = polygon_.skipped()) {
        notes_.push_back("points equal to the one before skipped: " + std::to_string(skipped));
    }
    if (!fit.report.major_arcs.empty()) {
        notes_.push_back("arcs of more than half a circle: " +
                         std::to_string(fit.report.major_arcs.size()));
    }
    fit.report.notes = std::move(notes_);
    return fit;
}

ArcFit Joiner::chain() {
    const bool asked = options_.method == ArcMethod::chain;
    std::optional<Vector> start = start_ ? start_ : good_start();
    if (!start && asked && !polygon_.closed) start = smoothest_start(path_, false);
    if (start) return finished(chain_row(path_, *start, radius_limit(options_)));
    notes_.push_back(polygon_.closed
                         ? "no tangent chain closes smoothly over these points: biarcs instead"
                         : "a tangent chain would need more than half a circle: biarcs instead");
    if (asked) status_ = Status::not_met;
    return biarcs();
}

/// What stands in for biarcs that need more moves than there are chords.
Row Joiner::chain_or_lines() {
    const std::optional<Vector> start = start_ ? start_ : good_start();
    if (start) {
        notes_.push_back("biarcs within the tolerance need more moves than there are chords: a "
                         "tangent chain through all points instead");
        return chain_row(path_, *start, radius_limit(options_));
    }
    notes_.push_back("biarcs within the tolerance need more moves than there are chords, and no "
                     "tangent chain is smooth: lines instead");
    Row row;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
        row.arcs.push_back({{path_(i, 0), path_(i, 1)}, {path_(i + 1, 0), path_(i + 1, 1)}, 0});
    }
    row.errors.assign(row.arcs.size(), 0.0);
    return row;
}

ArcFit Joiner::biarcs() {
    if (!options_.tolerance) {
        constexpr std::array<std::size_t, 1> neighbours{1};
        return finished(neighbour_biarcs(task(), tangents(neighbours)));
    }
    // Wider circles too: they see the direction of points that are not exact.
    constexpr std::array<std::size_t, 3> reaches{1, 3, 9};
    const std::optional<Row> row = fewest_biarcs(task(), tangents(reaches));
    if (row && row->arcs.size() <= polygon_.chords()) return finished(*row);
    return finished(chain_or_lines());
}

}  // namespace

ArcFit arcs(PointsView points, const ArcsOptions& options) {
    require_sound(options);
    require_sound_points(points, options);
    const double scale = safe_scale(finite_extent(extent(points)));
    if (scale != 1) {
        Points smaller(points);
        for (double& x : smaller.coordinates()) x /= scale;
        ArcsOptions same = options;
        if (same.tolerance && !same.tolerance->is_relative) same.tolerance->value /= scale;
        if (same.max_radius) *same.max_radius /= scale;
        return scaled(arcs(smaller.view(), same), scale);
    }
    const Polygon polygon = polygon_of(points, options.closed);
    require_sound_polygon(polygon);
    const ArcMethod usual =
        options.tolerance || !options.tangent.empty() ? ArcMethod::biarc : ArcMethod::chain;
    Joiner joiner(polygon, options);
    return options.method.value_or(usual) == ArcMethod::chain ? joiner.chain() : joiner.biarcs();
}

}  // namespace batten
