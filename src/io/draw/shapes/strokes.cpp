#include "io/draw/shapes/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace batten::drawing {
namespace {

constexpr double shortest_stroke = 0.3;
constexpr double straight = 0.01;  ///< a cubic this near to its chord is drawn as a line
constexpr double largest_radius = 3;
constexpr double smallest_radius = 1.1;
constexpr double share_of_spacing = 0.22;

/// A path that leaves out what is too short to be seen.
class Pen {
public:
    void start(Pixel p) {
        finish();
        path_.move_to(p);
        at_ = drawn_ = p;
    }
    void line_to(Pixel p) {
        at_ = p;
        if (length(p - drawn_) < shortest_stroke) return;
        path_.line_to(p);
        drawn_ = p;
    }
    void curve_to(Pixel a, Pixel b, Pixel p) {
        const Pixel start = at_;
        const double around = length(a - start) + length(b - a) + length(p - b);
        const bool is_line = length(a - start) + length(p - a) < length(p - start) + straight &&
                             length(b - start) + length(p - b) < length(p - start) + straight;
        if (around < shortest_stroke || is_line) {
            line_to(p);
            return;
        }
        finish();
        path_.curve_to(a, b, p);
        at_ = drawn_ = p;
    }
    Pixel at() const { return at_; }
    bool has_started() const { return !path_.empty(); }
    Path path() {
        finish();
        return std::move(path_);
    }

private:
    void finish() {
        if (path_.empty() || length(at_ - drawn_) == 0) return;
        path_.line_to(at_);
        drawn_ = at_;
    }

    Path path_;
    Pixel at_, drawn_;
};

void add_run(Pen& pen, PointsView run, const Frame& frame) {
    if (run.empty()) return;
    pen.start(frame.at(run[0]));
    for (std::size_t i = 1; i < run.size(); ++i) pen.line_to(frame.at(run[i]));
}

}  // namespace

Path path_of(const Trace& trace, const Frame& frame) {
    Pen pen;
    for (const Points& run : trace.runs) add_run(pen, run, frame);
    for (std::size_t i = 0; i < trace.beziers.size(); i += 4) {
        const Pixel start = frame.at(trace.beziers[i]);
        if (!pen.has_started() || length(start - pen.at()) > straight) pen.start(start);
        pen.curve_to(frame.at(trace.beziers[i + 1]), frame.at(trace.beziers[i + 2]),
                     frame.at(trace.beziers[i + 3]));
    }
    return pen.path();
}

Path path_of(const std::vector<Points>& runs, const Frame& frame) {
    Pen pen;
    for (const Points& run : runs) add_run(pen, run, frame);
    return pen.path();
}

std::vector<Pixel> pixels_of(PointsView points, const Frame& frame) {
    std::vector<Pixel> pixels;
    pixels.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) pixels.push_back(frame.at(points[i]));
    return pixels;
}

double dot_radius(std::span<const Pixel> centres) {
    std::vector<double> spacing;
    for (std::size_t i = 1; i < centres.size(); ++i) {
        spacing.push_back(length(centres[i] - centres[i - 1]));
    }
    if (spacing.empty()) return largest_radius;
    const auto middle = spacing.begin() + static_cast<std::ptrdiff_t>(spacing.size() / 2);
    std::nth_element(spacing.begin(), middle, spacing.end());
    return std::clamp(share_of_spacing * *middle, smallest_radius, largest_radius);
}

std::vector<std::size_t> visible_dots(std::span<const Pixel> centres, double radius) {
    constexpr double farthest = 1e5;  // cut pictures may hold dots far outside
    std::vector<std::size_t> result;
    std::unordered_set<std::int64_t> taken;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const auto cell = [&](double x) {
            return std::llround(std::clamp(x, -farthest, farthest) / (0.5 * radius));
        };
        const std::int64_t key = cell(centres[i].x) * (std::int64_t{1} << 32) + cell(centres[i].y);
        if (taken.insert(key).second) result.push_back(i);
    }
    return result;
}

}  // namespace batten::drawing
