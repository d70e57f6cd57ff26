#include "io/draw/layers/sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "io/draw/layers/marks.hpp"
#include "io/draw/scene/ramp.hpp"
#include "io/draw/scene/theme.hpp"

namespace batten::drawing {
namespace {

using Vec = std::array<double, 3>;

constexpr double seam = 0.5;  ///< width of the rim that closes the seams between cells
constexpr double sheet_dot = 1.8;
constexpr double wire_width = 0.6;
/// Towards the eye, and towards the lamp above its left shoulder.
constexpr Vec eye{0.577, -0.577, 0.577};
constexpr Vec lamp{-0.12, -0.55, 0.827};

double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec difference(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A piece of a line upon a cell, or a dot where both ends are the same.
struct Mark {
    std::size_t cell = 0;
    std::size_t line = 0;  ///< which of the sheet's lines; their number stands for the dots
    Pixel from, to;
};

class Sheet {
public:
    Sheet(const SheetLayer& layer, const Frame& frame) : layer_(layer), frame_(frame) {
        const Grid& nodes = layer.nodes;
        for (std::size_t i = 0; i < nodes.nu(); ++i) {
            for (std::size_t j = 0; j < nodes.nv(); ++j) places_.push_back(node(i, j));
        }
        is_net_ = is_net();
        add_lines();
        if (is_net_) add_dots();
        std::stable_sort(marks_.begin(), marks_.end(),
                         [](const Mark& a, const Mark& b) { return a.cell < b.cell; });
    }

    void draw(Scene& scene) {
        for (const std::size_t cell : order()) {
            draw_cell(scene, cell);
            const auto first = std::lower_bound(
                marks_.begin(), marks_.end(), cell,
                [](const Mark& mark, std::size_t wanted) { return mark.cell < wanted; });
            if (first == marks_.end() || first->cell != cell) continue;
            flush(scene);
            draw_marks(scene, first);
        }
        flush(scene);
    }

private:
    std::size_t rows() const { return layer_.nodes.nu() - 1; }
    std::size_t columns() const { return layer_.nodes.nv() - 1; }
    Vec node(std::size_t i, std::size_t j) const {
        const Grid& nodes = layer_.nodes;
        return {nodes(i, j, 0), nodes(i, j, 1), nodes(i, j, 2)};
    }
    const Vec& place(std::size_t i, std::size_t j) const { return places_[i * (columns() + 1) + j]; }

    bool is_whole(std::size_t cell) const {
        const std::size_t i = cell / columns(), j = cell % columns();
        const Grid& nodes = layer_.nodes;
        return nodes.has(i, j) && nodes.has(i + 1, j) && nodes.has(i, j + 1) &&
               nodes.has(i + 1, j + 1);
    }

    /// Whether rows stand at one x each, rising, and columns at one y.
    bool is_net() const {
        for (std::size_t i = 0; i <= rows(); ++i) {
            for (std::size_t j = 0; j <= columns(); ++j) {
                if (place(i, j)[0] != place(i, 0)[0] || place(i, j)[1] != place(0, j)[1]) {
                    return false;
                }
                if (i > 0 && !(place(i, j)[0] > place(i - 1, j)[0])) return false;
                if (j > 0 && !(place(i, j)[1] > place(i, j - 1)[1])) return false;
            }
        }
        return true;
    }

    /// The cells from far to near. Of two cells of a net one can only hide the other where its
    /// place on the floor is nearer.
    std::vector<std::size_t> order() const {
        std::vector<std::size_t> cells;
        for (std::size_t i = 0; i < rows(); ++i) {
            for (std::size_t j = columns(); j-- > 0;) {
                if (is_whole(i * columns() + j)) cells.push_back(i * columns() + j);
            }
        }
        if (is_net_) return cells;
        std::vector<double> nearness(rows() * columns());
        for (const std::size_t cell : cells) {
            for (const Vec& corner : corners(cell)) nearness[cell] += dot(seen(corner), eye);
        }
        std::stable_sort(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
            return nearness[a] < nearness[b];
        });
        return cells;
    }

    std::array<Vec, 4> corners(std::size_t cell) const {
        const std::size_t i = cell / columns(), j = cell % columns();
        return {place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)};
    }

    Vec seen(const Vec& point) const { return frame_.along_axes(point); }

    int shade(const std::array<Vec, 4>& corner) const {
        const Vec normal = cross(difference(seen(corner[2]), seen(corner[0])),
                                 difference(seen(corner[3]), seen(corner[1])));
        const double size = std::sqrt(dot(normal, normal));
        const double light = size > 0 ? dot(normal, lamp) / size : 1;
        // Both sides of a sheet are lit where they face the eye.
        return class_of(dot(normal, eye) < 0 ? -light : light, {-0.2, 1}, shade_classes);
    }

    void draw_cell(Scene& scene, std::size_t cell) {
        const std::array<Vec, 4> corner = corners(cell);
        const bool is_wire = layer_.style == SheetStyle::wire;
        const std::string_view color =
            is_wire ? paper_color : shade_color(layer_.tone, shade(corner));
        if (is_wire || color != fill_.fill) flush(scene);
        fill_ = is_wire ? Paint{color_of(layer_.tone), wire_width, color} : Paint{color, seam, color};
        for (std::size_t k = 0; k < 4; ++k) {
            k == 0 ? path_.move_to(frame_.at(corner[k])) : path_.line_to(frame_.at(corner[k]));
        }
        path_.close();
    }

    void flush(Scene& scene) {
        if (!path_.empty()) scene.add(PathShape{std::move(path_), fill_});
        path_ = {};
    }

    void draw_marks(Scene& scene, std::vector<Mark>::const_iterator mark) const {
        const std::size_t cell = mark->cell;
        while (mark != marks_.end() && mark->cell == cell) {
            const std::size_t line = mark->line;
            Path path;
            DotsShape dots{{}, sheet_dot, {paper_color, 0.5, ink_color}};
            for (Pixel end{-1, -1}; mark != marks_.end() && mark->cell == cell &&
                                    mark->line == line; ++mark) {
                if (line == layer_.lines.size()) dots.centres.push_back(mark->from);
                else if (path.empty() || length(mark->from - end) > 0) path.move_to(mark->from);
                if (line < layer_.lines.size()) path.line_to(mark->to);
                end = mark->to;
            }
            if (line == layer_.lines.size()) {
                scene.add(std::move(dots));
                continue;
            }
            const LineStyle& style = layer_.lines[line].line;
            scene.add(PathShape{std::move(path), line_paint(style, style.tone.value_or(Tone::ink))});
        }
    }

    /// The cell that holds a place; of two that share a border the nearer one.
    std::size_t cell_at(double u, double v) const {
        const double most_u = static_cast<double>(rows() - 1);
        const double most_v = static_cast<double>(columns() - 1);
        const double i = std::clamp(std::floor(u), 0.0, most_u);
        const double j = std::clamp(std::ceil(v) - 1, 0.0, most_v);
        return static_cast<std::size_t>(i) * columns() + static_cast<std::size_t>(j);
    }

    /// A place between the nodes of `cell`, which holds it.
    Pixel between(std::size_t cell, double u, double v) const {
        const std::array<Vec, 4> corner = corners(cell);
        const double a = u - static_cast<double>(cell / columns());
        const double b = v - static_cast<double>(cell % columns());
        const double shares[] = {(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b};
        Pixel at;
        for (std::size_t k = 0; k < 4; ++k) at = at + shares[k] * frame_.at(corner[k]);
        return at;
    }

    void add_lines() {
        for (std::size_t line = 0; line < layer_.lines.size(); ++line) {
            const Points& places = layer_.lines[line].places;
            for (std::size_t k = 1; k < places.size(); ++k) {
                add_chord(line, places[k - 1], places[k]);
            }
        }
    }

    /// A chord is cut where it crosses a row or column of nodes.
    void add_chord(std::size_t line, std::span<const double> from, std::span<const double> to) {
        std::vector<double> cuts{0, 1};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [lo, hi] = std::minmax(from[k], to[k]);
            for (double at = std::floor(lo) + 1; at < hi; at += 1) {
                cuts.push_back((at - from[k]) / (to[k] - from[k]));
            }
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            const auto u = [&](double t) { return std::lerp(from[0], to[0], t); };
            const auto v = [&](double t) { return std::lerp(from[1], to[1], t); };
            const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
            const std::size_t cell = cell_at(u(middle), v(middle));
            marks_.push_back({cell, line, between(cell, u(cuts[i - 1]), v(cuts[i - 1])),
                              between(cell, u(cuts[i]), v(cuts[i]))});
        }
    }

    void add_dots() {
        for (std::size_t k = 0; k < layer_.dots.size(); ++k) {
            const std::span<const double> at = layer_.dots[k];
            std::size_t i = 0, j = 0;
            while (i + 1 < rows() && place(i + 1, 0)[0] <= at[0]) ++i;
            while (j + 1 < columns() && place(0, j + 1)[1] < at[1]) ++j;
            const Pixel pixel = frame_.at(at);
            marks_.push_back({i * columns() + j, layer_.lines.size(), pixel, pixel});
        }
    }

    const SheetLayer& layer_;
    const Frame& frame_;
    std::vector<Vec> places_;
    bool is_net_ = false;
    std::vector<Mark> marks_;
    Path path_;
    Paint fill_;
};

}  // namespace

void draw_sheet(Scene& scene, const SheetLayer& sheet, const Frame& frame) {
    Sheet(sheet, frame).draw(scene);
}

}  // namespace batten::drawing
