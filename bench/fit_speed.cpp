/// Times fits of one data set: `fit_speed DATA fixed INTERVALS`, `fit_speed DATA weighted INTERVALS`
/// (every sample with an error of its own) or `fit_speed DATA auto DELTA2`, DATA being N abscissae
/// and N ordinates as raw doubles; sigma is 1. Prints seconds (the least and the median of the
/// runs), delta2, the number of intervals, and the least seconds that copying a double took
/// after the runs. See fit_speed.py.

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

/// Seconds a double, 16 MB to 16 MB: what memory allows.
class Copying {
public:
    void time() {
        const auto before = std::chrono::steady_clock::now();
        std::copy(from_.begin(), from_.end(), to_.begin());
        from_[0] += to_.back();
        least_ = std::min(least_, seconds_since(before) / static_cast<double>(from_.size()));
    }
    double least() const { return least_; }

private:
    std::vector<double> from_ = std::vector<double>(2000000, 1.0), to_ = from_;
    double least_ = 1;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "usage: fit_speed DATA fixed|weighted INTERVALS | fit_speed DATA auto DELTA2\n";
        return 2;
    }
    const std::vector<double> values = read_doubles(argv[1]);
    const std::size_t n = values.size() / 2;
    batten::FitSamples samples{{values.data(), n}, {values.data() + n, n}};
    std::vector<double> sigma(n);
    for (std::size_t i = 0; i < n; ++i) sigma[i] = i % 2 == 0 ? 0.9 : 1.1;
    const double number = batten::parse_number(argv[3]).value_or(1);
    batten::FitOptions options;
    options.sigma = 1;
    const std::string kind = argv[2];
    if (kind == "weighted") samples.sigma = sigma;
    if (kind != "auto") {
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
    Copying copying;
    for (int i = 0; i < 9; ++i) copying.time();
    std::sort(times.begin(), times.end());
    std::cout << batten::format_number(times.front()) << ' '
              << batten::format_number(times[times.size() / 2]) << ' '
              << batten::format_number(report.delta2) << ' ' << report.intervals << ' '
              << batten::format_number(copying.least()) << '\n';
}
