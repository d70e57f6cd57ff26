#include "io/draw/scene/svg.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "batten/base/text.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

/// Clipped pictures may reach far beyond the paper; renderers work with floats.
constexpr double farthest_pixel = 1e5;

std::string number(double x) {
    assert(std::isfinite(x));
    return format_fixed(std::clamp(x, -farthest_pixel, farthest_pixel), 2);
}

std::string attribute(std::string_view name, std::string_view value) {
    if (value.empty()) return {};
    return ' ' + std::string(name) + "=\"" + std::string(value) + '"';
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const std::string_view letter : letters_of(text)) {
        const unsigned char first = static_cast<unsigned char>(letter[0]);
        if (letter == "&") result += "&amp;";
        else if (letter == "<") result += "&lt;";
        else if (letter == ">") result += "&gt;";
        else if (letter == "\"") result += "&quot;";
        else if (first < 0x20 || first == 0x7f) result += ' ';
        else result += letter;
    }
    return result;
}

std::string attributes(const Paint& paint) {
    std::string text = attribute("fill", paint.fill.empty() ? "none" : paint.fill);
    if (!paint.stroke.empty()) {
        text += attribute("stroke", paint.stroke) + attribute("stroke-width", number(paint.width)) +
                attribute("stroke-dasharray", paint.dashes) +
                attribute("stroke-linecap", paint.dashes.empty() ? "" : "butt");
    }
    if (paint.opacity < 1) text += attribute("opacity", number(paint.opacity));
    return text;
}

std::string outline(const Path& path) {
    std::string text;
    std::size_t next = 0;
    for (const char verb : path.verbs) {
        text += verb;
        const int pixels = verb == 'C' ? 3 : verb == 'Z' ? 0 : 1;
        for (int i = 0; i < pixels; ++i, ++next) {
            if (i > 0) text += ' ';
            text += number(path.pixels[next].x) + ' ' + number(path.pixels[next].y);
        }
    }
    return text;
}

struct Writer {
    std::string text;

    void operator()(const PathShape& shape) {
        if (shape.path.empty()) return;
        text += "<path d=\"" + outline(shape.path) + '"' + attributes(shape.paint) + "/>\n";
    }

    void operator()(const DotsShape& shape) {
        if (shape.centres.empty()) return;
        text += "<g" + attributes(shape.paint) + ">\n";
        const std::string radius = "\" r=\"" + number(shape.radius) + "\"/>\n";
        for (const Pixel p : shape.centres) {
            text += "<circle cx=\"" + number(p.x) + "\" cy=\"" + number(p.y) + radius;
        }
        text += "</g>\n";
    }

    void operator()(const TextShape& shape) {
        if (shape.text.empty()) return;
        text += "<text" + attribute("x", number(shape.at.x)) + attribute("y", number(shape.at.y)) +
                attribute("font-size", number(shape.size)) + attribute("fill", shape.color);
        if (shape.anchor == Anchor::middle) text += attribute("text-anchor", "middle");
        if (shape.anchor == Anchor::end) text += attribute("text-anchor", "end");
        if (shape.weight == Weight::bold) text += attribute("font-weight", "600");
        if (shape.halo > 0) {
            text += attribute("stroke", paper_color) +
                    attribute("stroke-width", number(shape.halo)) +
                    attribute("paint-order", "stroke");
        }
        text += '>' + escaped(shape.text) + "</text>\n";
    }

    void operator()(const ClipStart& clip) {
        const Rect& r = clip.rect;
        const std::string box =
            number(r.left) + ' ' + number(r.top) + ' ' + number(r.width) + ' ' + number(r.height);
        text += "<svg" + attribute("x", number(r.left)) + attribute("y", number(r.top)) +
                attribute("width", number(r.width)) + attribute("height", number(r.height)) +
                attribute("viewBox", box) + attribute("overflow", "hidden") + ">\n";
    }

    void operator()(const ClipEnd&) { text += "</svg>\n"; }
};

}  // namespace

std::string svg(const Scene& scene) {
    const std::string width = number(scene.width), height = number(scene.height);
    Writer writer;
    writer.text = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
                  attribute("height", height) +
                  attribute("viewBox", "0 0 " + width + ' ' + height) + attribute("role", "img") +
                  attribute("font-family", fonts) + attribute("stroke-linejoin", "round") +
                  attribute("stroke-linecap", "round") + ">\n";
    if (!scene.title.empty()) writer.text += "<title>" + escaped(scene.title) + "</title>\n";
    writer.text += "<desc>" + escaped(scene.description) + "</desc>\n<rect" +
                   attribute("width", width) + attribute("height", height) +
                   attribute("fill", paper_color) + "/>\n";
    for (const Shape& shape : scene.shapes) std::visit(writer, shape);
    return writer.text + "</svg>\n";
}

}  // namespace batten::drawing
