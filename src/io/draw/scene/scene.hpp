#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A picture in pixels, y down: what every sink can draw.
namespace batten::drawing {

struct Pixel {
    double x = 0;
    double y = 0;
};

inline Pixel operator+(Pixel a, Pixel b) { return {a.x + b.x, a.y + b.y}; }
inline Pixel operator-(Pixel a, Pixel b) { return {a.x - b.x, a.y - b.y}; }
inline Pixel operator*(double k, Pixel a) { return {k * a.x, k * a.y}; }
inline double length(Pixel a) { return std::hypot(a.x, a.y); }

struct Rect {
    double left = 0;
    double top = 0;
    double width = 0;
    double height = 0;

    double right() const { return left + width; }
    double bottom() const { return top + height; }
    bool contains(Pixel p) const {
        return left <= p.x && p.x <= right() && top <= p.y && p.y <= bottom();
    }
};

/// Moves (M), lines (L), cubics (C, three pixels) and closings (Z, none) in the order of drawing.
struct Path {
    std::string verbs;
    std::vector<Pixel> pixels;

    void move_to(Pixel p) { add('M', {p}); }
    void line_to(Pixel p) { add('L', {p}); }
    void curve_to(Pixel a, Pixel b, Pixel p) { add('C', {a, b, p}); }
    void close() { add('Z', {}); }
    bool empty() const { return verbs.empty(); }

private:
    void add(char verb, std::initializer_list<Pixel> more) {
        verbs += verb;
        pixels.insert(pixels.end(), more);
    }
};

/// An empty colour is none.
struct Paint {
    std::string_view stroke = {};
    double width = 1;
    std::string_view fill = {};
    std::string_view dashes = {};
    double opacity = 1;
};

struct PathShape {
    Path path;
    Paint paint;
};

struct DotsShape {
    std::vector<Pixel> centres;
    double radius = 3;
    Paint paint;
};

enum class Anchor { start, middle, end };
enum class Weight { regular, bold };

struct TextShape {
    Pixel at;  ///< on the base line
    std::string text;
    double size = 11;
    Anchor anchor = Anchor::start;
    std::string_view color = {};
    Weight weight = Weight::regular;
    double halo = 0;  ///< width of the paper-coloured rim that keeps lines away
};

/// What follows is cut off outside of `rect`, up to the next ClipEnd. Clips do not nest.
struct ClipStart {
    Rect rect;
};
struct ClipEnd {};

using Shape = std::variant<PathShape, DotsShape, TextShape, ClipStart, ClipEnd>;

struct Scene {
    double width = 0;
    double height = 0;
    std::string title;
    std::string description;
    std::vector<Shape> shapes;

    void add(Shape shape) { shapes.push_back(std::move(shape)); }
};

}  // namespace batten::drawing
