/// What fit_front makes of one front, two, one that dies out and a closed one, sharper and sharper:
/// the table in docs/surfaces.md.
///
/// usage: fronts
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "batten/make/fit_front.hpp"

namespace {

using namespace batten;

constexpr std::size_t rows = 156, columns = 31;
constexpr double sigma = 0.01;

double front(double y) { return 0.22 + 0.5 * y + 0.07 * std::sin(2 * std::numbers::pi * y); }
double plain(double x, double y) { return 0.4 + 0.2 * std::sin(2 * x) * (1 - 0.5 * y); }
double step(double distance, double w) {
    return w > 0 ? 0.5 * (1 + std::tanh(distance / w)) : (distance > 0 ? 1 : 0);
}

double one(double x, double y, double w) {
    return plain(x, y) + (0.9 + 0.2 * y - 0.3 * x) * step(front(y) - x, w);
}
double two(double x, double y, double w) {
    const double first = 0.15 + 0.25 * y + 0.05 * std::sin(2 * std::numbers::pi * y);
    const double second = 0.62 + 0.2 * y - 0.06 * std::sin(3 * y);
    return plain(x, y) + (0.9 + 0.2 * y - 0.3 * x) * step(x - first, w) -
           (0.7 - 0.2 * y) * step(x - second, w);
}
double dying(double x, double y, double w) {
    const double share = std::max(0.0, 0.7 - y) / 0.7;
    return plain(x, y) + (0.9 - 0.3 * x) * share * share * step(front(y) - x, w);
}
double closed(double x, double y, double w) {
    return plain(x, y) + 0.8 * step(0.28 - std::hypot(x - 0.5, y - 0.5), w);
}

template <class S, class Truth>
double distance_between(const S& surface, Truth truth, double w) {
    double sum = 0;
    for (int i = 0; i < 500; ++i) {
        for (int j = 0; j < 80; ++j) {
            const double x = (i + 0.5) / 500, y = (j + 0.5) / 80;
            sum += std::pow(surface(x, y) - truth(x, y, w), 2) / 40000;
        }
    }
    return std::sqrt(sum);
}

void print(const char* name, double (*truth)(double, double, double), double w) {
    std::mt19937_64 engine(4);
    std::normal_distribution<double> noise(0, sigma);
    const std::vector<double> x = even_places({0, 1}, rows), y = even_places({0, 1}, columns);
    Grid z(rows, columns);
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) z(i, j) = truth(x[i], y[j], w) + noise(engine);
    }
    FitFrontOptions options;
    options.sigma = sigma;
    const FrontFit made = fit_front({x, y, z}, options);
    const FrontReport& r = made.report;
    const FitSurfaceReport& t = made.tensor.report;
    std::printf("| %s, w = %g | ", name, w);
    if (r.has_front) {
        std::printf("%d + %d%s | %.2f | %.4f", r.parameters, r.parameters_charged - r.parameters,
                    r.is_jump ? ", jump" : "", *r.sigma2, distance_between(made.surface, truth, w));
    } else {
        std::printf("none seen | |");
    }
    std::printf(" | %d, %.2f, %.4f |\n", t.parameters, *t.sigma2,
                distance_between(made.tensor.surface, truth, w));
}

}  // namespace

int main() {
    for (const double w : {0.0, 0.0005, 0.006, 0.02}) print("one", one, w);
    for (const double w : {0.0, 0.0005, 0.006, 0.02}) print("two", two, w);
    for (const double w : {0.0005, 0.006, 0.02}) print("one that dies out", dying, w);
    for (const double w : {0.006, 0.02}) print("closed", closed, w);
}
