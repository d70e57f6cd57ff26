#include "batten/io/draw/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "batten/base/text.hpp"
#include "io/draw/compose.hpp"
#include "io/draw/scene/text_layout.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten {
namespace {

using namespace drawing;

constexpr double chord_error = 0.02;  ///< pixels that a chord may be off its cubic
constexpr double most_chords = 500;
constexpr double farthest_pixel = 1e5;
constexpr double points_per_pixel = 0.75;  ///< gnuplot's pixels are 1/96 inch
constexpr double cap_middle = 0.36;        ///< of the letters' size: their middle over the base line
constexpr double dash_unit = 0.25;         ///< pixels that gnuplot's unit of dashes is, at width 1

std::string number(double x) {
    return format_fixed(std::clamp(x, -farthest_pixel, farthest_pixel), 2);
}

/// In gnuplot's double quotes; only names and captions of people come here.
std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const std::string_view letter : letters_of(text)) {
        const unsigned char first = static_cast<unsigned char>(letter[0]);
        if (letter == "\"" || letter == "\\" || letter == "`" || letter == "$") result += '\\';
        if (first < 0x20 || first == 0x7f) result += ' ';
        else result += letter;
    }
    return result + '"';
}

/// A colour `#rrggbb`, behind it so much of what lies there as the opacity leaves.
std::string color_words(std::string_view color, double opacity) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string alpha;
    if (opacity < 1) {
        const auto rest = static_cast<std::size_t>(std::lround(255 * (1 - opacity)));
        alpha = {digits[rest / 16], digits[rest % 16]};
    }
    return " lc rgb \"#" + alpha + std::string(color.substr(1)) + '"';
}

std::string stroke_words(const Paint& paint) {
    std::string words = " lw " + number(paint.width);
    if (!paint.dashes.empty()) {
        const std::size_t blank = paint.dashes.find(' ');
        const double unit = dash_unit * paint.width;
        const double dash = parse_number(std::string(paint.dashes.substr(0, blank))).value_or(1);
        const double free = parse_number(std::string(paint.dashes.substr(blank + 1))).value_or(1);
        words += " dt (" + number(dash / unit) + ',' + number(free / unit) + ')';
    }
    return words + color_words(paint.stroke, paint.opacity);
}

/// So many chords that none is farther off than can be seen: n of them are off by at most
/// max |B''| / (8 n^2).
int chords_of(Pixel a, Pixel b, Pixel c, Pixel d) {
    const double bend = 6 * std::max(length(a - 2 * b + c), length(b - 2 * c + d));
    const double wanted = std::ceil(std::sqrt(bend / (8 * chord_error)));
    return static_cast<int>(std::clamp(wanted, 1.0, most_chords));
}

/// Pixels as rows, a blank line between runs; cubics as chords.
struct Rows {
    std::string text;
    Pixel start, last;

    void add(Pixel p) {
        text += number(p.x) + ' ' + number(p.y) + '\n';
        last = p;
    }
    void begin(Pixel p) {
        if (!text.empty()) text += '\n';
        start = p;
        add(p);
    }
    void curve(Pixel b, Pixel c, Pixel d) {
        const Pixel a = last;
        const int chords = chords_of(a, b, c, d);
        for (int k = 1; k <= chords; ++k) {
            const double t = k / double(chords), s = 1 - t;
            add(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
        }
    }
};

std::string rows_of(const Path& path) {
    Rows rows;
    std::size_t next = 0;
    const auto pixel = [&] { return path.pixels[next++]; };
    for (const char verb : path.verbs) {
        switch (verb) {
            case 'M': rows.begin(pixel()); break;
            case 'L': rows.add(pixel()); break;
            case 'C': {
                const Pixel b = pixel(), c = pixel();
                rows.curve(b, c, pixel());
                break;
            }
            default: rows.add(rows.start);
        }
    }
    return rows.text;
}

/// A program that draws a scene, part by part: what is clipped alike is plotted at once.
class Program {
public:
    explicit Program(const Scene& scene) : scene_(scene) { part_ = whole(); }

    void operator()(const PathShape& shape) {
        const Paint& paint = shape.paint;
        if (shape.path.empty() || (paint.fill.empty() && paint.stroke.empty())) return;
        const std::string block = data(rows_of(shape.path));
        if (!paint.fill.empty()) {
            plot(block, "with filledcurves closed fs solid noborder" +
                            color_words(paint.fill, paint.opacity));
        }
        if (!paint.stroke.empty()) plot(block, "with lines" + stroke_words(paint));
    }

    void operator()(const DotsShape& shape) {
        if (shape.centres.empty()) return;
        std::string rows;
        for (const Pixel p : shape.centres) {
            rows += number(p.x) + ' ' + number(p.y) + ' ' + number(shape.radius) + '\n';
        }
        const std::string block = data(rows);
        const Paint& paint = shape.paint;
        if (!paint.fill.empty()) {
            plot(block, "with circles fs solid noborder" + color_words(paint.fill, paint.opacity));
        }
        if (!paint.stroke.empty()) plot(block, "with circles fs empty border" + stroke_words(paint));
    }

    void operator()(const TextShape& shape) {
        if (shape.text.empty()) return;
        const char* const side = shape.anchor == Anchor::start    ? "left"
                                 : shape.anchor == Anchor::middle ? "center"
                                                                  : "right";
        const std::string face = shape.weight == Weight::bold ? "Sans:Bold," : "Sans,";
        labels_ += "set label " + quoted(shape.text) + " at first " + number(shape.at.x) + ',' +
                   number(shape.at.y - cap_middle * shape.size) + ' ' + side + " font \"" + face +
                   number(points_per_pixel * shape.size) + "\" tc rgb \"" +
                   std::string(shape.color) + "\" front" + (shape.halo > 0 ? " boxed\n" : "\n");
    }

    void operator()(const ClipStart& clip) {
        finish_part();
        part_ = clip.rect;
    }
    void operator()(const ClipEnd&) {
        finish_part();
        part_ = whole();
    }

    std::string text() {
        finish_part();
        return std::move(text_);
    }

private:
    Rect whole() const { return {0, 0, scene_.width, scene_.height}; }

    std::string data(const std::string& rows) {
        std::string block = "$d" + std::to_string(blocks_++);
        text_ += block + " << END_OF_DATA\n" + rows + "END_OF_DATA\n";
        return block;
    }

    void plot(const std::string& block, const std::string& style) {
        plots_ += (plots_.empty() ? "plot " : ", \\\n     ") + block + ' ' + style;
    }

    /// The part fills its place on the page; its units are pixels, y down.
    void finish_part() {
        if (plots_.empty() && labels_.empty()) return;
        const auto margin = [&](const char* side, double place) {
            text_ += std::string("set ") + side + "margin at screen " + format_fixed(place, 6) + '\n';
        };
        margin("l", part_.left / scene_.width);
        margin("r", part_.right() / scene_.width);
        margin("t", 1 - part_.top / scene_.height);
        margin("b", 1 - part_.bottom() / scene_.height);
        text_ += "set xrange [" + number(part_.left) + ':' + number(part_.right()) +
                 "]\nset yrange [" + number(part_.bottom()) + ':' + number(part_.top) + "]\n" +
                 labels_ + (plots_.empty() ? "plot NaN" : plots_) + "\nunset label\n";
        labels_.clear();
        plots_.clear();
    }

    const Scene& scene_;
    Rect part_;
    std::string text_, labels_, plots_;
    std::size_t blocks_ = 0;
};

std::string terminal(const Scene& scene, ChartFormat format) {
    const auto size = [&](double unit, int digits) {
        return " noenhanced size " + format_fixed(scene.width / unit, digits) + ',' +
               format_fixed(scene.height / unit, digits);
    };
    switch (format) {
        case ChartFormat::svg: return "svg" + size(1, 0);
        case ChartFormat::png: return "pngcairo" + size(1, 0);
        case ChartFormat::pdf: break;
    }
    // Its widths and letters are two thirds of what the others make of the same numbers.
    return "pdfcairo" + size(96, 4) + " fontscale 1.5 linewidth 1.5";
}

}  // namespace

std::string gnuplot_script(const Drawing& drawing, ChartFormat format) {
    const Scene scene = scene_of(drawing);
    Program program(scene);
    for (const Shape& shape : scene.shapes) std::visit([&](const auto& any) { program(any); }, shape);
    return "set encoding utf8\nset terminal " + terminal(scene, format) +
           "\nunset border\nunset tics\nunset key\nset style textbox opaque noborder fillcolor "
           "rgb \"" +
           std::string(paper_color) + "\" margins 0.4,0.2\nset multiplot\n" + program.text() +
           "unset multiplot\n";
}

}  // namespace batten
