/// Draws the figures of Harada & Nakamae, "On an algorithm for locating sample points on cubic
/// spline interpolants", again: `figures FOLDER`.
///
/// Figure 3 gives no coordinates: a lemniscate of half width 100 stands for it, points every 20
/// degrees, as its description fits. Figure 1: K along that curve. Figures 4-6: equal steps, equal
/// shares of K, steps by a cosine; by the paper's method and exactly. Table 1: the number of terms.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "../figures.hpp"
#include "batten/batten.hpp"

namespace {

using namespace batten;
using papers::save;

const Points figure_8({0,     0,     18.2,  -17.1, 40.5,  -31,   69.3,  -34.6, 95.6, -16.6,
                       95.6,  16.6,  69.3,  34.6,  40.5,  31,    18.2,  17.1,  0,    0,
                       -18.2, -17.1, -40.5, -31,   -69.3, -34.6, -95.6, -16.6, -95.6, 16.6,
                       -69.3, 34.6,  -40.5, 31,    -18.2, 17.1,  0,     0},
                      2);

/// K = |d2r/dt2| against the arc length.
Drawing figure_1(const Curve& curve) {
    Drawing drawing;
    drawing.title = "Figure 1: K along the spline";
    drawing.subtitle =
        "K, the size of the second derivative by the chord parameter; the curvature is close";
    Panel& chart = drawing.panels.front();
    chart.kind = PanelKind::chart;
    chart.x_label = "arc length";
    chart.y_label = "K";
    const ArcLengthMap map(curve);
    Points proxy(0, 2), curvature_line(0, 2);
    for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
        const Interval part = curve.piece(piece);
        for (int i = piece == 0 ? 0 : 1; i <= 24; ++i) {
            const double t = part.lo + part.length() * i / 24;
            const Jet jet = curve.jet_on(piece, t, 2);
            const double s = map.s_of(std::min(t, part.hi));
            proxy.push_back(std::array{s, std::hypot(jet[2][0], jet[2][1])});
            curvature_line.push_back(std::array{s, std::fabs(curvature(jet).value_or(0))});
        }
    }
    chart.add(PolylineLayer{{proxy}, "K", {Tone::ink}});
    chart.add(PolylineLayer{{curvature_line}, "curvature", {Tone::accent, Dash::dashed}});
    return drawing;
}

Drawing figure_3(const Curve& curve) {
    Drawing drawing;
    drawing.title = "Figure 3: a spline through 19 points";
    drawing.width = 640;
    drawing.add(CurveLayer{curve, {}, {Tone::ink}});
    drawing.add(PointsLayer{figure_8, {}});
    return drawing;
}

struct Example {
    const char* name;
    const char* title;
    SampleOptions options;
};

std::vector<Example> examples() {
    SampleOptions even, bends, cosine;
    even.count = bends.count = 41;
    bends.law = Law::curvature_proxy;
    cosine.law = Law::relative;
    std::vector<double> steps;
    for (int i = 1; i <= 42; ++i) steps.push_back(std::fabs(std::cos(std::numbers::pi * i / 21)));
    cosine.weights = Points(steps, 1);
    return {{"figure-04", "Figure 4: 41 equal steps", even},
            {"figure-05", "Figure 5: 41 points, equal shares of K", bends},
            {"figure-06", "Figure 6: 43 points, steps as |cos(i pi / 21)|", cosine}};
}

Points places(const Sampling& made) {
    Points points(made.rows.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points(i, 0) = made.rows(i, 4);
        points(i, 1) = made.rows(i, 5);
    }
    return points;
}

std::vector<double> parameters(const Sampling& made) {
    std::vector<double> t;
    for (std::size_t i = 0; i < made.rows.size(); ++i) t.push_back(made.rows(i, 3));
    return t;
}

Drawing figure(const Example& example, const Curve& curve, const Sampling& exact,
               const Sampling& paper) {
    Drawing drawing;
    drawing.title = example.title;
    drawing.columns = 1;
    drawing.width = 640;
    Panel& by_paper = drawing.panels.front();
    by_paper.caption = "by the paper's method (dots) and exactly (ticks)";
    by_paper.add(CurveLayer{curve, {}, {Tone::grey}});
    by_paper.add(TicksLayer{curve, parameters(exact), "exact", Tone::blue});
    by_paper.add(PointsLayer{places(paper), "paper's method", Marker::closed, {},
                             PointLabels::none, Tone::accent});
    Panel chart;
    chart.kind = PanelKind::chart;
    chart.caption = "how far the paper's points are from their places";
    chart.x_label = "arc length";
    chart.y_label = "error";
    Points errors(0, 2);
    for (std::size_t i = 0; i < exact.rows.size(); ++i) {
        errors.push_back(std::array{exact.rows(i, 2), paper.rows(i, 2) - exact.rows(i, 2)});
    }
    chart.add(PolylineLayer{{errors}, {}, {Tone::accent}});
    drawing.panels.push_back(chart);
    return drawing;
}

std::string padded(double x, int decimals, std::size_t width) {
    const std::string text = format_fixed(x, decimals);
    return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

/// The least and the largest step over what it should be, and the middle point's error.
void print_example(const Example& example, const Sampling& exact, const Sampling& paper) {
    double least = 1e300, most = 0;
    for (std::size_t i = 1; i < exact.rows.size(); ++i) {
        const double wanted = exact.rows(i, 2) - exact.rows(i - 1, 2);
        const double ratio = (paper.rows(i, 2) - paper.rows(i - 1, 2)) / wanted;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    const std::size_t middle = (exact.rows.size() - 1) / 2;
    std::cout << example.name << padded(*paper.report.overrun, 3, 10)
              << padded(*paper.report.correction, 6, 12)
              << padded(*paper.report.max_position_error, 3, 10) << padded(least, 3, 8)
              << padded(most, 3, 8)
              << padded(std::fabs(paper.rows(middle, 2) - exact.rows(middle, 2)), 3, 9) << '\n';
}

void print_convergence() {
    std::cout << "\npoints   largest error / L   / step   steps too steep\n";
    for (const int count : {21, 41, 81, 161, 321, 641, 1281}) {
        SampleOptions options;
        options.method = SampleMethod::harada_nakamae;
        options.count = count;
        const SampleReport report = sample_harada_nakamae(figure_8, options).report;
        const double share = *report.max_position_error / report.length;
        std::cout << padded(count, 0, 6) << padded(100 * share, 5, 18) << " %"
                  << padded(share * (count - 1), 3, 9) << padded(*report.steep_steps, 0, 12)
                  << '\n';
    }
}

void print_table_1() {
    std::map<char, int> counts;
    for (const ImplicitTerm& term : implicit_terms()) ++counts[term.coefficient];
    std::cout << "\nTable 1: ";
    for (const auto& [name, count] : counts) std::cout << name << ' ' << count << "  ";
    std::cout << "in all " << implicit_terms().size() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<std::string> given = papers::folder_given(argc, argv);
    if (!given) return 2;
    const std::string& folder = *given;
    const Curve curve = harada_nakamae_curve(figure_8);
    save(folder, "figure-01", figure_1(curve));
    save(folder, "figure-03", figure_3(curve));
    std::cout << "length " << format_number(length(curve).value) << "\n\n"
              << "           overrun  correction     error   least    most   middle\n";
    for (const Example& example : examples()) {
        SampleOptions stepped = example.options;
        stepped.method = SampleMethod::harada_nakamae;
        const Sampling exact = sample(curve, example.options);
        const Sampling paper = sample_harada_nakamae(figure_8, stepped);
        print_example(example, exact, paper);
        write_file(folder + "/" + example.name + ".svg",
                   svg(figure(example, curve, exact, paper)));
    }
    print_convergence();
    print_table_1();
}
