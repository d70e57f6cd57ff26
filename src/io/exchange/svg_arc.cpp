#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/exchange/svg_pieces.hpp"

namespace batten::path_data {
namespace {

/// A turn by an angle.
struct Rotation {
    double cosine = 1;
    double sine = 0;

    explicit Rotation(double degrees) {
        // Quarter turns are exact.
        const double rest = std::remainder(degrees, 360);
        const double angle = rest * (std::numbers::pi / 180);
        cosine = std::fabs(rest) == 90 ? 0 : std::cos(angle);
        sine = std::fabs(rest) == 180 ? 0 : std::sin(angle);
    }
    Point turned(Point p) const { return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y}; }
    Point turned_back(Point p) const {
        return {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x};
    }
};

/// The ellipse as the image of the unit circle: p -> center + turned(radii * p).
struct Ellipse {
    Point center;
    Point radii;
    Rotation rotation;

    Point image(Point p) const {
        return center + rotation.turned({radii.x * p.x, radii.y * p.y});
    }
};

/// The angle that the arc sweeps on the unit circle between two of its points, in (-2 pi, 2 pi).
double sweep_between(Point from, Point to, bool is_increasing) {
    const double sweep = std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
    if (is_increasing && sweep < 0) return sweep + 2 * std::numbers::pi;
    if (!is_increasing && sweep > 0) return sweep - 2 * std::numbers::pi;
    return sweep;
}

}  // namespace

void append_arc(std::vector<Piece>& pieces, const Arc& arc) {
    if (arc.start == arc.end) return;
    if (arc.radii.x == 0 || arc.radii.y == 0) {
        pieces.push_back({1, {arc.start, arc.end}, 1});
        return;
    }
    Ellipse ellipse{{}, {std::fabs(arc.radii.x), std::fabs(arc.radii.y)},
                    Rotation(arc.rotation_degrees)};
    // Half the chord, seen on the unit circle.
    const Point half = ellipse.rotation.turned_back(0.5 * (arc.start - arc.end));
    Point chord{half.x / ellipse.radii.x, half.y / ellipse.radii.y};
    const double reach = std::hypot(chord.x, chord.y);
    double offset = 0;  // of the centre from the chord's middle, in half chords
    if (reach >= 1) {
        ellipse.radii = reach * ellipse.radii;
        chord = (1 / reach) * chord;
    } else {
        offset = std::sqrt((1 - reach) * (1 + reach)) / reach;
    }
    const Point middle = (arc.is_large == arc.is_increasing ? offset : -offset) *
                         Point{-chord.y, chord.x};
    const Point from = chord - middle, to = Point{} - chord - middle;
    ellipse.center = 0.5 * arc.start + 0.5 * arc.end +
                     ellipse.rotation.turned({ellipse.radii.x * middle.x,
                                              ellipse.radii.y * middle.y});

    const double first = std::atan2(from.y, from.x);
    const double sweep = sweep_between(from, to, arc.is_increasing);
    constexpr double quarter = std::numbers::pi / 2 * (1 + 1e-9);
    const int count = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep) / quarter)));
    const auto unit = [&](double steps) {
        const double angle = first + sweep * (steps / count);
        return Point{std::cos(angle), std::sin(angle)};
    };
    // A quadratic of weights 1, c, 1 with c the cosine of half the piece, raised to a cubic
    // [PieglTiller1997, section 5.5 and eq. 7.33].
    const double c = std::cos(sweep / count / 2);
    Point start = arc.start;
    for (int i = 0; i < count; ++i) {
        const Point peak = 2 * unit(i + 0.5);
        const auto handle = [&](Point on_circle) {
            return ellipse.image((1 / (1 + 2 * c)) * (on_circle + peak));
        };
        const Point end = i + 1 == count ? arc.end : ellipse.image(unit(i + 1));
        pieces.push_back({3, {start, handle(unit(i)), handle(unit(i + 1)), end}, (1 + 2 * c) / 3});
        start = end;
    }
}

}  // namespace batten::path_data
