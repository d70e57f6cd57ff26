/// Times surfaces on M x N heights (raw doubles, x slowest, places 0 ... 1 each way, sigma 1):
///
///     surface_speed DATA M N sum              summing the array
///     surface_speed DATA M N fit P Q          coefficients alone, P x Q equal strips
///     surface_speed DATA M N report P Q       the whole fit_surface
///     surface_speed DATA M N auto DELTA2      automatic knot lines to that delta2
///     surface_speed DATA M N evaluate K       a surface of K x K coefficients on the M x N nodes
///
/// Prints the least and the median seconds of the processor, and the numbers that surface_speed.py
/// tells.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "batten/base/text.hpp"
#include "batten/make/fit_surface.hpp"
#include "make/fit_surface/solve.hpp"

namespace {

using namespace batten;

std::vector<double> read_doubles(const std::string& path) {
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    std::vector<double> values(static_cast<std::size_t>(stream.tellg()) / sizeof(double));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(values.data()),
                static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

/// Sixteen running sums: as fast as memory gives.
double sum_of(const std::vector<double>& values) {
    double lanes[16] = {};
    std::size_t i = 0;
    for (; i + 16 <= values.size(); i += 16) {
        for (std::size_t l = 0; l < 16; ++l) lanes[l] += values[i + l];
    }
    for (; i < values.size(); ++i) lanes[0] += values[i];
    return std::accumulate(lanes, lanes + 16, 0.0);
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void print_times(const std::function<double()>& work) {
    std::vector<double> times;
    double result = 0;
    const double start = cpu_seconds();
    while (times.size() < 5 || cpu_seconds() - start < 0.5) {
        const double before = cpu_seconds();
        result = work();
        times.push_back(cpu_seconds() - before);
    }
    std::sort(times.begin(), times.end());
    std::cout << format_number(times.front()) << ' ' << format_number(times[times.size() / 2])
              << ' ' << format_number(result);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::cerr << "usage: surface_speed DATA M N sum|fit|report|auto|evaluate ...\n";
        return 2;
    }
    const std::vector<double> z = read_doubles(argv[1]);
    const std::size_t m = std::stoul(argv[2]), n = std::stoul(argv[3]);
    const std::string mode = argv[4];
    const std::vector<double> x = even_places({0, 1}, m), y = even_places({0, 1}, n);
    const SurfaceSamples samples{x, y, {z.data(), m, n, 1}};
    FitSurfaceOptions options;
    options.sigma = 1;
    if (mode == "sum") {
        print_times([&] { return sum_of(z); });
    } else if (mode == "fit" || mode == "report") {
        options.knots = SurfaceKnots::equal;
        options.intervals = {*parse_number(argv[5]), *parse_number(argv[6])};
        if (mode == "report") {
            print_times([&] { return fit_surface(samples, options).report.delta2; });
        } else {
            using namespace surface_fitting;
            print_times([&] {
                const Nodes nodes = prepared_nodes(samples, options);
                const auto axis = [&](std::span<const double> lines, double strips,
                                      const std::vector<double>& weights) {
                    const auto breaks =
                        even_places({0, 1}, static_cast<std::size_t>(strips) + 1);
                    return Axis(basis_over(breaks, 3), lines, weights, lines);
                };
                const Axis a = axis(nodes.x, options.intervals[0], nodes.x_weight);
                const Axis b = axis(nodes.y, options.intervals[1], nodes.y_weight);
                return solve(nodes, a, b, Corrected::where_needed).coefficients[0];
            });
        }
    } else if (mode == "auto") {
        options.delta2 = *parse_number(argv[5]);
        FitSurfaceReport report;
        print_times([&] {
            report = fit_surface(samples, options).report;
            return report.delta2;
        });
        std::cout << ' ' << report.intervals[0] << ' ' << report.intervals[1];
    } else {
        const std::size_t k = std::stoul(argv[5]);
        const BSplineBasis basis = BSplineBasis::over(even_places({0, 1}, k - 2), 3);
        std::vector<double> c(k * k);
        for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::sin(static_cast<double>(i));
        const SplineSurface surface(basis, basis, c);
        std::vector<double> out(m * n);
        print_times([&] {
            surface.evaluate(x, y, {}, out);
            return out[m * n / 2];
        });
    }
    std::cout << '\n';
}
