/// Draws the figures of Miura, Yoshida & Saito, "Discrete log-aesthetic filter", again:
/// `figures FOLDER`, and prints the numbers of its README.
///
/// Figure 1: alpha by the logarithmic curvature graph. Figure 2: the filter on a noisy quadratic.
/// Figure 3: on a spiral and on a cubic with an inflection, beside the default engine. Figure 4:
/// a Coons patch of two translated log-aesthetic edges, mirrored stripes from three sides.

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "../figures.hpp"
#include "batten/batten.hpp"

namespace {

using namespace batten;
using papers::save;

/// The Bezier curve of three or four control points.
Curve bezier(const std::vector<std::array<double, 2>>& c) {
    const double n = static_cast<double>(c.size() - 1);
    const auto& last = c[c.size() - 1];
    const auto& before = c[c.size() - 2];
    const Points ends({c[0][0], c[0][1], last[0], last[1]}, 2);
    const Points start({n * (c[1][0] - c[0][0]), n * (c[1][1] - c[0][1])}, 2);
    const Points end({n * (last[0] - before[0]), n * (last[1] - before[1])}, 2);
    return PiecewiseCubic::hermite(ends, start, end, {0, 1}, false);
}

/// Points at equal steps with uniform noise of so many shares of the length; the ends are clean.
Points noisy(const Curve& curve, std::size_t count, double share, unsigned seed) {
    std::mt19937 engine(seed);
    const double size = share * length(curve).value;
    const Interval domain = curve.domain();
    Points points(0, 2);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> p =
            curve(domain.lo + domain.length() * static_cast<double>(i) /
                                    static_cast<double>(count - 1));
        for (double& x : p) {
            const double step = size * (2 * static_cast<double>(engine()) / 4294967295.0 - 1);
            if (i > 0 && i + 1 < count) x += step;
        }
        points.push_back(p);
    }
    return points;
}

FairOptions filter(double alpha, int window) {
    FairOptions options;
    options.alpha.value = alpha;
    options.engine = FairEngine::filter;
    options.window = window;
    return options;
}

FairOptions engine(double alpha, double sigma) {
    FairOptions options;
    options.alpha.value = alpha;
    options.sigma = sigma;
    options.fix_ends = FixEnds::position;
    return options;
}

/// rho^alpha of the circles through three points against the chords' length.
Points radii(const Points& p, double alpha) {
    Points chart(0, 2);
    double s = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double ax = p(i, 0) - p(i - 1, 0), ay = p(i, 1) - p(i - 1, 1);
        const double bx = p(i + 1, 0) - p(i, 0), by = p(i + 1, 1) - p(i, 1);
        s += std::hypot(ax, ay);
        const double kappa = 2 * std::fabs(ax * by - ay * bx) /
                             (std::hypot(ax, ay) * std::hypot(bx, by) * std::hypot(ax + bx, ay + by));
        chart.push_back(std::array{s, std::pow(kappa, -alpha)});
    }
    return chart;
}

double distance(const Curve& truth, const Points& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double d = nearest(truth, points[i]).distance;
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(points.size()));
}

void figure_1(const std::string& folder) {
    const Curve quadratic = bezier({{0, 0}, {0.5, 0}, {1.2, 1.2}});
    const auto made = log_aesthetic({{0, 0, 0.5, 0, 1.2, 1.2}, 0.5});
    Drawing drawing;
    drawing.title = "Figure 1: alpha by the logarithmic curvature graph";
    drawing.columns = 3;
    drawing.panels[0].caption = "curves";
    drawing.add(CurveLayer{quadratic, "quadratic Bezier curve", {Tone::ink}});
    drawing.add(CurveLayer{*made.curve, "log-aesthetic, alpha 0.5", {Tone::accent}});
    drawing.panels.push_back(curvature_graph_plot(quadratic));
    drawing.panels.push_back(curvature_graph_plot(*made.curve));
    save(folder, "figure-1", drawing);
}

void figure_2(const std::string& folder) {
    const Curve curve = bezier({{0, 0}, {0.5, 0}, {1.2, 1.2}});
    const Points points = noisy(curve, 20, 0.005, 3);
    const Fairing made = fair(points, filter(0.5, 9));
    Drawing drawing;
    drawing.title = "Figure 2: a noisy quadratic Bezier curve, filtered";
    drawing.panels[0].caption = "20 points, 0.5 % noise";
    drawing.add(CurveLayer{curve, "Bezier curve", {Tone::grey, Dash::solid, 1}});
    drawing.add(PointsLayer{points, "noisy"});
    drawing.add(PointsLayer{made.points, "filtered", Marker::closed, {}, PointLabels::none,
                            Tone::accent});
    Panel chart;
    chart.kind = PanelKind::chart;
    chart.caption = "square root of the radius";
    chart.x_label = "arc length";
    chart.y_label = "root of rho";
    chart.y_range = Interval{0, 2.5};
    chart.add(PolylineLayer{{radii(points, 0.5)}, "noisy", {Tone::grey, Dash::solid, 1}});
    chart.add(PolylineLayer{{radii(made.points, 0.5)}, "filtered", {Tone::accent}});
    drawing.panels.push_back(chart);
    save(folder, "figure-2", drawing);
    std::cout << "  residual after 250 sweeps " << made.report.linearity_residual
              << ", distance over length " << distance(curve, made.points) / length(curve).value
              << " (noisy " << distance(curve, points) / length(curve).value << ")\n";
}

struct Case {
    std::string name;
    Curve curve;
    double alpha;
};

void figure_3(const std::string& folder) {
    const LogAestheticCurve spiral(std::vector<double>{0, 0}, 0, {1, 1, 10, 1 / 0.45});
    const Case cases[] = {{"logarithmic spiral", spiral, 1},
                          {"cubic with an inflection",
                           bezier({{0, 0}, {0.6, 0.9}, {0.7, -0.7}, {1.5, 0.2}}), -1}};
    Drawing drawing;
    drawing.title = "Figure 3: 60 points, 0.5 % noise";
    drawing.columns = 2;
    drawing.panels.clear();
    for (const Case& c : cases) {
        const double size = length(c.curve).value;
        const Points points = noisy(c.curve, 60, 0.005, 11);
        FairOptions split = filter(c.alpha, 9);
        split.split = true;
        const Points plain = fair(points, filter(c.alpha, 9)).points;
        const Points held = fair(points, split).points;
        const double sigma = 0.005 * size / std::sqrt(3.0);
        const Points best = fair(points, engine(c.alpha, sigma)).points;
        const Points linear = fair(points, engine(-1, sigma)).points;
        Panel panel;
        panel.caption = c.name;
        panel.add(CurveLayer{c.curve, "truth", {Tone::grey, Dash::solid, 3}});
        panel.add(PointsLayer{points, "noisy"});
        panel.add(PolylineLayer{{plain}, "the paper's filter", {Tone::ochre}});
        panel.add(PolylineLayer{{best}, "gauss-newton", {Tone::accent}});
        drawing.panels.push_back(panel);
        std::cout << "  " << c.name << ", distance over length: noisy "
                  << distance(c.curve, points) / size << ", filter "
                  << distance(c.curve, plain) / size << ", filter split "
                  << distance(c.curve, held) / size << ", gauss-newton "
                  << distance(c.curve, best) / size << ", linear curvature "
                  << distance(c.curve, linear) / size << '\n';
    }
    save(folder, "figure-3", drawing);
}

/// A plane curve put up in the plane y = 0 and moved.
Curve upright(const Curve& flat, std::array<double, 3> shift) {
    const auto function = [=](double t, int order, std::span<double> out) {
        const Jet jet = flat.jet(t, order);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(order); ++k) {
            const auto row = jet[static_cast<int>(k)];
            for (std::size_t i = 0; i < 3; ++i) {
                out[3 * k + i] = (i == 1 ? 0 : row[i / 2]) + (k == 0 ? shift[i] : 0);
            }
        }
    };
    return CallableCurve{function, 3, {flat.breaks().begin(), flat.breaks().end()}, false};
}

Curve straight(const Curve& from, const Curve& to, double share) {
    const auto p = from(share * from.domain().hi), q = to(share * to.domain().hi);
    const Points ends({p[0], p[1], p[2], q[0], q[1], q[2]}, 3);
    const Points along({q[0] - p[0], q[1] - p[1], q[2] - p[2]}, 3);
    return PiecewiseCubic::hermite(ends, along, along, {0, 1}, false);
}

/// Dark runs of the lines v = constant.
std::vector<Points> stripes(const CoonsPatch& patch, const ZebraView& view) {
    constexpr int lines = 90, steps = 400;
    std::vector<Points> runs;
    for (int j = 0; j <= lines; ++j) {
        bool is_dark_now = false;
        for (int i = 0; i <= steps; ++i) {
            const SurfaceJet jet = patch.jet(double(i) / steps, double(j) / lines);
            const auto angle = zebra_angle(jet, view);
            const bool dark = angle && is_dark(*angle, view.stripes);
            if (dark && !is_dark_now) runs.emplace_back(0, 3);
            if (is_dark_now && !dark) runs.back().push_back(jet.point);
            if (dark && (!is_dark_now || i % 20 == 0 || i == steps)) {
                runs.back().push_back(jet.point);
            }
            is_dark_now = dark;
        }
    }
    return runs;
}

void figure_4(const std::string& folder) {
    const double degree = std::acos(-1.0) / 180;
    const Curve flat = LogAestheticCurve(std::vector<double>{0, 0}, 0,
                                         *log_aesthetic_segment(0.5, 1, 55 * degree, 90 * degree));
    const Curve c0 = upright(flat, {0, 0, 0}), c1 = upright(flat, {0.2, 1, 0.3});
    const CoonsPatch patch(c0, c1, straight(c0, c1, 0), straight(c0, c1, 1));
    Drawing drawing;
    drawing.title = "Figure 4: stripes mirrored by a Coons patch, from three sides";
    drawing.columns = 3;
    drawing.panels.clear();
    const std::array<double, 3> eyes[] = {{0.5, -6, 4}, {6, -2, 3}, {-4, -3, 6}};
    for (const std::array<double, 3>& eye : eyes) {
        Panel panel;
        panel.axes = AxesStyle::hidden;
        panel.add(PolylineLayer{stripes(patch, {eye, {0, 0, 1}, 20}), {}, {Tone::ink, Dash::solid, 1.8}});
        panel.add(CurveLayer{c0, {}, {Tone::blue}});
        panel.add(CurveLayer{c1, {}, {Tone::blue}});
        drawing.panels.push_back(panel);
    }
    save(folder, "figure-4", drawing);
    const Interval range = gaussian_range(patch);
    std::cout << "  Gaussian curvature " << range.lo << " to " << range.hi << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    const std::optional<std::string> given = papers::folder_given(argc, argv);
    if (!given) return 2;
    figure_1(*given);
    figure_2(*given);
    figure_3(*given);
    figure_4(*given);
}
