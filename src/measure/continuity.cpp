#include "batten/measure/continuity.hpp"

#include <cmath>

#include "measure/joints.hpp"

namespace batten {
namespace bezier {
namespace {

using Vector = std::vector<double>;

constexpr double joint_tolerance = 1e-8;

double norm(std::span<const double> v) {
    double sum = 0;
    for (const double x : v) sum = std::hypot(sum, x);
    return sum;
}

double distance(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum = std::hypot(sum, a[k] - b[k]);
    return sum;
}

/// One side of a joint.
struct Side {
    Jet jet;           // of order 2
    Vector direction;  // of motion; empty for a piece that is a single point
    double h = 0;      // the piece's length in t
    double chord = 0;

    double speed() const { return norm(jet[1]); }
    /// The vector of curvature (r'' - (r''.T) T) / |r'|^2.
    Vector bend() const {
        const double v = speed();
        double along = 0;
        for (std::size_t k = 0; k < direction.size(); ++k) along += jet[2][k] * direction[k];
        Vector result;
        for (std::size_t k = 0; k < direction.size(); ++k) {
            result.push_back((jet[2][k] - along * direction[k]) / v / v);
        }
        return result;
    }
};

enum class End { start, end };

Side side_of(const Pieces& pieces, std::size_t i, End end) {
    const Curve& curve = pieces.curve();
    const Interval part = pieces.part(i), whole = curve.piece(pieces.source(i));
    const double t = end == End::start ? part.lo : part.hi;
    const Jet start = curve.jet_on(pieces.source(i), whole.lo, 0);
    const Jet finish = curve.jet_on(pieces.source(i), whole.hi, 0);
    return {curve.jet_on(pieces.source(i), t, 2), pieces.direction(i, end == End::start ? 0 : 1),
            whole.length(),
            distance(start[0], finish[0])};
}

Continuity between(const Side& left, const Side& right, double extent) {
    constexpr double rounding = 0x1p-48;
    const double far = rounding * norm(left.jet[0]);
    const double h = std::fmin(left.h, right.h);
    const double v = std::fmax(std::fmax(left.speed(), right.speed()),
                               std::fmax(left.chord / left.h, right.chord / right.h));
    const auto agree = [](double gap, double scale, double noise) {
        return gap <= joint_tolerance * scale + noise;
    };
    if (!agree(distance(left.jet[0], right.jet[0]), extent, far)) return Continuity::gap;
    const bool have_directions = !left.direction.empty() && !right.direction.empty();
    if (!have_directions ||
        !agree(distance(left.direction, right.direction), 1, far / (h * v))) {
        return Continuity::C0;
    }
    const bool is_c1 = agree(distance(left.jet[1], right.jet[1]), v, far / h);
    const double bending = std::fmax(norm(left.jet[2]), norm(right.jet[2]));
    if (is_c1 && agree(distance(left.jet[2], right.jet[2]), std::fmax(bending, v / h),
                       far / h / h)) {
        return Continuity::C2;
    }
    const Continuity first = is_c1 ? Continuity::C1 : Continuity::G1;
    if (left.speed() == 0 || right.speed() == 0) return first;
    const Vector bend_left = left.bend(), bend_right = right.bend();
    const double scale = std::fmax(std::fmax(norm(bend_left), norm(bend_right)), 1 / (v * h));
    return agree(distance(bend_left, bend_right), scale, far / (v * h) / (v * h))
               ? Continuity::G2
               : first;
}

}  // namespace

std::vector<Joint> continuity(const Pieces& pieces) {
    std::vector<Joint> joints;
    const double extent = pieces.in_data(pieces.extent(), 1);
    const auto add = [&](std::size_t left, std::size_t right) {
        joints.push_back({pieces.part(right).lo,
                          between(side_of(pieces, left, End::end),
                                  side_of(pieces, right, End::start), extent)});
    };
    if (pieces.curve().is_closed()) add(pieces.size() - 1, 0);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        if (pieces.source(i) != pieces.source(i + 1)) add(i, i + 1);
    }
    return joints;
}

}  // namespace bezier

std::vector<Joint> continuity(const Curve& curve) {
    return bezier::continuity(bezier::Pieces(curve));
}

}  // namespace batten
