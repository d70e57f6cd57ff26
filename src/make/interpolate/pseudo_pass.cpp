#include "make/interpolate/pseudo_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/interpolate/request.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/segments.hpp"
#include "num/plane_angles.hpp"
#include "num/sum.hpp"
#include "shape/cubic_room.hpp"

namespace batten::interpolation {
namespace {

constexpr std::size_t most = pseudo::TabulatedBatch::most;
using Column = std::array<double, most>;

struct Plain {
    double x, y;
};

/// The tangent at a point, from the chord before and from the chord after it: its angle, and its
/// cosine and sine as x and y.
struct Joint {
    double before, after;
    Plain along_before, along_after;
};

/// The joints between neighbouring spans.
struct Joints {
    Column cosine, sine, turn, before, after, x_before, y_before, x_after, y_after;

    Joint at(std::size_t k) const {
        return {before[k], after[k], {x_before[k], y_before[k]}, {x_after[k], y_after[k]}};
    }
};

Plain unit(double angle) {
    const num::Direction d = num::direction_of(angle);
    return {d.cosine, d.sine};
}

/// One pass over the spans, a batch of them at a time.
class Pass {
public:
    Pass(const Outline& outline, const PseudoSplineOptions& options, std::span<double> block)
        : points_(outline.points.coordinates().data()),
          lengths_(outline.chords.lengths.data()),
          spans_(outline.chords.lengths.size()),
          count_(outline.points.size()),
          weight_exponent_(options.weight_exponent),
          closed_(outline.closed),
          block_(block) {}

    PseudoSplineMeasures run(const Progress& progress);

private:
    Plain point(std::size_t i) const { return {points_[2 * i], points_[2 * i + 1]}; }
    Plain chord(std::size_t i) const {
        const Plain from = point(i), to = point(i + 1 < count_ ? i + 1 : 0);
        return {to.x - from.x, to.y - from.y};
    }
    Plain direction(std::size_t i) const {
        const Plain c = chord(i);
        return {c.x / lengths_[i], c.y / lengths_[i]};
    }
    void find_joints(std::size_t first, std::size_t count);
    void put_free_ends(std::size_t first, std::size_t count);
    void fill_angles(std::size_t first, std::size_t count);
    void put(std::size_t first, std::size_t count);
    void put_last_joint();
    double* column(std::size_t power, std::size_t coordinate) {
        return block_.data() + (2 * power + coordinate) * (spans_ + 1);
    }

    const double* points_;
    const double* lengths_;
    std::size_t spans_, count_;
    double weight_exponent_;
    bool closed_;
    std::span<double> block_;
    Joint first_{}, last_{};
    pseudo::TabulatedBatch batch_;
    std::array<Plain, most> along0_, along1_;
    Joints joints_;
    num::Sum length_, bulges_, energy_, polygon_;
};

/// Those at the ends of `count` spans from `first` on.
void Pass::find_joints(std::size_t first, std::size_t count) {
    Joints& j = joints_;
    Plain u = direction(first);
    for (std::size_t k = 0; k < count; ++k) {
        const Plain v = direction(first + k + 1 < spans_ ? first + k + 1 : 0);
        j.sine[k] = u.x * v.y - u.y * v.x;
        j.cosine[k] = u.x * v.x + u.y * v.y;
        u = v;
    }
    const auto of = [count](Column& c) { return std::span(c).first(count); };
    num::fill_angles(of(j.cosine), of(j.sine), of(j.turn));
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t after = first + k + 1 < spans_ ? first + k + 1 : 0;
        j.before[k] = pseudo::tabulated_three_point_angle(
            {j.turn[k], lengths_[first + k], lengths_[after]}, weight_exponent_);
        const double from_after = j.before[k] - j.turn[k];
        j.after[k] = from_after == -std::numbers::pi ? std::numbers::pi : from_after;
    }
    num::fill_directions(of(j.before), of(j.x_before), of(j.y_before));
    num::fill_directions(of(j.after), of(j.x_after), of(j.y_after));
}

/// The ends of an open curve, where they are in the batch: a single span is straight.
void Pass::put_free_ends(std::size_t first, std::size_t count) {
    if (closed_ || spans_ == 1) return;
    if (first == 0) {
        batch_.theta0[0] = pseudo::tabulated_end(batch_.theta1[0]).theta1;
        along0_[0] = unit(batch_.theta0[0]);
    }
    if (first + count == spans_) {
        batch_.theta1[count - 1] = pseudo::tabulated_end(batch_.theta0[count - 1]).theta1;
        along1_[count - 1] = unit(batch_.theta1[count - 1]);
    }
}

void Pass::fill_angles(std::size_t first, std::size_t count) {
    const bool has_last = first + count == spans_;
    const std::size_t inner = has_last ? count - 1 : count;
    if (inner > 0) find_joints(first, inner);
    for (std::size_t k = 0; k < count; ++k) {
        const Joint next = k < inner ? joints_.at(k) : first_;
        batch_.theta0[k] = last_.after;
        batch_.theta1[k] = next.before;
        along0_[k] = last_.along_after;
        along1_[k] = next.along_before;
        last_ = next;
    }
    put_free_ends(first, count);
}

void Pass::put(std::size_t first, std::size_t count) {
    const Plain origin = point(0);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        const pseudo::TabulatedSegment& s = batch_.segments[k];
        const Plain from = point(i), step = chord(i);
        const Plain t0{s.r0 * along0_[k].x, s.r0 * along0_[k].y};
        const Plain t1{s.r1 * along1_[k].x, s.r1 * along1_[k].y};
        const Plain start{t0.x * step.x - t0.y * step.y, t0.x * step.y + t0.y * step.x};
        const Plain end{t1.x * step.x - t1.y * step.y, t1.x * step.y + t1.y * step.x};
        const auto set = [&](std::size_t c, double value, double slope, double d0, double d1) {
            column(0, c)[i] = value;
            column(1, c)[i] = d0;
            column(2, c)[i] = 2 * (slope - d0) + (slope - d1);
            column(3, c)[i] = (d0 - slope) + (d1 - slope);
        };
        set(0, from.x, step.x, start.x, end.x);
        set(1, from.y, step.y, start.y, end.y);
        const double l = lengths_[i];
        // [InoueShibata, 5.2] in closed form.
        const double bulge = (t0.y - t1.y) / 10 + (t0.x * t1.y - t0.y * t1.x) / 60;
        length_.add(l * s.length);
        energy_.add(l * s.pseudo_energy);
        bulges_.add(l * l * bulge);
        polygon_.add((from.x - origin.x) * step.y - (from.y - origin.y) * step.x);
    }
}

void Pass::put_last_joint() {
    const Plain final = point(closed_ ? 0 : count_ - 1);
    column(0, 0)[spans_] = final.x;
    column(0, 1)[spans_] = final.y;
    for (std::size_t power = 1; power < 4; ++power) {
        column(power, 0)[spans_] = column(power, 1)[spans_] = 0;
    }
}

PseudoSplineMeasures Pass::run(const Progress& progress) {
    const std::size_t stride = 1 + spans_ / 256;  // between two reports of progress
    first_ = {0, 0, {1, 0}, {1, 0}};
    if (closed_) {
        find_joints(spans_ - 1, 1);
        first_ = joints_.at(0);
    }
    last_ = first_;
    std::size_t since_report = 0;
    for (std::size_t first = 0; first < spans_; first += most) {
        const std::size_t count = std::min(most, spans_ - first);
        fill_angles(first, count);
        pseudo::tabulate_segments(batch_, count);
        put(first, count);
        since_report += count;
        if (since_report >= stride) {
            progress.at(first + count, spans_);
            since_report = 0;
        }
    }
    put_last_joint();
    return {length_.value(), 0.5 * polygon_.value() - bulges_.value(), energy_.value()};
}

}  // namespace

bool has_safe_chords(const Outline& outline) {
    return outline.chords.shortest >= 0x1p-480 && outline.chords.longest <= 0x1p480;
}

PseudoSplineMeasures pseudo_pass(const Outline& outline, const PseudoSplineOptions& options,
                                 std::span<double> block) {
    return Pass(outline, options, block).run(options.progress);
}

PseudoSpline pseudo_pass(const Outline& outline, const PseudoSplineOptions& options) {
    const cubics::Room room(outline.chords.lengths.size() + 1, 2);
    const PseudoSplineMeasures m = pseudo_pass(outline, options, room.block());
    double at = 0;
    for (double& each : room.breaks()) each = at++;
    return {room.curve(outline.closed), m.length, m.area, m.pseudo_energy};
}

}  // namespace batten::interpolation

namespace batten {
namespace {

interpolation::Request checked_plane(PointsView points, const PseudoSplineOptions& options) {
    InterpolateOptions all;
    all.closed = options.closed;
    all.weight_exponent = options.weight_exponent;
    require_dimension(points, 2, 2);
    interpolation::Request request = interpolation::checked(points, all);
    if (!interpolation::has_safe_chords(request.outline)) {
        throw Error("number.overflow", "chords", format_number(request.outline.chords.longest),
                    "lengths must be between 2^-480 and 2^480: scale the points");
    }
    return request;
}

}  // namespace

PseudoSpline pseudo_spline(PointsView points, const PseudoSplineOptions& options) {
    return interpolation::pseudo_pass(checked_plane(points, options).outline, options);
}

PseudoSplineMeasures pseudo_spline(PointsView points, const PseudoSplineOptions& options,
                                   std::span<double> block) {
    const interpolation::Request request = checked_plane(points, options);
    const std::size_t joints = request.outline.chords.lengths.size() + 1;
    if (block.size() != 8 * joints) {
        throw Error("curve.coefficients", "block", std::to_string(block.size()),
                    "8 numbers a joint are needed: " + std::to_string(8 * joints));
    }
    return interpolation::pseudo_pass(request.outline, options, block);
}

}  // namespace batten
