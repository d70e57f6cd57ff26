#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/base/tolerance.hpp"
#include "batten/shape/arc_chain.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// How arcs are laid through points.
enum class ArcMethod {
    chain,  ///< one arc from each point to the next, leaving as the one before arrived
    biarc,  ///< two arcs from point to point, or over the longest stretches within the tolerance
};

constexpr std::array<Named<ArcMethod>, 2> names_of(ArcMethod) {
    return {{{"chain", ArcMethod::chain}, {"biarc", ArcMethod::biarc}}};
}

struct ArcsOptions {
    std::optional<ArcMethod> method;
    std::optional<Tolerance> tolerance;
    std::optional<Angle> start_angle;
    std::optional<Angle> start_normal;
    std::vector<FixedTangent> tangent;
    std::optional<double> max_radius;
    bool closed = false;
};

template <class Options, class Visit>
    requires std::same_as<std::remove_const_t<Options>, ArcsOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("method", o.method, anything,
          "chain: one arc a point, by default for points; biarc: by default for curves and within "
          "a tolerance");
    visit("tolerance", o.tolerance, more_than(0),
          "largest distance of the points, or the curve, from the arcs; as few arcs as that allows");
    visit("start_angle", o.start_angle, anything, "direction in which the first arc starts");
    visit("start_normal", o.start_normal, anything,
          "direction of the normal at the first point, either way round");
    visit("tangent", o.tangent, anything, "a biarc's direction at one of the points");
    visit("max_radius", o.max_radius, more_than(0), "arcs of a larger radius become lines");
    visit("closed", o.closed, anything, "the points are a ring");
}

/// One arc of the result, in the plane.
struct ArcRecord {
    std::array<double, 2> start{};
    std::array<double, 2> end{};
    std::optional<std::array<double, 2>> center;  ///< none for a line
    std::optional<double> radius;
    double sweep = 0;  ///< radians, positive to the left; 0 for a line
    double error = 0;  ///< largest distance of what it stands for
};

template <class Visit>
void visit_fields(const ArcRecord& a, Visit&& visit) {
    visit("start", a.start, "where the arc starts");
    visit("end", a.end, "where it ends: bit for bit where the next one starts");
    visit("center", a.center, "its centre; null for a line");
    visit("radius", a.radius, "its radius; null for a line");
    visit("sweep", a.sweep, "its signed angle, positive to the left; 0 for a line");
    visit("error", a.error, "largest distance of the points or the curve it stands for");
}

struct ArcsReport {
    std::size_t arcs = 0;
    std::size_t lines = 0;
    double max_error = 0;
    double max_tangent_jump = 0;
    std::vector<std::size_t> major_arcs;
    std::vector<ArcRecord> arc;
    Status status = Status::met;  ///< not_met: max_error > tolerance, or the chain asked for
                                  ///< cannot be closed
    std::vector<std::string> notes;
};

template <class Visit>
void visit_fields(const ArcsReport& r, Visit&& visit) {
    visit("arcs", r.arcs, "number of arcs that are no lines");
    visit("lines", r.lines, "number of lines");
    visit("max_error", r.max_error, "largest distance of the points or the curve from the arcs");
    visit("max_tangent_jump", r.max_tangent_jump,
          "largest angle between neighbours at a joint; corners of the curve count");
    visit("major_arcs", r.major_arcs, "arcs of more than half a circle, from 0");
    visit("arc", r.arc, "the arcs in order");
    visit("notes", r.notes, "what was done that was not asked for");
}

struct ArcFit {
    ArcChain chain;
    ArcsReport report;
};

/// Arcs through points of the plane.
///
/// `chain` passes through every point, one arc each, tangents joined [Nakajima, section 5]. Its
/// start is `start_angle` (exact), `start_normal` (the paper's; along or against, whichever runs
/// towards the second point) or, with neither, the direction that makes the sum of squared
/// curvature differences smallest. A wrong start never fades: it turns every joint by the same
/// angle, to alternating sides. Closed, an odd number of points has one smooth chain; an even
/// number has none unless the chords' directions happen to allow it. Where there is none, and
/// where nothing was asked for and an arc would exceed half a circle, biarcs are laid and a note
/// says so.
///
/// `biarc` joins each point to the next by two arcs with equal tangent lengths; directions are
/// given, or those of the circle through three neighbours. With a tolerance: from point to point
/// over as many as it allows, the fewest arcs there are (see src/make/arcs/fewest.hpp for what
/// is tried), and never more moves than there are chords: else the chain is taken, or lines.
///
/// Repeated points are skipped. `error` is the distance of the given points: what the curve does
/// between them nobody knows; give a curve to have that measured.
/// Laws: joints are shared bit for bit; points x 2^k give joints and errors x 2^k, exactly.
/// Throws `points.dimension`, `points.not-finite`, `points.too-few` (2, closed 3 different ones),
/// `points.all-equal`, `arcs.start-twice`, `arcs.start-not-taken`, `arcs.tangent-index`,
/// `arcs.tangent-not-taken`, `arcs.chord-against-start`, `option.range` for a tolerance or
/// radius that is not above 0, `number.overflow` where the extent is beyond a double.
/// Cost: a chain 8 ns an arc and its report about 1 us; a tolerance as in src/make/arcs/fewest.hpp.
ArcFit arcs(PointsView points, const ArcsOptions& options);

/// Arcs along a curve of the plane.
///
/// With a tolerance, `biarc` lays the longest biarcs within it, with the curve's own tangents; of
/// four choices of forced joints (corners, the curvature's extrema, the breaks) the one with the
/// fewest moves. About I / (324 tolerance)^(1/3) biarcs, I the integral of |dkappa/ds|^(1/3) ds.
/// Without one, a biarc over each piece. `chain` joins the points at the breaks, with a tolerance
/// also at more and more places between them (1, 2, 4, ... parts a piece).
///
/// `error` is the distance from the curve to the arcs, searched at 24 or more places a stretch.
/// Where the tangent turns at once the curve has a corner, and so have the arcs. A tolerance below
/// 2^-44 of the largest coordinate is less than distances are good to: arcs are laid within that,
/// and the report says so.
/// Throws `curve.dimension` unless it is planar, `curve.one-point`, and of the above what fits.
ArcFit arcs(const Curve& curve, const ArcsOptions& options);

}  // namespace batten
