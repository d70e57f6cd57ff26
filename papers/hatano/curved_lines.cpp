/// Draws Figures 4.1 and 4.2 of Hatano's paper on fitting splines again, splines whose knot lines are
/// curves: `curved_lines CASES FOLDER`.

#include <cmath>
#include <iostream>

#include "batten/batten.hpp"

namespace {

using namespace batten;

constexpr std::size_t map_places = 201;
constexpr std::size_t relief_places = 61;

/// Figure 4.2: one line fewer in the first bundle, and the coefficients that it held apart from
/// their like.
CurvedKnotSurface without_a_line(const CurvedKnotSurface& s) {
    constexpr std::size_t line = 3, row = 5;
    std::vector<SplineFunction> lines(s.x_lines().begin(), s.x_lines().end());
    lines.erase(lines.begin() + line);
    std::vector<double> c(s.coefficients().begin(), s.coefficients().end());
    const std::size_t columns = s.y_lines().size() + static_cast<std::size_t>(s.degree()) + 1;
    const auto first = c.begin() + static_cast<std::ptrdiff_t>(row * columns);
    c.erase(first, first + static_cast<std::ptrdiff_t>(columns));
    return {s.degree(), s.domain(), std::move(lines), {s.y_lines().begin(), s.y_lines().end()},
            std::move(c)};
}

Drawing drawn(const std::string& title, const CurvedKnotSurface& s) {
    Panel lines = map_panel(s.domain(), "knot lines");
    for (const PolylineLayer& layer : knot_lines(s)) lines.add(layer);
    const Heights fine = sampled(s, map_places);
    Drawing drawing;
    drawing.title = title;
    drawing.width = 1080;
    drawing.panels = {std::move(lines),
                      level_plot(fine, even_places({0.1, 0.9}, 9), "lines of equal height"),
                      relief_plot(sampled(s, relief_places), {{}, relief_places}, "S")};
    return drawing;
}

/// How S and its slope change from one side of x = 0.25 to the other, at y = 0.2 in the first
/// bundle.
void print_jump(const char* figure, const CurvedKnotSurface& s) {
    constexpr double x = 0.25, y = 0.2, step = 1e-6;
    const double left = (s(x - step, y) - s(x - 2 * step, y)) / step;
    const double right = (s(x + 2 * step, y) - s(x + step, y)) / step;
    std::cout << figure << ": jump " << format_fixed(s(x + 1e-9, y) - s(x - 1e-9, y), 6)
              << ", slopes " << format_fixed(left, 3) << " and " << format_fixed(right, 3) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: curved_lines CASES FOLDER\n";
        return 2;
    }
    const std::string cases = argv[1], folder = argv[2];
    const std::string path = cases + "/surfaces/hatano-figure-4.1.json";
    const CurvedKnotSurface four =
        curved_surface_of(parse_json(read_source(path).bytes, path), path);
    const CurvedKnotSurface three = without_a_line(four);
    write_file(folder + "/figure-4.1.svg", svg(drawn("Figure 4.1", four)));
    write_file(folder + "/figure-4.2.svg", svg(drawn("Figure 4.2: one knot line fewer", three)));
    print_jump("4.1", four);
    print_jump("4.2", three);
}
