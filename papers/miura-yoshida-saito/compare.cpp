/// Compares the filter of Miura, Yoshida & Saito with what it is measured against in the paper, and
/// shows its sections 4 and 5: `compare FOLDER` draws figures 5 to 7 and prints the README's tables.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "batten/batten.hpp"
#include "elastica.hpp"
#include "make/fair/smooth.hpp"

namespace {

using namespace batten;

constexpr double pi = 3.141592653589793;

void save(const std::string& folder, const std::string& name, const Drawing& drawing) {
    write_file(folder + "/" + name + ".svg", svg(drawing));
    std::cout << name << ".svg\n";
}

/// Normal noise of the standard library's generator, but of our own making: the library's
/// distributions differ between systems.
class Noise {
public:
    explicit Noise(unsigned seed) : engine_(seed) {}
    double operator()() {
        double sum = -6;
        for (int k = 0; k < 12; ++k) sum += static_cast<double>(engine_()) / 4294967295.0;
        return sum;
    }

private:
    std::mt19937 engine_;
};

Points points_on(const Curve& curve, std::size_t count) {
    Points points(0, curve.dim());
    const Interval domain = curve.domain();
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(curve(domain.lo + domain.length() * double(i) / double(count - 1)));
    }
    return points;
}

Points with_noise(Points points, double sigma, unsigned seed) {
    Noise noise(seed);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        for (int k = 0; k < points.dim(); ++k) points(i, k) += sigma * noise();
    }
    return points;
}

double distance(const Curve& truth, const Points& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        sum += std::pow(nearest(truth, points[i]).distance, 2);
    }
    return std::sqrt(sum / double(points.size()));
}

/// Curvature of the circles through three points against the chords' length.
Points curvatures(const Points& p) {
    Points chart(0, 2);
    double s = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        const double ax = p(i, 0) - p(i - 1, 0), ay = p(i, 1) - p(i - 1, 1);
        const double bx = p(i + 1, 0) - p(i, 0), by = p(i + 1, 1) - p(i, 1);
        s += std::hypot(ax, ay);
        chart.push_back(std::array{s, 2 * (ax * by - ay * bx) /
                                          (std::hypot(ax, ay) * std::hypot(bx, by) *
                                           std::hypot(ax + bx, ay + by))});
    }
    return chart;
}

/// The rms change of curvature from point to point: what a reflection shows.
double roughness(const Points& p) {
    const Points k = curvatures(p);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < k.size(); ++i) sum += std::pow(k(i + 1, 1) - k(i, 1), 2);
    return std::sqrt(sum / double(k.size() - 1));
}

/// Fourth differences of each coordinate, weighed by cross-validation [CravenWahba1979].
Points by_fourth_differences(const Points& points) {
    fairing::Track data{{}, {}, false};
    for (std::size_t i = 0; i < points.size(); ++i) {
        data.x.push_back(points(i, 0));
        data.y.push_back(points(i, 1));
    }
    const auto smooth = fairing::smoothed(data, fairing::cross_validated(data, 1), 1);
    Points result(0, 2);
    for (std::size_t i = 0; i < smooth.size(); ++i) {
        result.push_back(std::array{smooth.x[i], smooth.y[i]});
    }
    return result;
}

Points by_filter(const Points& points, double alpha) {
    FairOptions options;
    options.alpha.value = alpha;
    options.engine = FairEngine::filter;
    return fair(points, options).points;
}

Points by_gauss_newton(const Points& points, double alpha, double sigma) {
    FairOptions options;
    options.alpha.value = alpha;
    options.sigma = sigma;
    options.fix_ends = FixEnds::position;
    return fair(points, options).points;
}

struct Case {
    std::string name;
    Curve curve;
    double alpha;
};

Curve cubic() {
    const Points ends({0, 0, 1.5, 0.2}, 2), start({1.8, 2.7}, 2), end({2.4, 2.7}, 2);
    return PiecewiseCubic::hermite(ends, start, end, {0, 1}, false);
}

void figure_5(const std::string& folder) {
    const Case cases[] = {
        {"logarithmic spiral", LogAestheticCurve(std::vector<double>{0, 0}, 0, {1, 1, 10, 1 / 0.45}), 1},
        {"cubic with an inflection", cubic(), 0.5}};
    Drawing drawing;
    drawing.title = "Figure 5: the same 60 points, 0.3 % noise, made fair in five ways";
    drawing.columns = 2;
    drawing.panels.clear();
    for (const Case& c : cases) {
        const double size = length(c.curve).value, sigma = 0.003 * size;
        const Points points = with_noise(points_on(c.curve, 60), sigma, 11);
        const Points elastica = papers::elastica(c.curve, 60);
        const Points differences = by_fourth_differences(points);
        const Points filter = by_filter(points, c.alpha);
        const Points linear = by_gauss_newton(points, -1, sigma);
        const Points ours = by_gauss_newton(points, c.alpha, sigma);
        Panel panel;
        panel.caption = c.name;
        panel.add(PointsLayer{points, "noisy"});
        panel.add(PolylineLayer{{elastica}, "elastica", {Tone::violet}});
        panel.add(PolylineLayer{{filter}, "the paper's filter", {Tone::ochre}});
        panel.add(PolylineLayer{{ours}, "gauss-newton", {Tone::accent}});
        drawing.panels.push_back(panel);
        Panel chart;
        chart.kind = PanelKind::chart;
        chart.caption = "curvature";
        chart.x_label = "arc length";
        chart.y_label = "curvature";
        chart.y_range = c.alpha == 1 ? Interval{0, 12} : Interval{-6, 6};
        chart.add(PolylineLayer{{curvatures(points_on(c.curve, 60))}, "truth", {Tone::grey, Dash::solid, 3}});
        chart.add(PolylineLayer{{curvatures(differences)}, "fourth differences", {Tone::teal}});
        chart.add(PolylineLayer{{curvatures(elastica)}, "elastica", {Tone::violet}});
        chart.add(PolylineLayer{{curvatures(filter)}, "the paper's filter", {Tone::ochre}});
        chart.add(PolylineLayer{{curvatures(ours)}, "gauss-newton", {Tone::accent}});
        drawing.panels.push_back(chart);
        std::cout << "  " << c.name << ": distance over length, roughness of curvature\n";
        const std::pair<const char*, const Points*> rows[] = {
            {"noisy points", &points},  {"fourth differences", &differences},
            {"elastica", &elastica},    {"the paper's filter", &filter},
            {"linear curvature", &linear}, {"the paper's alpha", &ours}};
        for (const auto& [name, result] : rows) {
            std::cout << "    " << name << ' ' << distance(c.curve, *result) / size << ' '
                      << roughness(*result) << '\n';
        }
    }
    save(folder, "figure-5", drawing);
}

/// Length of a step between two rows.
double step(const Points& p, std::size_t i) {
    return std::hypot(p(i + 1, 0) - p(i, 0), p(i + 1, 1) - p(i, 1), p(i + 1, 2) - p(i, 2));
}

/// Curvature (by Heron's formula) and torsion (by the volume of four points) against arc length.
std::array<Points, 2> bends_in_space(const Points& p) {
    std::array<Points, 2> charts{Points(0, 2), Points(0, 2)};
    double s = 0;
    const auto difference = [&](std::size_t i) {
        return std::array{p(i + 1, 0) - p(i, 0), p(i + 1, 1) - p(i, 1), p(i + 1, 2) - p(i, 2)};
    };
    const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return std::array{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]};
    };
    const auto dot = [](const std::array<double, 3>& a, const std::array<double, 3>& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    for (std::size_t i = 1; i + 2 < p.size(); ++i) {
        s += step(p, i - 1);
        const auto a = difference(i - 1), b = difference(i), c = difference(i + 1);
        const auto m = cross(a, b), n = cross(b, c);
        const double mm = std::sqrt(dot(m, m)), nn = std::sqrt(dot(n, n)), bb = std::sqrt(dot(b, b));
        const std::array<double, 3> chord{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
        charts[0].push_back(std::array{
            s, 2 * mm / (std::sqrt(dot(a, a)) * bb * std::sqrt(dot(chord, chord)))});
        charts[1].push_back(std::array{
            s + bb / 2, 3 * dot(cross(m, n), b) /
                            (mm * nn * bb * (std::sqrt(dot(a, a)) + bb + std::sqrt(dot(c, c))))});
    }
    return charts;
}

void figure_6(const std::string& folder) {
    const RadiusLaw bend{1, 0.8, 0.6}, twist{1, 0.5, 0.7};
    const Curve curve = LogAestheticSpaceCurve(bend, twist, 2);
    const Points points = with_noise(points_on(curve, 40), 1e-3, 2);
    FairOptions options;
    options.alpha.value = 1;
    options.beta = 1;
    options.sigma = 1e-3;
    const Points made = fair(points, options).points;
    const auto exact = bends_in_space(points_on(curve, 40)), noisy = bends_in_space(points),
               ours = bends_in_space(made);
    Drawing drawing;
    drawing.title = "Figure 6: a log-aesthetic curve in space, 40 points, noise 0.05 % of its length";
    drawing.columns = 3;
    drawing.panels.front().add(PointsLayer{points, "noisy"});
    drawing.panels.front().add(PolylineLayer{{made}, "gauss-newton", {Tone::accent}});
    const char* const names[] = {"curvature", "torsion"};
    for (std::size_t k = 0; k < 2; ++k) {
        Panel chart;
        chart.kind = PanelKind::chart;
        chart.caption = names[k];
        chart.x_label = "arc length";
        chart.y_label = names[k];
        chart.y_range = Interval{0, k == 0 ? 2.5 : 3.0};
        chart.add(PolylineLayer{{noisy[k]}, "noisy", {Tone::grey, Dash::solid, 0.7}});
        chart.add(PolylineLayer{{exact[k]}, "truth", {Tone::grey, Dash::solid, 3}});
        chart.add(PolylineLayer{{ours[k]}, "gauss-newton", {Tone::accent}});
        drawing.panels.push_back(chart);
        double sum = 0, size = 0;
        for (std::size_t i = 0; i < ours[k].size(); ++i) {
            sum += std::pow(ours[k](i, 1) - exact[k](i, 1), 2);
            size += std::pow(exact[k](i, 1), 2);
        }
        std::cout << "  error of " << names[k] << ' ' << std::sqrt(sum / size) << '\n';
    }
    save(folder, "figure-6", drawing);
}

using Place = std::array<double, 3>;
using SurfaceFunction = std::function<Place(double, double)>;

constexpr std::size_t lines = 33;

Grid grid_of(const SurfaceFunction& surface) {
    Grid grid(lines, lines, 3);
    for (std::size_t i = 0; i < lines; ++i) {
        for (std::size_t j = 0; j < lines; ++j) {
            const Place p = surface(0.0375 * (double(i) - 16), 0.0375 * (double(j) - 16));
            for (int k = 0; k < 3; ++k) grid(i, j, k) = p[std::size_t(k)];
        }
    }
    return grid;
}

/// The surface of revolution of constant Gaussian curvature 1 whose waist has the radius 0.6.
Place barrel(double u, double v) {
    constexpr int parts = 400;
    double height = 0;
    for (int k = 0; k < parts; ++k) {
        height += std::sqrt(1 - 0.36 * std::pow(std::sin(v * (k + 0.5) / parts), 2)) * v / parts;
    }
    return {0.6 * std::cos(v) * std::cos(u), 0.6 * std::cos(v) * std::sin(u), height};
}

std::vector<std::pair<std::string, SurfaceFunction>> surfaces() {
    return {
        {"sphere",
         [](double u, double v) {
             return Place{std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v)};
         }},
        {"cylinder", [](double u, double v) { return Place{std::sin(u), v, std::cos(u)}; }},
        {"ruled Coons patch",
         [](double u, double v) {
             return Place{u + 0.3 * v, v, 0.5 * u * u + 0.1 * u * u * u + 0.2 * v};
         }},
        {"cone",
         [](double u, double v) {
             return Place{(v + 1.2) * std::cos(u), (v + 1.2) * std::sin(u), v + 1.2};
         }},
        {"tangent developable",
         [](double u, double v) {
             const double t = v + 1.2;
             return Place{std::cos(u) - t * std::sin(u), std::sin(u) + t * std::cos(u),
                          0.5 * (u + t)};
         }},
        {"barrel", barrel},
        {"pseudosphere",
         [](double u, double v) {
             const double t = v + 1.2;
             return Place{std::cos(u) / std::cosh(t), std::sin(u) / std::cosh(t), t - std::tanh(t)};
         }},
    };
}

std::string outcome_of(const SurfaceFairing& made) {
    if (made.report.status == Status::met) return "rests";
    return made.report.notes.empty() ? "moves on" : made.report.notes.front();
}

void drift() {
    std::cout << "  100 sweeps of the paper's step on exact points: largest displacement\n";
    for (const auto& [name, surface] : surfaces()) {
        const Grid exact = grid_of(surface);
        FairSurfaceOptions options;
        options.engine = SurfaceEngine::filter;
        const SurfaceFairing nearest_root = fair_surface(exact, options);
        options.root = FilterRoot::paper;
        const SurfaceFairing paper_root = fair_surface(exact, options);
        const SurfaceFairing ours = fair_surface(exact, {});
        std::cout << "    " << name << ": nearest root " << nearest_root.report.max_displacement
                  << " (" << outcome_of(nearest_root) << "), the paper's "
                  << paper_root.report.max_displacement << " (" << outcome_of(paper_root)
                  << "), gauss-newton " << ours.report.max_displacement << '\n';
    }
}

std::vector<Points> curvatures_along(const Grid& grid) {
    std::vector<Points> runs;
    for (std::size_t j = 2; j + 2 < grid.nv(); j += 2) {
        runs.emplace_back(0, 2);
        for (std::size_t i = 1; i + 1 < grid.nu(); ++i) {
            runs.back().push_back(std::array{double(i), gaussian_curvature(grid, i, j)});
        }
    }
    return runs;
}

void figure_7(const std::string& folder) {
    Drawing drawing;
    drawing.title = "Figure 7: Gaussian curvature of noisy grids of points (0.0005 at 0.0375), faired";
    drawing.columns = 3;
    drawing.panels.clear();
    for (const auto& [name, surface] : surfaces()) {
        Grid noisy = grid_of(surface);
        Noise noise(1);
        for (std::size_t i = 1; i + 1 < lines; ++i) {
            for (std::size_t j = 1; j + 1 < lines; ++j) {
                for (int k = 0; k < 3; ++k) noisy(i, j, k) += 5e-4 * noise();
            }
        }
        FairSurfaceOptions plain;
        plain.weight_curvature = 0;
        Panel chart;
        chart.kind = PanelKind::chart;
        chart.caption = name;
        chart.x_label = "line u";
        chart.y_label = "Gaussian curvature";
        const double middle = gaussian_curvature(grid_of(surface), 16, 16);
        chart.y_range = Interval{middle - 0.05, middle + 0.05};
        chart.add(PolylineLayer{curvatures_along(fair_surface(noisy, plain).grid),
                                "fourth differences", {Tone::teal, Dash::solid, 0.6}});
        chart.add(PolylineLayer{curvatures_along(fair_surface(noisy, {}).grid), "gauss-newton",
                                {Tone::accent, Dash::solid, 0.8}});
        drawing.panels.push_back(chart);
    }
    save(folder, "figure-7", drawing);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: compare FOLDER\n";
        return 2;
    }
    figure_5(argv[1]);
    figure_6(argv[1]);
    drift();
    figure_7(argv[1]);
}
