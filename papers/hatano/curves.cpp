/// Draws Figures 2.1-2.12 of Hatano's paper on fitting splines again and prints their statistics
/// beside the paper's: `curves CASES FOLDER`.
///
/// Figures 2.1-2.3 use the shipped data of 201 equally spaced points, 2.4-2.6 data made the same way
/// at abscissae at random, 2.7 and 2.8 the titanium data; the spectra of 2.9-2.12 are not printed
/// in the paper, so spectra of as many points are made up.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "api/knot_marks.hpp"
#include "batten/batten.hpp"
#include "noise.hpp"

namespace {

using namespace batten;
using papers::Noise;

struct Data {
    std::string name;
    std::vector<double> x, f, sigma;

    FitSamples view() const { return {x, f, sigma}; }
};

struct Peak {
    double height, center, width;
};

double peaks_at(const std::vector<Peak>& peaks, double x) {
    double sum = 0;
    for (const Peak& p : peaks) {
        const double e = (x - p.center) / p.width;
        sum += p.height * std::exp(-0.5 * e * e);
    }
    return sum;
}

/// The truth behind Figures 2.1-2.6 as rebuilt from them: a polynomial of degree 4 and five peaks.
double truth(double x) {
    const double u = (x - 50) / 50;
    double sum = 0;
    for (const double p : {17.74, 6.67, 18.96, 19.91, 70.87}) sum = sum * u + p;
    return sum + peaks_at({{-27.65, 31.19, 3.73},
                           {32.49, 34.43, 8.59},
                           {25.37, 50.14, 2.31},
                           {-88.41, 65.22, 4.51},
                           {73.18, 74.42, 4.75}},
                          x);
}

Data table_data(const std::string& name, const std::string& path) {
    const Table table = read_table(path);
    return {name, column_values(table, 0), column_values(table, 1), column_values(table, 2)};
}

Data unequal_data() {
    Data data{"unequal", {}, {}, {}};
    Noise noise(3);
    for (int i = 0; i < 201; ++i) data.x.push_back(100 * noise.uniform());
    data.x[0] = 0;
    data.x[200] = 100;
    std::sort(data.x.begin(), data.x.end());
    for (const double x : data.x) {
        data.f.push_back(std::round(10 * (truth(x) + 1.5 * noise.normal())) / 10);
        data.sigma.push_back(1.5);
    }
    return data;
}

/// Counts of a spectrum with errors of Poisson's kind, sigma^2 = 1e-4 f + 1e-6.
Data spectrum(const std::string& name, int count, const std::function<double(double)>& counts,
              std::uint64_t seed) {
    Data data{name, {}, {}, {}};
    Noise noise(seed);
    for (int i = 0; i < count; ++i) {
        const double f = counts(i);
        const double sigma = std::sqrt(1e-4 * f + 1e-6);
        data.x.push_back(i);
        data.f.push_back(f + sigma * noise.normal());
        data.sigma.push_back(sigma);
    }
    return data;
}

double strong_lines(double x) {
    return 0.02 + 0.5 * std::exp(-x / 60) +
           peaks_at({{3.2, 62, 4.5}, {1.1, 84, 5}, {0.5, 120, 7}, {1.7, 151, 4}}, x);
}

double weak_lines(double x) {
    return 0.002 + peaks_at({{0.17, 80, 16}, {0.05, 128, 14}, {0.03, 190, 22}}, x);
}

struct Printed {
    int intervals;
    double delta2, sigma2, aic;
};

struct Figure {
    int number;
    int program;  ///< KPROG
    int data;
    FitOptions options;
    Printed printed;
};

FitOptions equal_knots() {
    FitOptions options;
    options.knots = KnotPlacement::equal;
    options.intervals = 10;
    return options;
}

FitOptions inserted() {
    FitOptions options;
    options.stop = StopRule::distribution;
    options.distribution = {0.68, 0.95, 0.99};
    return options;
}

FitOptions moved(double free_from) {
    FitOptions options = inserted();
    options.knots = KnotPlacement::free;
    options.free_from = free_from;
    return options;
}

/// delta2 from which knots are moved: as the paper says, when it is "below some level".
std::vector<Figure> figures() {
    return {{1, 1, 0, equal_knots(), {10, 12709, 67.603, 1925.4}},
            {2, 2, 0, inserted(), {20, 176.73, 0.99287, 1086.1}},
            {3, 3, 0, moved(2000), {15, 153.52, 0.83895, 1047.8}},
            {4, 1, 1, equal_knots(), {10, 16124, 85.767, 1973.3}},
            {5, 2, 1, inserted(), {24, 194.78, 1.1194, 1113.6}},
            {6, 3, 1, moved(2000), {14, 165.02, 0.89687, 1060.3}},
            {7, 2, 2, inserted(), {8, 27.497, 0.72362, 184.39}},
            {8, 3, 2, moved(100), {8, 16.399, 0.43155, 159.06}},
            {9, 2, 3, inserted(), {28, 306.89, 1.8155, 1207.2}},
            {10, 3, 3, moved(2000), {25, 228.73, 1.3298, 1142.5}},
            {11, 2, 4, inserted(), {15, 296.60, 1.2256, 1516.0}},
            {12, 3, 4, moved(2000), {12, 306.59, 1.2514, 1518.6}}};
}

PolylineLayer traced(const SplineFunction& s, int derivative) {
    Points line(0, 2);
    for (int i = 0; i <= 1000; ++i) {
        const double x = s.domain().clamp(s.domain().lo + s.domain().length() * i / 1000);
        line.push_back(std::array{x, s(x, derivative)});
    }
    return {{line}, {}, {Tone::ink, Dash::solid, 1.4}};
}

Panel chart(const std::string& caption, const std::string& y_label) {
    Panel panel;
    panel.kind = PanelKind::chart;
    panel.caption = caption;
    panel.x_label = "x";
    panel.y_label = y_label;
    return panel;
}

/// Marks at the knots along the lower and upper edge, as in the paper.
void add_marks(Panel& panel, const SplineFunction& s, const std::vector<double>& values) {
    api::add_knot_marks(panel, s, api::extent_of(values), api::KnotEdges::both);
}

/// One standard deviation on both sides of 0.
RegionsLayer error_band(const Data& data) {
    Points outline(0, 2);
    const std::size_t n = data.x.size();
    for (std::size_t i = 0; i < n; ++i) outline.push_back(std::array{data.x[i], data.sigma[i]});
    for (std::size_t i = n; i-- > 0;) outline.push_back(std::array{data.x[i], -data.sigma[i]});
    return {{outline}, "±σ", Tone::blue};
}

PointsLayer dots(const Data& data, const std::vector<double>& values) {
    Points points(0, 2);
    for (std::size_t i = 0; i < values.size(); ++i) points.push_back(std::array{data.x[i], values[i]});
    return {points, "data", Marker::open, {}, PointLabels::none, Tone::accent};
}

Drawing drawn(const Figure& figure, const Data& data, const Fit& fit) {
    const SplineFunction& s = fit.spline;
    std::vector<double> residuals(data.x.size()), values, slopes;
    for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = data.f[i] - s(data.x[i]);
    for (int i = 0; i <= 1000; ++i) {
        const double x = s.domain().clamp(s.domain().lo + s.domain().length() * i / 1000);
        values.push_back(s(x));
        slopes.push_back(s(x, 1));
    }
    Drawing drawing;
    drawing.title = "Figure 2." + std::to_string(figure.number) + ": KPROG = " +
                    std::to_string(figure.program) + ", n = " +
                    std::to_string(fit.report.intervals);
    drawing.subtitle = data.name + ", δ² = " + format_fixed(fit.report.delta2, 2) + ", σ² = " +
                       format_fixed(fit.report.sigma2.value_or(0), 4) + ", AIC = " +
                       format_fixed(fit.report.aic, 1);
    drawing.columns = 2;
    drawing.width = 900;
    drawing.panels = {chart("a: residuals", "f − S"), chart("b: dS/dx", "dS/dx"),
                      chart("a: data and S", "f"), chart("b: S", "S")};
    drawing.panels[0].add(error_band(data)).add(dots(data, residuals));
    add_marks(drawing.panels[0], s, residuals);
    drawing.panels[1].add(traced(s, 1));
    add_marks(drawing.panels[1], s, slopes);
    drawing.panels[2].add(dots(data, data.f)).add(traced(s, 0));
    add_marks(drawing.panels[2], s, data.f);
    drawing.panels[3].add(traced(s, 0));
    add_marks(drawing.panels[3], s, values);
    return drawing;
}

std::string padded(const std::string& text, std::size_t width) {
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

std::string cell(double value, int decimals) { return padded(format_fixed(value, decimals), 10); }

double seconds(const std::function<void()>& work, int times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) work();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return passed.count() / times;
}

void print_row(const Figure& figure, const FitReport& ours) {
    const Printed& paper = figure.printed;
    std::cout << "2." << padded(std::to_string(figure.number), 2) << "  " << figure.program << "   "
              << padded(std::to_string(paper.intervals), 3)
              << padded(std::to_string(ours.intervals), 4) << cell(paper.delta2, 3)
              << cell(ours.delta2, 3) << cell(paper.sigma2, 4)
              << cell(ours.sigma2.value_or(0), 4) << cell(paper.aic, 1) << cell(ours.aic, 1) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: curves CASES FOLDER\n";
        return 2;
    }
    const std::string cases = argv[1], folder = argv[2];
    const std::vector<Data> all = {
        table_data("201 equally spaced points", cases + "/fits/hatano-equal.csv"), unequal_data(),
        table_data("titanium heat data", cases + "/fits/titanium.csv"),
        spectrum("a made-up spectrum of 200 points", 200, strong_lines, 5),
        spectrum("a made-up spectrum of 260 points", 260, weak_lines, 6)};
    std::cout << "fig KPROG   n: paper ours  δ²: paper ours  σ²: paper ours  AIC: paper ours\n";
    for (const Figure& figure : figures()) {
        const Data& data = all[static_cast<std::size_t>(figure.data)];
        const Fit made = fit(data.view(), figure.options);
        const std::string pad(figure.number < 10 ? "0" : "");
        write_file(folder + "/figure-2." + pad + std::to_string(figure.number) + ".svg",
                   svg(drawn(figure, data, made)));
        print_row(figure, made.report);
    }
    std::cout << "\ntime of KPROG 3 as a multiple of KPROG 2's, from part way and from the start "
                 "(best known knots):\n";
    for (const Figure& figure : figures()) {
        if (figure.program != 3) continue;
        const Data& data = all[static_cast<std::size_t>(figure.data)];
        FitOptions best = figure.options;
        best.free_from.reset();
        const double insertion = seconds([&] { fit(data.view(), inserted()); }, 20);
        const double part_way = seconds([&] { fit(data.view(), figure.options); }, 3);
        Fit found = fit(data.view(), best);
        const double whole = seconds([&] { found = fit(data.view(), best); }, 1);
        std::cout << "2." << figure.number << ": " << format_fixed(part_way / insertion, 0) << ", "
                  << format_fixed(whole / insertion, 0) << " (n = " << found.report.intervals
                  << ", δ² = " << format_fixed(found.report.delta2, 3) << ")\n";
    }
}
