/// Draws the figures of Inoue & Shibata, "Pseudo-spline curve", again: `figures FOLDER`.
///
/// Figures 2 and 3: energy against r = r0 = r1. Figure 7: the jump from an s-shaped to a c-shaped
/// segment. Figures 8-12 and 13-17: the data of Tables 1 and 2 by five methods.

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "../figures.hpp"
#include "batten/batten.hpp"

namespace {

using namespace batten;
using papers::save;

constexpr double degree = std::numbers::pi / 180;

/// The segment on the unit chord as a curve.
Curve curve_of(const PseudoSegment& s) {
    const Points ends({0, 0, 1, 0}, 2);
    const Points start({s.r0 * std::cos(s.theta0), s.r0 * std::sin(s.theta0)}, 2);
    const Points end({s.r1 * std::cos(s.theta1), s.r1 * std::sin(s.theta1)}, 2);
    return PiecewiseCubic::hermite(ends, start, end, {0, 1}, false);
}

std::string degrees(double angle) { return format_fixed(angle / degree, 1) + "°"; }

/// Figures 2 and 3: some curves of equal magnitudes, and log10 E against r.
Drawing energy_figure(const std::string& title, double theta0, double theta1,
                      const std::vector<double>& shown) {
    Drawing drawing;
    drawing.title = title;
    drawing.subtitle = "End tangents at " + degrees(theta0) + " and " + degrees(theta1) +
                       " from the chord, both of length r";
    Panel& curves = drawing.panels[0];
    curves.caption = "curves";
    Panel chart;
    chart.kind = PanelKind::chart;
    chart.caption = "energy";
    chart.x_label = "r";
    chart.y_label = "E";
    chart.x_scale = chart.y_scale = AxisScale::log10;

    Points energy(0, 2), marks(0, 2);
    for (int i = 0; i <= 240; ++i) {
        const double r = std::pow(10.0, -0.5 + 2.5 * i / 240);
        const double e = measure(PseudoSegment{theta0, theta1, r, r}).energy;
        energy.push_back(std::array{r, e});
    }
    chart.add(PolylineLayer{{energy}, {}, {Tone::ink}});
    for (const double r : shown) {
        curves.add(CurveLayer{curve_of({theta0, theta1, r, r}), "r = " + format_number(r), {}});
        marks.push_back(std::array{r, measure(PseudoSegment{theta0, theta1, r, r}).energy});
    }
    chart.add(PointsLayer{marks, {}, Marker::closed, {}, PointLabels::none, Tone::accent});
    drawing.panels.push_back(chart);
    return drawing;
}

/// Figure 7: theta0 is held, theta1 grows; the segment of least J keeps to one shape, then jumps.
Drawing jump_figure() {
    const double theta0 = 60 * degree;
    Drawing drawing;
    drawing.title = "Figure 7: the jump from s to c";
    drawing.subtitle = "The segment of least E L² leaves at 60°; its other end tangent turns";
    for (const double theta1 : {0.0, -12.0, -24.0, -26.0, -40.0, -60.0}) {
        const PseudoSegment segment = least_pseudo_segment(theta0, theta1 * degree);
        const bool s_shaped = measure(segment).type == PseudoType::s;
        drawing.add(CurveLayer{curve_of(segment),
                               format_number(theta1) + (s_shaped ? "° (s)" : "° (c)"), {}});
    }
    return drawing;
}

struct Way {
    const char* name;
    Method method;
};
constexpr Way ways[] = {{"cubic spline A, uniform parameter", Method::natural_uniform},
                        {"cubic spline B, chord parameter", Method::natural_chord},
                        {"Hermite curve A, tangents by chords", Method::hermite_chord},
                        {"Hermite curve B, tangents by circles", Method::hermite_arc},
                        {"pseudo-spline", Method::pseudo_spline}};

Points table_1(double y) {
    Points points(0, 2);
    for (int x = -4; x <= 4; ++x) points.push_back(std::array{double(x), x == 0 ? y : 0.0});
    return points;
}

const Points table_2({0, 0, 2, -0.1, 1, -0.1, 3, 0}, 2);

Interpolation through(const Points& points, Method method) {
    InterpolateOptions options;
    options.method = method;
    return interpolate(points, options);
}

Drawing table_figure(int number, const Way& way, const std::vector<Points>& sets) {
    Drawing drawing;
    drawing.title = "Figure " + std::to_string(number) + ": " + way.name;
    drawing.width = 640;
    for (const Points& points : sets) {
        drawing.add(CurveLayer{through(points, way.method).curve, {}, {Tone::ink}});
        drawing.add(PointsLayer{points, {}});
    }
    return drawing;
}

std::string padded(double x) {
    std::string text = format_fixed(x, 6);
    return std::string(text.size() < 16 ? 16 - text.size() : 1, ' ') + text;
}

void print_row(const std::string& data, const Way& way, const InterpolateReport& report) {
    std::cout << data << padded(report.pseudo_energy.value_or(NAN))
              << padded(report.length) << "  " << way.name << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<std::string> given = papers::folder_given(argc, argv);
    if (!given) return 2;
    const std::string& folder = *given;
    save(folder, "figure-02",
         energy_figure("Figure 2: no least energy, not even a local one", 120 * degree,
                       -120 * degree, {1, 3, 8, 20}));
    save(folder, "figure-03",
         energy_figure("Figure 3: a local least energy, and less far away", 45 * degree,
                       -45 * degree, {0.5, 1.1, 4, 12}));
    save(folder, "figure-07", jump_figure());

    std::vector<Points> heights;
    for (int y = 0; y <= 5; ++y) heights.push_back(table_1(y));
    for (int i = 0; i < 5; ++i) {
        const std::string pad(i < 2 ? "0" : "");
        save(folder, "figure-" + pad + std::to_string(8 + i), table_figure(8 + i, ways[i], heights));
        save(folder, "figure-" + std::to_string(13 + i), table_figure(13 + i, ways[i], {table_2}));
    }
    std::cout << "\ndata            sum E L^2          length  method\n";
    for (const Way& way : ways) {
        for (int y = 1; y <= 5; ++y) {
            print_row("y = " + std::to_string(y), way, through(heights[y], way.method).report);
        }
        print_row("table", way, through(table_2, way.method).report);
    }
}
