/// Draws the figures of Nakajima, "Graphics and Lagrange's interpolation", again and prints its
/// numbers beside ours: `figures FOLDER`.
///
/// Figures 2 and 3: points of a curve over a parameter. Figures 4 and 5: the windows. Figure 6: an
/// aerofoil and streamlines. Figure 7: errors of the interpolation, Figure 8: of arcs. Figure 9:
/// one step of the chain of arcs. And a curve in space that is made denser before or after it is
/// projected.

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "../figures.hpp"
#include "batten/batten.hpp"
#include "examples.hpp"
#include "joukowski.hpp"
#include "projection.hpp"

namespace {

using namespace batten;
using papers::save;
using namespace nakajima;

using std::numbers::pi;

Panel chart(const std::string& caption, const std::string& x, const std::string& y) {
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.caption = caption;
    panel.x_label = x;
    panel.y_label = y;
    return panel;
}

// ---- Figures 2 and 3

double free_x(double t) { return 4 * t + 0.45 * std::sin(2.2 * pi * t); }
double free_y(double t) { return 1.6 * std::sin(1.5 * pi * t + 0.3) + 0.9 * t; }

/// `f` as a run of points over t = 0 ... 1, and at its sevenths.
struct Sampled {
    Points line = Points(0, 2), dots = Points(0, 2);
};
template <class X, class Y>
Sampled sampled(X x, Y y) {
    Sampled result;
    for (int i = 0; i <= 280; ++i) {
        const std::array p{x(i / 280.0), y(i / 280.0)};
        result.line.push_back(p);
        if (i % 40 == 0) result.dots.push_back(p);
    }
    return result;
}

void draw_parameter_figures(const std::string& folder) {
    const auto itself = [](double t) { return t; };
    const Sampled plane = sampled(free_x, free_y);
    Drawing curve;
    curve.title = "Figure 2: a curve and points on it";
    curve.width = 560;
    PointsLayer numbered{plane.dots, "points at equal steps of t"};
    numbered.labels = PointLabels::index;
    curve.add(PolylineLayer{{plane.line}, "curve", {Tone::ink}}).add(numbered);
    save(folder, "figure-02", curve);

    Drawing both;
    both.title = "Figure 3: its coordinates over the parameter";
    both.panels = {chart("x(t)", "t", "x"), chart("y(t)", "t", "y")};
    const Sampled parts[] = {sampled(itself, free_x), sampled(itself, free_y)};
    for (std::size_t i = 0; i < 2; ++i) {
        both.panels[i].add(PolylineLayer{{parts[i].line}, "curve", {Tone::ink}});
        both.panels[i].add(PointsLayer{parts[i].dots, "points at equal steps of t"});
    }
    save(folder, "figure-03", both);
}

// ---- Figures 4 and 5

/// The polynomial through the values at `nodes`, over [from, to].
Points polynomial(const std::vector<double>& nodes, const std::vector<double>& values, double from,
                  double to) {
    Points line(0, 2);
    for (int i = 0; i <= 80; ++i) {
        const double t = from + (to - from) * i / 80;
        const std::vector<double> weights = lagrange_weights(nodes, t);
        double f = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k) f += weights[k] * values[k];
        line.push_back(std::array{t, f});
    }
    return line;
}

/// One window: its polynomial thin, and thick in the cell that it serves.
Panel window_panel(const std::string& caption, int first, int degree) {
    constexpr std::array data{0.4, 1.5, 1.2, 2.3, 2.0, 0.9};  // at the points k - 2 ... k + 3
    const auto value = [&](int i) { return data[static_cast<std::size_t>(i + 2)]; };
    std::vector<double> nodes, values;
    Points used(0, 2), others(0, 2);
    for (int i = -2; i <= 3; ++i) {
        const bool is_used = i >= first && i <= first + degree;
        (is_used ? used : others).push_back(std::array{double(i), value(i)});
        if (!is_used) continue;
        nodes.push_back(i);
        values.push_back(value(i));
    }
    Panel panel = chart(caption, "point, from k", "f");
    panel.x_range = Interval{-2.4, 3.4};
    panel.y_range = Interval{0, 2.8};
    panel.add(PolylineLayer{{polynomial(nodes, values, first, first + degree)},
                            "polynomial of the window", {Tone::blue, Dash::dashed, 1.2}});
    panel.add(PolylineLayer{{polynomial(nodes, values, 0, 1)}, "the part that is used",
                            {Tone::accent, Dash::solid, 3.2}});
    panel.add(PointsLayer{others, "other points", Marker::open, {}, PointLabels::none, Tone::grey});
    panel.add(PointsLayer{used, "points of the window", Marker::closed});
    return panel;
}

void draw_windows(const std::string& folder) {
    Drawing two;
    two.title = "Figure 4: windows of degree 2";
    two.panels = {window_panel("forward", 0, 2), window_panel("backward (last cell)", -1, 2)};
    save(folder, "figure-04", two);
    Drawing three;
    three.title = "Figure 5: windows of degree 3";
    three.panels = {window_panel("forward (first cell)", 0, 3), window_panel("central", -1, 3),
                    window_panel("backward (last cell)", -2, 3)};
    save(folder, "figure-05", three);
}

// ---- Figure 6

Densified filled(const Points& points, LagrangeParameter parameter = LagrangeParameter::index) {
    DensifyOptions options;
    options.between = 3;
    options.parameter = parameter;
    return densify(points, options);
}

constexpr double streams[] = {0.8, 0.35, -0.35, -0.8};

void draw_aerofoil(const std::string& folder) {
    Drawing drawing;
    drawing.title = "Figure 6: an aerofoil and streamlines";
    drawing.subtitle = "Degree 3, three new points a cell; every side of the aerofoil by itself";
    Points given(0, 2), made(0, 2);
    const auto add = [&](const Points& points, const std::string& name, LineStyle style) {
        const Densified dense = filled(points);
        drawing.add(CurveLayer{dense.curve, name, style});
        for (std::size_t i = 0; i < points.size(); ++i) given.push_back(points.view()[i]);
        for (std::size_t i = 0; i < dense.points.size(); ++i) {
            if (i % 4 != 0) made.push_back(dense.points.view()[i]);
        }
    };
    for (const Side side : {Side::upper, Side::lower}) {
        add(aerofoil_points(side, 10), "aerofoil", {Tone::ink, Dash::solid, 1.9});
    }
    for (const double psi : streams) {
        add(stream_points(psi), "streamlines", {Tone::blue, Dash::solid, 1.4});
    }
    drawing.add(PointsLayer{made, "new points", Marker::closed, {}, PointLabels::none, Tone::grey});
    drawing.add(PointsLayer{given, "points given"});
    save(folder, "figure-06", drawing);
}

/// Largest distance of the new points from the aerofoil, in percent of the chord.
double aerofoil_error(Side side, LagrangeParameter parameter) {
    const Points dense = filled(aerofoil_points(side, 10), parameter).points;
    const double step = pi / static_cast<double>(dense.size() - 1);
    double largest = 0;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        const double angle = start_angle(side) + step * static_cast<double>(i);
        const Interval near{angle - 8 * step, angle + 8 * step};
        largest = std::max(largest, aerofoil_distance(dense.view()[i], near));
    }
    return 100 * largest / chord();
}

double stream_error(double psi, LagrangeParameter parameter) {
    const Points dense = filled(stream_points(psi), parameter).points;
    double largest = 0;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        largest = std::max(largest, std::fabs(dense(i, 1) - stream_height(dense(i, 0), psi)));
    }
    return 100 * largest / chord();
}

// ---- Figures 7 and 8

void add_errors(Panel& panel, const ErrorCurve& errors, const std::string& name, LineStyle line) {
    panel.add(PolylineLayer{errors.runs, name, line});
    panel.add(PointsLayer{errors.at_quarters, {}, Marker::closed, {}, PointLabels::none,
                          line.tone.value_or(Tone::ink)});
}

void draw_error_figures(const std::string& folder) {
    for (int i = 0; i < 3; ++i) {
        const Example& example = examples[i];
        Drawing drawing;
        drawing.title = "Figure 7." + std::to_string(i + 1) + ": errors of the interpolation, " +
                        "curve " + example.name;
        drawing.subtitle =
            std::string(example.formula) + "; percent of b, dots at s = 1/4, 1/2, 3/4";
        drawing.panels.clear();
        for (const int degree : {2, 3}) {
            Panel panel = chart("degree " + std::to_string(degree), "t / π", "error, %");
            add_errors(panel, errors_of(example, lagrange_curve(example, 4, degree)), "n = 4",
                       {Tone::ochre, Dash::dashed, 1.5});
            add_errors(panel, errors_of(example, lagrange_curve(example, 6, degree)), "n = 6",
                       {Tone::blue, Dash::solid, 1.7});
            drawing.panels.push_back(panel);
        }
        save(folder, "figure-07-" + std::to_string(i + 1), drawing);
    }
    Drawing arcs;
    arcs.title = "Figure 8: errors of the chain of arcs, n = 6";
    arcs.subtitle = "Percent of b; it starts along the curve's own tangent";
    arcs.panels.clear();
    for (const Example& example : examples) {
        Panel panel = chart(std::string("curve ") + example.name, "t / π", "error, %");
        add_errors(panel, errors_of(example, lagrange_curve(example, 6, 2)), "Lagrange, degree 2",
                   {Tone::grey, Dash::dashed, 1.3});
        add_errors(panel, errors_of(example, arc_curve(example, 6)), "arcs",
                   {Tone::accent, Dash::solid, 1.7});
        arcs.panels.push_back(panel);
    }
    save(folder, "figure-08", arcs);
}

// ---- Figure 9

void draw_arc_step(const std::string& folder) {
    Drawing drawing;
    drawing.title = "Figure 9: one step of the chain of arcs";
    drawing.subtitle = "The centre lies on the normal at the point and on the chord's bisector";
    drawing.width = 620;
    const Points points({0, 0, 1.5, 1.2, 3.4, 1.0}, 2);
    ArcsOptions options;
    options.method = ArcMethod::chain;
    options.start_angle = Angle{1.15};
    const ArcChain chain = arcs(points, options).chain;
    std::vector<Points> radii, bisectors;
    Points centres(0, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const Arc arc = chain.arc(i);
        const auto [ax, ay] = arc.start;
        const auto [bx, by] = arc.end;
        const auto [cx, cy] = *arc.center();
        centres.push_back(std::array{cx, cy});
        radii.push_back(Points({ax, ay, cx, cy, bx, by}, 2));
        bisectors.push_back(Points({(ax + bx) / 2, (ay + by) / 2, cx, cy}, 2));
    }
    drawing.add(PolylineLayer{{points}, "chords", {Tone::grey, Dash::solid, 1.0}});
    drawing.add(
        PolylineLayer{bisectors, "bisectors of the chords", {Tone::grey, Dash::dotted, 1.2}});
    drawing.add(PolylineLayer{radii, "normals", {Tone::teal, Dash::dashed, 1.2}});
    drawing.add(CurveLayer{chain, "arcs", {Tone::accent, Dash::solid, 2.4}});
    drawing.add(PointsLayer{points, {}, Marker::closed});
    drawing.add(PointsLayer{centres, {}, Marker::open, {}, PointLabels::none, Tone::teal});
    const char* const names[] = {"P0", "P1", "P2"};
    for (std::size_t i = 0; i < 3; ++i) {
        const double aside = i == 0 ? 0.28 : 0;  // clear of the arc that leaves there
        drawing.add(TextLayer{{points(i, 0) - aside, points(i, 1)}, names[i]});
    }
    for (std::size_t i = 0; i < 2; ++i) {
        drawing.add(TextLayer{{centres(i, 0), centres(i, 1)}, i == 0 ? "C0" : "C1", Tone::teal});
    }
    save(folder, "figure-09", drawing);
}

// ---- The numbers

/// A row of the paper's tables (6), (8), (10), (12), (14), as printed.
struct PrintedRow {
    const char* window;
    int equation, first;
    double s;
    std::vector<int> numerators;
    int denominator;
};

const std::vector<PrintedRow> printed{
    {"degree 2, forward ", 6, 0, 0.25, {21, 14, -3}, 32},
    {"degree 2, forward ", 6, 0, 0.50, {3, 6, -1}, 8},
    {"degree 2, forward ", 6, 0, 0.75, {5, 30, -3}, 32},
    {"degree 2, backward", 8, -1, 0.25, {-3, 30, 5}, 32},
    {"degree 2, backward", 8, -1, 0.50, {-1, 6, 3}, 8},
    {"degree 2, backward", 8, -1, 0.75, {-3, 14, 21}, 32},
    {"degree 3, forward ", 10, 0, 0.25, {77, 77, -33, 7}, 128},
    {"degree 3, forward ", 10, 0, 0.50, {5, 15, -5, 1}, 16},
    {"degree 3, forward ", 10, 0, 0.75, {15, 135, -27, 5}, 128},
    {"degree 3, central ", 12, -1, 0.25, {-7, 105, 35, -5}, 128},
    {"degree 3, central ", 12, -1, 0.50, {-1, 9, 9, -1}, 16},
    {"degree 3, central ", 12, -1, 0.75, {-5, 35, 105, -7}, 128},
    {"degree 3, backward", 14, -2, 0.25, {5, -27, 135, 15}, 128},
    {"degree 3, backward", 14, -2, 0.50, {-1, -5, 15, 5}, 16},
    {"degree 3, backward", 14, -2, 0.75, {7, -33, 77, 77}, 128}};

std::string padded(const std::string& text, std::size_t width) {
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

void print_weights() {
    std::cout << "\nwindow               eq.   s     printed                  ours\n";
    for (const PrintedRow& row : printed) {
        std::vector<double> nodes;
        for (std::size_t i = 0; i < row.numerators.size(); ++i) {
            nodes.push_back(row.first + static_cast<double>(i));
        }
        const std::vector<double> weights = lagrange_weights(nodes, row.s);
        std::string theirs, ours;
        bool is_same = true;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            theirs += padded(std::to_string(row.numerators[i]), 5);
            ours += padded(format_number(weights[i] * row.denominator), 5);
            is_same = is_same && weights[i] * row.denominator == row.numerators[i];
        }
        const std::string over = " /" + padded(std::to_string(row.denominator), 4);
        std::cout << row.window << padded("(" + std::to_string(row.equation) + ")", 7) << "  "
                  << format_fixed(row.s, 2) << padded(theirs, row.s == 0.5 ? 21 : 20) << over
                  << padded(ours, 20) << over << (is_same ? "" : "  misprint") << '\n';
    }
}

std::string percent(double x) { return padded(format_fixed(x, 6), 12); }

void print_errors() {
    std::cout << "\nlargest error, %     degree 2    degree 3        arcs\n";
    for (const Example& example : examples) {
        for (const int n : {6, 4}) {
            std::cout << example.name << ", n = " << n << "        "
                      << percent(errors_of(example, lagrange_curve(example, n, 2)).largest)
                      << percent(errors_of(example, lagrange_curve(example, n, 3)).largest)
                      << percent(errors_of(example, arc_curve(example, n)).largest) << '\n';
        }
    }
    std::cout << "\nFigure 6, % of the chord       index  centripetal       chord\n";
    const auto row = [](const std::string& name, auto error) {
        std::cout << name << std::string(24 - name.size(), ' ');
        for (const LagrangeParameter parameter :
             {LagrangeParameter::index, LagrangeParameter::centripetal, LagrangeParameter::chord}) {
            std::cout << percent(error(parameter));
        }
        std::cout << '\n';
    };
    for (const Side side : {Side::upper, Side::lower}) {
        row(side == Side::upper ? "aerofoil, upper side" : "aerofoil, lower side",
            [&](LagrangeParameter parameter) { return aerofoil_error(side, parameter); });
    }
    for (const double psi : streams) {
        row("streamline at " + format_number(psi),
            [&](LagrangeParameter parameter) { return stream_error(psi, parameter); });
    }
}

void print_projection(const std::string& folder) {
    const Projection projection = project_screw();
    save(folder, "projection", projection.drawing);
    std::cout << "\nperspective, % of the extent\n  densified, then projected"
              << percent(projection.space_first)
              << "\n  projected, then densified" << percent(projection.picture_first)
              << "\nparallel projection: both ways are apart by "
              << format_number(projection.apart_in_parallel) << " %\n";
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<std::string> given = papers::folder_given(argc, argv);
    if (!given) return 2;
    const std::string& folder = *given;
    draw_parameter_figures(folder);
    draw_windows(folder);
    draw_aerofoil(folder);
    draw_error_figures(folder);
    draw_arc_step(folder);
    print_weights();
    print_errors();
    print_projection(folder);
}
