/// Times fits of one data set: `fit_speed DATA fixed INTERVALS` or `fit_speed DATA auto DELTA2`,
/// DATA being N abscissae and N ordinates as raw doubles; sigma is 1. Prints seconds (the least and
/// the median of the runs), delta2 and the number of intervals. See fit_speed.py.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "batten/base/text.hpp"
#include "batten/make/fit.hpp"

namespace {

std::vector<double> read_doubles(const std::string& path) {
    std::ifstream stream(path, std::ios::binary | std::ios::ate);
    std::vector<double> values(static_cast<std::size_t>(stream.tellg()) / sizeof(double));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(values.data()),
                static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: fit_speed DATA fixed INTERVALS | fit_speed DATA auto DELTA2\n";
        return 2;
    }
    const std::vector<double> values = read_doubles(argv[1]);
    const std::size_t n = values.size() / 2;
    const batten::FitSamples samples{{values.data(), n}, {values.data() + n, n}};
    const double number = batten::parse_number(argv[3]).value_or(1);
    batten::FitOptions options;
    options.sigma = 1;
    if (std::string(argv[2]) == "fixed") {
        options.knots = batten::KnotPlacement::equal;
        options.intervals = static_cast<int>(number);
    } else {
        options.delta2 = number;
    }
    std::vector<double> times;
    batten::FitReport report;
    const auto start = std::chrono::steady_clock::now();
    while (times.size() < 5 || seconds_since(start) < 0.3) {
        const auto before = std::chrono::steady_clock::now();
        report = batten::fit(samples, options).report;
        times.push_back(seconds_since(before));
    }
    std::sort(times.begin(), times.end());
    std::cout << batten::format_number(times.front()) << ' '
              << batten::format_number(times[times.size() / 2]) << ' '
              << batten::format_number(report.delta2) << ' ' << report.intervals << '\n';
}
