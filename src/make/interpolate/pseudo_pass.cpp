#include "make/interpolate/pseudo_pass.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/interpolate/request.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/segments.hpp"
#include "num/sum.hpp"

namespace batten::interpolation {
namespace {

struct Plain {
    double x, y;
};

/// One pass over the spans, with the tangent at the point before and at the point after each.
class Pass {
public:
    Pass(const Outline& outline, const PseudoSplineOptions& options, std::span<double> block)
        : points_(outline.points.coordinates().data()),
          lengths_(outline.chords.lengths),
          count_(outline.points.size()),
          joints_(lengths_.size() + 1),
          weight_exponent_(options.weight_exponent),
          closed_(outline.closed),
          block_(block) {}

    PseudoSplineMeasures run(const Progress& progress);

private:
    /// The tangent at a point, from the chord before and from the chord after it.
    struct Joint {
        double before, after;
    };

    Plain point(std::size_t i) const { return {points_[2 * i], points_[2 * i + 1]}; }
    Plain chord(std::size_t i) const {
        const Plain from = point(i), to = point(i + 1 < count_ ? i + 1 : 0);
        return {to.x - from.x, to.y - from.y};
    }
    Plain direction(std::size_t i) const {
        const Plain c = chord(i);
        return {c.x / lengths_[i], c.y / lengths_[i]};
    }
    Joint joint(std::size_t before, std::size_t after) const;
    void put(std::size_t i, double theta0, double theta1);
    double* column(std::size_t power, std::size_t coordinate) {
        return block_.data() + (2 * power + coordinate) * joints_;
    }

    const double* points_;
    const std::vector<double>& lengths_;
    std::size_t count_, joints_;
    double weight_exponent_;
    bool closed_;
    std::span<double> block_;
    num::Sum length_, bulges_, energy_, polygon_;
};

Pass::Joint Pass::joint(std::size_t before, std::size_t after) const {
    const Plain u = direction(before), v = direction(after);
    double turn = std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
    if (turn == -std::numbers::pi) turn = std::numbers::pi;
    const double angle = pseudo::tabulated_three_point_angle(
        {turn, lengths_[before], lengths_[after]}, weight_exponent_);
    const double from_after = angle - turn;
    return {angle, from_after == -std::numbers::pi ? std::numbers::pi : from_after};
}

void Pass::put(std::size_t i, double theta0, double theta1) {
    const pseudo::TabulatedSegment s = pseudo::tabulated_segment(theta0, theta1);
    const Plain from = point(i), step = chord(i);
    const Plain t0{s.r0 * std::cos(theta0), s.r0 * std::sin(theta0)};
    const Plain t1{s.r1 * std::cos(theta1), s.r1 * std::sin(theta1)};
    const Plain start{t0.x * step.x - t0.y * step.y, t0.x * step.y + t0.y * step.x};
    const Plain end{t1.x * step.x - t1.y * step.y, t1.x * step.y + t1.y * step.x};
    const auto set = [&](std::size_t k, double value, double slope, double d0, double d1) {
        column(0, k)[i] = value;
        column(1, k)[i] = d0;
        column(2, k)[i] = 2 * (slope - d0) + (slope - d1);
        column(3, k)[i] = (d0 - slope) + (d1 - slope);
    };
    set(0, from.x, step.x, start.x, end.x);
    set(1, from.y, step.y, start.y, end.y);
    const double l = lengths_[i];
    // [InoueShibata, 5.2] in closed form.
    const double bulge = (t0.y - t1.y) / 10 + (t0.x * t1.y - t0.y * t1.x) / 60;
    const Plain origin = point(0);
    length_.add(l * s.length);
    energy_.add(l * s.pseudo_energy);
    bulges_.add(l * l * bulge);
    polygon_.add((from.x - origin.x) * step.y - (from.y - origin.y) * step.x);
}

PseudoSplineMeasures Pass::run(const Progress& progress) {
    const std::size_t spans = lengths_.size();
    const std::size_t stride = 1 + spans / 256;  // between two reports of progress
    const Joint first = closed_ ? joint(spans - 1, 0) : Joint{0, 0};
    Joint last = first;
    std::size_t since_report = 0;
    for (std::size_t i = 0; i < spans; ++i) {
        const bool is_first = i == 0 && !closed_, is_last = i + 1 == spans;
        Joint next = first;
        if (!is_last) next = joint(i, i + 1);
        double theta0 = last.after, theta1 = next.before;
        if (is_first && !is_last) theta0 = pseudo::tabulated_end(theta1).theta1;
        if (is_last && !closed_ && !is_first) theta1 = pseudo::tabulated_end(theta0).theta1;
        put(i, theta0, theta1);
        last = next;
        if (++since_report == stride) {
            progress.at(i + 1, spans);
            since_report = 0;
        }
    }
    const Plain final = point(closed_ ? 0 : count_ - 1);
    column(0, 0)[spans] = final.x;
    column(0, 1)[spans] = final.y;
    for (std::size_t power = 1; power < 4; ++power) {
        column(power, 0)[spans] = column(power, 1)[spans] = 0;
    }
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
    const std::size_t joints = outline.chords.lengths.size() + 1;
    std::vector<double> block(8 * joints), breaks(joints);
    const PseudoSplineMeasures m = pseudo_pass(outline, options, block);
    for (std::size_t i = 0; i < joints; ++i) breaks[i] = static_cast<double>(i);
    return {PiecewiseCubic::power(std::move(block), 2, std::move(breaks), outline.closed),
            m.length, m.area, m.pseudo_energy};
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
