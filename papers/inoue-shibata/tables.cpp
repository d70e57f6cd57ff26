/// Tables 3, 4 and 5 of Inoue & Shibata, "Pseudo-spline curve": what is printed, the paper's way
/// (paper_table.hpp), and ours.

#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <vector>

#include "batten/batten.hpp"
#include "paper_table.hpp"

namespace {

using namespace batten;

constexpr double pi = std::numbers::pi;

struct Printed {
    int n;
    double length;
    int length_points;
    double area;
    int area_points;
};

/// The area of n = 9 is printed as 3.14053616; its number of points, 141, says 3.14053816.
constexpr Printed printed[] = {{3, 6.18957607, 11, 3.04563765, 15},
                               {4, 6.26067766, 22, 3.11345972, 28},
                               {5, 6.27774034, 44, 3.13063511, 44},
                               {6, 6.27785088, 45, 3.13614662, 62},
                               {7, 6.28605010, 61, 3.13830387, 80},
                               {8, 6.28591825, 62, 3.13961368, 103},
                               {9, 6.28219908, 103, 3.14053816, 141},
                               {10, 6.28757066, 49, 3.14105203, 196}};

double polygon_length(int n) { return 2 * n * std::sin(pi / n); }
double polygon_area(int n) { return 0.5 * n * std::sin(2 * pi / n); }

/// The least number of points whose polygon is nearer to the truth.
int equal_points(double truth, double value, double (*polygon)(int)) {
    int n = 3;
    while (!(std::fabs(truth - value) > std::fabs(truth - polygon(n)))) ++n;
    return n;
}

Points circle(int n) {
    Points points(2);
    for (int k = 0; k < n; ++k) {
        points.push_back(std::vector<double>{std::cos(2 * pi * k / n), std::sin(2 * pi * k / n)});
    }
    return points;
}

/// Length and area of the closed curve through circular points by the paper's table.
struct Measures {
    double length, area;
};

Measures paper_circle(const PaperTable& table, int n) {
    const double chord = 2 * std::sin(pi / n), turn = 2 * pi / n;
    const double theta1 = table.tangent(turn, chord, chord), theta0 = theta1 - turn;
    const PaperTable::Segment s = table.segment(theta0, theta1);
    return {n * chord * s.length, polygon_area(n) - n * chord * chord * s.area};
}

void print_circles(const PaperTable& table) {
    std::cout << "\nTables 4 and 5: unit circle, length 6.28318531 and area 3.14159265;\n"
                 "after each number how many points give as good a polygon\n\n"
                 "          printed        the paper's way           ours\n" << std::fixed;
    const auto number = [](double value, int points) {
        std::cout << "  " << std::setprecision(8) << value << std::setw(5) << points;
    };
    for (const bool is_length : {true, false}) {
        std::cout << (is_length ? "length\n" : "area\n");
        const double truth = is_length ? 2 * pi : pi;
        const auto polygon = is_length ? polygon_length : polygon_area;
        for (const Printed& row : printed) {
            const Measures paper = paper_circle(table, row.n);
            const PseudoSpline ours = pseudo_spline(circle(row.n), {true});
            const double by_paper = is_length ? paper.length : paper.area;
            const double by_us = is_length ? ours.length : ours.area;
            std::cout << std::setw(3) << row.n;
            number(is_length ? row.length : row.area,
                   is_length ? row.length_points : row.area_points);
            number(by_paper, equal_points(truth, by_paper, polygon));
            number(by_us, equal_points(truth, by_us, polygon));
            std::cout << '\n';
        }
    }
}

/// The paper's curve: approximate tangents, interpolated magnitudes.
Curve paper_curve(const PaperTable& table, const Points& points) {
    const std::size_t spans = points.size() - 1;
    std::vector<double> lengths(spans), phi(spans);
    for (std::size_t i = 0; i < spans; ++i) {
        const double dx = points(i + 1, 0) - points(i, 0), dy = points(i + 1, 1) - points(i, 1);
        lengths[i] = std::hypot(dx, dy);
        phi[i] = std::atan2(dy, dx);
    }
    const auto turn = [&](std::size_t i) { return std::remainder(phi[i] - phi[i - 1], 2 * pi); };
    std::vector<double> before(spans + 1), after(spans + 1);
    for (std::size_t i = 1; i < spans; ++i) {
        before[i] = table.tangent(turn(i), lengths[i - 1], lengths[i]);
        after[i] = before[i] - turn(i);
    }
    after[0] = table.end(before[1]).theta1;
    before[spans] = table.end(after[spans - 1]).theta1;
    Points start(2), end(2);
    std::vector<double> breaks{0};
    for (std::size_t i = 0; i < spans; ++i) {
        const PaperTable::Segment s = table.segment(after[i], before[i + 1]);
        const double a = phi[i] + after[i], b = phi[i] + before[i + 1];
        const double l0 = lengths[i] * s.r0, l1 = lengths[i] * s.r1;
        start.push_back(std::vector<double>{l0 * std::cos(a), l0 * std::sin(a)});
        end.push_back(std::vector<double>{l1 * std::cos(b), l1 * std::sin(b)});
        breaks.push_back(static_cast<double>(i + 1));
    }
    return PiecewiseCubic::hermite(points, start, end, breaks, false);
}

/// Microseconds to make a curve and 200 points of each span, the least of five runs.
template <class Make>
double microseconds(Make&& make, int repeats) {
    using Clock = std::chrono::steady_clock;
    double least = 1e9;
    std::vector<double> t, values;
    for (int run = 0; run < 5; ++run) {
        const auto start = Clock::now();
        for (int k = 0; k < repeats; ++k) {
            const Curve curve = make();
            const double end = curve.domain().hi;
            t.clear();
            for (double at = 0; at < end; at += 0.005) t.push_back(at);
            values.resize(2 * t.size());
            curve.jets(t, 0, values);
        }
        const std::chrono::duration<double, std::micro> spent = Clock::now() - start;
        least = std::fmin(least, spent.count() / repeats);
    }
    return least;
}

void print_times(const PaperTable& table) {
    const Points first({-4, 0, -3, 0, -2, 0, -1, 0, 0, 3, 1, 0, 2, 0, 3, 0, 4, 0}, 2);
    const Points second({0, 0, 2, -0.1, 1, -0.1, 3, 0}, 2);
    const double seconds[][2] = {{1.9, 0.1}, {2.5, 0.2}, {2.1, 0.1}, {0, 0}};
    const char* names[] = {"not optimised", "exactly", "the paper's way", "ours, from tables"};
    std::cout << "\nTable 3: time for a curve, 200 points a span, without reading the tables;\n"
                 "printed in seconds with drawing, here in microseconds (Table 1: y = 3)\n\n"
                 "                    printed       here\n"
                 "data of Table          1    2          1          2\n";
    for (int way = 0; way < 4; ++way) {
        double here[2];
        for (const int set : {0, 1}) {
            const Points& points = set == 0 ? first : second;
            InterpolateOptions options;
            if (way == 0) options.method = Method::hermite_chord;
            options.exact = way == 1;
            here[set] = microseconds(
                [&] {
                    return way == 2 ? paper_curve(table, points) : curve_through(points, options);
                },
                way == 1 ? 5 : 200);
        }
        std::cout << std::left << std::setw(20) << names[way] << std::right << std::setprecision(1);
        for (const int set : {0, 1}) {
            if (way < 3) std::cout << std::setw(5) << seconds[way][set];
            if (way == 3) std::cout << std::setw(5) << "";
        }
        std::cout << std::setw(11) << here[0] << std::setw(11) << here[1] << '\n';
    }
    const Curve paper = paper_curve(table, second), ours = curve_through(second, {});
    std::cout << "\nsum E L^2 for the data of Table 2: the paper's way " << std::setprecision(4)
              << pseudo_energy(paper)->value << ", ours " << pseudo_energy(ours)->value << '\n';
}

}  // namespace

int main() {
    const PaperTable table;
    print_circles(table);
    print_times(table);
}
