/// Draws Figures 3.1-3.5 of Hatano's paper on fitting splines again and prints their statistics
/// beside the paper's: `surfaces CASES FOLDER`.
///
/// As there, level lines stand above views in space: of the data, of S at their nodes
/// (approximation 1), of S at places between (approximation 2); of residuals a coloured map. Only the set of
/// Figure 3.1 is near to the paper's; the others are made up, of the same sizes.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "batten/batten.hpp"
#include "surface_sets.hpp"

namespace {

using namespace batten;
using papers::SurfaceSet;

constexpr std::size_t relief_nodes = 25;
constexpr std::size_t fine_places = 101;

/// One column of a figure: its letter, what it shows, and ticks along the borders of its map.
struct Column {
    std::string caption;
    Heights heights;
    std::vector<double> levels;
    std::vector<double> x_ticks, y_ticks;
    double sigma = 0;  ///< of residuals, which are shown as a map of colours
};

/// Level lines from `lo` to `hi`, so many, as the paper chose them.
std::vector<double> levels_between(double lo, double hi, std::size_t count) {
    return even_places({lo, hi}, count);
}

PolylineLayer border_ticks(const Column& column) {
    constexpr double share = 0.02;
    const Interval x{column.heights.x.front(), column.heights.x.back()};
    const Interval y{column.heights.y.front(), column.heights.y.back()};
    PolylineLayer ticks{{}, {}, {Tone::ink, Dash::solid, 0.8}};
    const auto add = [&](double x0, double y0, double x1, double y1) {
        ticks.runs.emplace_back(std::vector<double>{x0, y0, x1, y1}, 2);
    };
    for (const double at : column.x_ticks) {
        add(at, y.lo, at, y.lo + share * y.length());
        add(at, y.hi, at, y.hi - share * y.length());
    }
    for (const double at : column.y_ticks) {
        add(x.lo, at, x.lo + share * x.length(), at);
        add(x.hi, at, x.hi - share * x.length(), at);
    }
    return ticks;
}

Heights scaled(Heights heights, double factor) {
    for (std::size_t i = 0; i < heights.x.size(); ++i) {
        for (std::size_t j = 0; j < heights.y.size(); ++j) heights.z(i, j) *= factor;
    }
    return heights;
}

Drawing drawn(const std::string& title, const SurfaceSet& set, const std::vector<Column>& columns) {
    Drawing drawing;
    drawing.title = title;
    drawing.subtitle = set.name;
    drawing.width = static_cast<int>(40 + 330 * columns.size());
    drawing.columns = static_cast<int>(columns.size());
    drawing.panels.clear();
    for (const Column& column : columns) {
        Panel map = column.sigma > 0
                        ? residual_map(scaled(column.heights, 1 / column.sigma), {}, column.caption)
                        : level_plot(column.heights, column.levels, column.caption);
        map.add(border_ticks(column));
        drawing.panels.push_back(std::move(map));
    }
    for (const Column& column : columns) {
        drawing.panels.push_back(relief_plot(column.heights, {{}, relief_nodes}, {}));
    }
    return drawing;
}

Column data_column(const SurfaceSet& set, const std::vector<double>& levels) {
    return {"a: data", set.heights, levels, set.heights.x, set.heights.y};
}

/// S at the nodes of the data.
Column at_nodes(const std::string& caption, const SurfaceSet& set, const SurfaceFit& fit,
                const std::vector<double>& levels) {
    const std::vector<double>&x = set.heights.x, &y = set.heights.y;
    return {caption, {x, y, fit.surface.evaluate(x, y)}, levels, fit.report.breaks_x,
            fit.report.breaks_y};
}

/// S evenly between.
Column between_nodes(const std::string& caption, const SurfaceFit& fit,
                     const std::vector<double>& levels) {
    return {caption, sampled(fit.surface, fine_places), levels, fit.report.breaks_x,
            fit.report.breaks_y};
}

Column residuals(const std::string& caption, const SurfaceSet& set, const SurfaceFit& fit) {
    Column column = at_nodes(caption, set, fit, {});
    column.sigma = set.sigma;
    for (std::size_t i = 0; i < set.heights.x.size(); ++i) {
        for (std::size_t j = 0; j < set.heights.y.size(); ++j) {
            column.heights.z(i, j) = set.heights.z(i, j) - column.heights.z(i, j);
        }
    }
    return column;
}

/// In many nodes some errors are beyond 4 sigma, as those of the paper's Figure 3.4c.
std::vector<double> distribution_for(const SurfaceSet& set) {
    constexpr std::size_t many = 5000;
    const std::size_t nodes = set.heights.x.size() * set.heights.y.size();
    return {0.68, 0.95, 0.99, nodes > many ? 0.999 : 1};
}

FitSurfaceOptions options_for(const SurfaceSet& set, SurfaceKnots knots) {
    FitSurfaceOptions options;
    options.knots = knots;
    options.sigma = set.sigma;
    options.stop = StopRule::distribution;
    options.distribution = distribution_for(set);
    return options;
}

SurfaceFit kprog_1(const SurfaceSet& set) {
    FitSurfaceOptions options = options_for(set, SurfaceKnots::equal);
    options.intervals = {12, 10};
    return fit_surface(set.view(), options);
}

SurfaceFit kprog_2(const SurfaceSet& set, StripRule rule, std::vector<double> intervals = {}) {
    FitSurfaceOptions options = options_for(set, SurfaceKnots::automatic);
    options.rule = rule;
    options.intervals = std::move(intervals);
    return fit_surface(set.view(), options);
}

/// KPROG 3: the lines of a fit moved to where delta2 is least.
SurfaceFit with_moved_lines(const SurfaceSet& set, const SurfaceFit& start) {
    FitSurfaceOptions options = options_for(set, SurfaceKnots::free);
    options.x_knots = start.report.breaks_x;
    options.y_knots = start.report.breaks_y;
    return fit_surface(set.view(), options);
}

bool passes(const SurfaceSet& set, const FitSurfaceReport& report) {
    const std::vector<double> wanted = distribution_for(set);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (report.psi[i] < wanted[i]) return false;
    }
    return true;
}

/// Lines moved from the latest steps of KPROG 2 on that, moved, pass its test.
SurfaceFit kprog_3(const SurfaceSet& set, const SurfaceFit& second, StripRule rule) {
    constexpr std::size_t steps_back = 6;
    const std::vector<SurfaceStep>& path = second.report.path;
    const std::size_t last = path.size() - 1;
    for (std::size_t k = last - std::min(last, steps_back); k < last; ++k) {
        const auto [m, n] = path[k].intervals;
        const SurfaceFit start =
            kprog_2(set, rule, {static_cast<double>(m), static_cast<double>(n)});
        SurfaceFit moved = with_moved_lines(set, start);
        if (passes(set, moved.report)) return moved;
    }
    return with_moved_lines(set, second);
}

struct Printed {
    const char* figure;
    int program;
    int m, n;
    double delta2, sigma2, aic;
};

std::string cell(double value, int decimals) {
    const std::string text = format_fixed(value, decimals);
    return std::string(text.size() < 9 ? 9 - text.size() : 0, ' ') + text;
}

std::string strips(int m, int n) {
    const std::string text = std::to_string(m) + "*" + std::to_string(n);
    return std::string(8 - text.size(), ' ') + text;
}

void print_row(const Printed& paper, const FitSurfaceReport& ours) {
    std::cout << paper.figure << "   " << paper.program << strips(paper.m, paper.n)
              << strips(ours.intervals[0], ours.intervals[1]) << "  " << cell(paper.delta2, 1)
              << cell(ours.delta2, 1) << "  " << cell(paper.sigma2, 4)
              << cell(ours.sigma2.value_or(0), 4) << "  " << cell(paper.aic, 0)
              << cell(ours.aic, 0) << '\n';
}

class Figures {
public:
    explicit Figures(std::string folder) : folder_(std::move(folder)) {}

    void equal(const SurfaceSet& set) const {
        const std::vector<double> levels = levels_between(-10, 130, 15);
        const SurfaceFit first = kprog_1(set), second = kprog_2(set, StripRule::marginal);
        const SurfaceFit third = kprog_3(set, second, StripRule::marginal);
        write("3.1", set, {data_column(set, levels), at_nodes("b: KPROG 1", set, first, levels),
                           at_nodes("c: KPROG 2", set, second, levels),
                           at_nodes("d: KPROG 3", set, third, levels)});
        print_row({"3.1b", 1, 12, 10, 5231.1, 1.7939, 27027}, first.report);
        print_row({"3.1c", 2, 10, 10, 3109.3, 1.0569, 25357}, second.report);
        print_row({"3.1d", 3, 11, 10, 3042.3, 1.0387, 25315}, third.report);
    }

    void unequal(const SurfaceSet& set) const {
        const std::vector<double> levels = levels_between(-10, 130, 15);
        const SurfaceFit first = kprog_1(set), second = kprog_2(set, StripRule::marginal);
        const SurfaceFit third = kprog_3(set, second, StripRule::marginal);
        write("3.2a-d", set, {data_column(set, levels), at_nodes("b: KPROG 1", set, first, levels),
                              at_nodes("c: KPROG 2", set, second, levels),
                              at_nodes("d: KPROG 3", set, third, levels)});
        write("3.2e-g", set, {between_nodes("e: KPROG 1, between the nodes", first, levels),
                              between_nodes("f: KPROG 2, between the nodes", second, levels),
                              between_nodes("g: KPROG 3, between the nodes", third, levels)});
        print_row({"3.2e", 1, 12, 10, 4005.3, 1.3735, 26197}, first.report);
        print_row({"3.2f", 2, 11, 9, 2992.8, 1.0169, 25236}, second.report);
        print_row({"3.2g", 3, 11, 8, 3018.8, 1.0209, 25235}, third.report);
    }

    void chest(const SurfaceSet& set) const {
        const std::vector<double> levels = levels_between(40, 340, 16);
        const SurfaceFit second = kprog_2(set, StripRule::projected);
        const SurfaceFit third = kprog_3(set, second, StripRule::projected);
        write("3.3", set, {data_column(set, levels), at_nodes("b: KPROG 2", set, second, levels),
                           at_nodes("c: KPROG 3", set, third, levels),
                           between_nodes("d: KPROG 3, between the nodes", third, levels)});
        print_row({"3.3b", 2, 24, 33, 16610, 1.0601, 163640}, second.report);
        print_row({"3.3c", 3, 23, 33, 16838, 1.0722, 163800}, third.report);
    }

    void terrain(const SurfaceSet& set) const {
        const std::vector<double> levels = levels_between(5, 60, 12);
        const SurfaceFit second = kprog_2(set, StripRule::projected);
        const SurfaceFit third = kprog_3(set, second, StripRule::projected);
        write("3.4", set, {data_column(set, levels), at_nodes("b: KPROG 2", set, second, levels),
                           residuals("c: KPROG 2, residuals", set, second),
                           at_nodes("d: KPROG 3", set, third, levels)});
        print_row({"3.4b", 2, 18, 16, 10545, 1.0870, 94358}, second.report);
        print_row({"3.4d", 3, 20, 17, 7497.2, 0.77772, 91035}, third.report);
    }

    /// The paper stopped at 99 * 16 strips, and so do we.
    void scintillator(const SurfaceSet& set) const {
        const std::vector<double> levels = levels_between(0, 1.5, 16);
        const SurfaceFit second = kprog_2(set, StripRule::projected, {99, 16});
        const SurfaceFit third = with_moved_lines(set, second);
        write("3.5a-d", set, {data_column(set, levels), at_nodes("b: KPROG 2", set, second, levels),
                              residuals("c: KPROG 2, residuals", set, second),
                              between_nodes("d: KPROG 2, between the nodes", second, levels)});
        write("3.5e-g", set, {at_nodes("e: KPROG 3", set, third, levels),
                              residuals("f: KPROG 3, residuals", set, third),
                              between_nodes("g: KPROG 3, between the nodes", third, levels)});
        print_row({"3.5b", 2, 99, 16, 4874.6, 3.6432, 31695}, second.report);
        print_row({"3.5e", 3, 99, 16, 1204.3, 0.90011, 27115}, third.report);
        curved(set, levels);
    }

private:
    /// What the paper wished for: knot lines along the front.
    void curved(const SurfaceSet& set, const std::vector<double>& levels) const {
        FitFrontOptions options;
        options.sigma = set.sigma;
        const FrontFit fit = fit_front(set.view(), options);
        const Heights fine = sampled(fit.surface, fine_places);
        Drawing drawing;
        drawing.title = "Figure 3.5 with curved knot lines: σ² = " +
                        format_fixed(*fit.report.sigma2, 3) + ", " +
                        std::to_string(fit.report.parameters) + " coefficients";
        drawing.subtitle = set.name;
        drawing.width = 700;
        drawing.panels = {level_plot(fine, levels, "between the nodes"),
                          relief_plot(fit.surface, {}, "the surface")};
        for (const PolylineLayer& lines : knot_lines(fit.surface)) drawing.panels[0].add(lines);
        write_file(folder_ + "/figure-3.5-curved.svg", svg(drawing));
        std::cout << "3.5 with curved lines: " << fit.report.parameters << " + "
                  << fit.report.parameters_charged - fit.report.parameters << " parameters, δ² = "
                  << format_fixed(fit.report.delta2, 1) << ", σ² = "
                  << format_fixed(*fit.report.sigma2, 4) << '\n';
    }

    void write(const std::string& number, const SurfaceSet& set,
               const std::vector<Column>& columns) const {
        write_file(folder_ + "/figure-" + number + ".svg",
                   svg(drawn("Figure " + number, set, columns)));
    }

    std::string folder_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: surfaces CASES FOLDER\n";
        return 2;
    }
    const Figures figures(argv[2]);
    std::cout << "fig KPROG  m*n: paper    ours  δ²: paper     ours   σ²: paper     ours  "
                 "AIC: paper     ours\n";
    figures.equal(papers::equal_set(argv[1]));
    figures.unequal(papers::unequal_set());
    figures.chest(papers::chest_set());
    figures.terrain(papers::terrain_set());
    figures.scintillator(papers::scintillator_set());
}
