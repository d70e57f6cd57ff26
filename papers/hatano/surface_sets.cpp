#include "surface_sets.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "batten/io/grid_file.hpp"
#include "noise.hpp"

namespace papers {
namespace {

using batten::Grid;
using batten::Heights;
using Truth = std::function<double(double, double)>;

SurfaceSet noisy(std::string name, Heights places, const Truth& truth, double sigma) {
    Noise noise(places.x.size());
    places.z = Grid(places.x.size(), places.y.size());
    for (std::size_t i = 0; i < places.x.size(); ++i) {
        for (std::size_t j = 0; j < places.y.size(); ++j) {
            places.z(i, j) = truth(places.x[i], places.y[j]) + sigma * noise.normal();
        }
    }
    return {std::move(name), std::move(places), sigma};
}

std::vector<double> counted(std::size_t count) {
    return batten::even_places({0, static_cast<double>(count - 1)}, count);
}

double bell(double x, double center, double width) {
    const double e = (x - center) / width;
    return std::exp(-0.5 * e * e);
}

/// What the shipped set of Figure 3.1 was made of: fitted to it, delta2 = 3121.3 at 3111 nodes.
double two_hills(double x, double y) {
    static constexpr double c[5][5] = {{45.00, -9.98, 8.43, -0.01, -0.59},
                                       {18.02, -8.83, 5.60, -0.31, 0.68},
                                       {14.31, 4.01, -3.66, 0.21, 4.02},
                                       {-4.92, -0.12, 0.24, 0.22, -0.51},
                                       {-3.36, -0.01, 3.93, -0.25, -2.09}};
    const double u = (x - 30) / 30, v = (y - 25) / 25;
    double sum = 0;
    for (int i = 4; i >= 0; --i) {
        double row = 0;
        for (int j = 4; j >= 0; --j) row = row * v + c[i][j];
        sum = sum * u + row;
    }
    return sum - 62.05 * bell(x, 41.99, 5.00) * bell(y, 33.99, 3.60) +
           79.90 * bell(x, 20.01, 4.01) * bell(y, 17.01, 4.49);
}

std::vector<double> places_at_random(std::size_t count, double length, std::uint64_t seed) {
    Noise noise(seed);
    std::vector<double> places{0, length};
    while (places.size() < count) places.push_back(length * noise.uniform());
    std::sort(places.begin(), places.end());
    return places;
}

/// 1 inside an ellipse, 0 outside, over about a tenth of its size.
double inside(double x, double y, double a, double b, double width, double height) {
    const double r = std::hypot((x - a) / width, (y - b) / height);
    return 1 / (1 + std::exp(11 * (r - 1)));
}

double chest(double x, double y) {
    const double u = (x - 63.5) / 63.5, v = (y - 64.5) / 64.5;
    const double lungs = inside(u, v, -0.44, 0.05, 0.34, 0.66) + inside(u, v, 0.44, 0.05, 0.32, 0.66);
    const double heart = inside(u, v, 0.16, -0.22, 0.3, 0.3);
    const double ribs = std::sin(10 * (v + 0.55 * u * u));
    const double body = 300 * inside(u, v, 0, -0.1, 1.05, 1.2);
    return 40 + body * (1 - 0.62 * lungs * (1 - 0.75 * heart)) + 14 * ribs * lungs -
           28 * bell(u, 0, 0.07) * (1 - heart);
}

struct Hill {
    double x, y, width, depth, height;
};

std::vector<Hill> hills_at_random() {
    Noise noise(8);
    std::vector<Hill> hills;
    for (int k = 0; k < 60; ++k) {
        const double size = 4 + 9 * noise.uniform();
        hills.push_back({100 * noise.uniform(), 100 * noise.uniform(), size,
                         size * (0.6 + 0.8 * noise.uniform()), size * (2 * noise.uniform() - 0.7)});
    }
    return hills;
}

double scintillation(double x, double y) {
    const double front = 0.22 + 0.5 * y + 0.07 * std::sin(2 * std::numbers::pi * y);
    const double glow = std::exp(-((x - 0.45) * (x - 0.45) / 0.18 + (y - 0.6) * (y - 0.6) / 0.35));
    return (0.25 + 0.9 * glow) * 0.5 * (1 + std::tanh((front - x) / 0.006)) *
               (1 + 0.15 * std::sin(3 * x)) +
           0.12 * std::exp(-3 * (x - 0.2) * (x - 0.2)) * (0.4 + 0.6 * y) + 0.02;
}

}  // namespace

SurfaceSet equal_set(const std::string& cases) {
    const batten::GridFile file = batten::read_grid(cases + "/surfaces/hatano-surface.csv");
    return {"61 x 51 equally spaced nodes", {file.x, file.y, file.z}, 1};
}

SurfaceSet unequal_set() {
    return noisy("61 x 51 nodes at random",
                 {places_at_random(61, 60, 7), places_at_random(51, 50, 8)}, two_hills, 1);
}

SurfaceSet chest_set() {
    return noisy("made up in place of a chest X-ray, 128 x 130", {counted(128), counted(130)}, chest,
                 5);
}

SurfaceSet terrain_set() {
    const std::vector<Hill> hills = hills_at_random();
    const Truth truth = [&](double x, double y) {
        double sum = 22 + 0.08 * x + 0.05 * y;
        for (const Hill& h : hills) sum += h.height * bell(x, h.x, h.width) * bell(y, h.y, h.depth);
        return sum;
    };
    return noisy("made up in place of a terrain, 100 x 101", {counted(100), counted(101)}, truth, 1);
}

SurfaceSet scintillator_set() {
    std::vector<double> y = batten::even_places({0, 1}, 21);
    Noise noise(21);
    for (std::size_t j = 1; j + 1 < y.size(); ++j) y[j] += 0.02 * (2 * noise.uniform() - 1);
    return noisy("made up in place of a scintillator, 156 x 21",
                 {batten::even_places({0, 1}, 156), std::move(y)}, scintillation, 0.01);
}

}  // namespace papers
