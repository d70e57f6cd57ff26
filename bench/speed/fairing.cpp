// Fairing: the paper's filter, the steps of Gauss-Newton, whole runs with lambda given and found,
// alpha from points, one log-aesthetic segment, a grid. No peer does the same.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "batten/make/alpha.hpp"
#include "batten/make/fair.hpp"
#include "batten/make/fair_surface.hpp"
#include "batten/make/log_aesthetic.hpp"
#include "batten/shape/curve.hpp"
#include "data.hpp"

namespace batten::bench {
namespace {

constexpr double degree_angle = 0.017453292519943295;

/// A quarter turn, radii 1 to 3, of length 1.
Curve quarter() {
    LogAestheticSegment arc = *log_aesthetic_segment(0.5, 1, 50 * degree_angle, 90 * degree_angle);
    const double length = arc.length;
    arc.length = 1;
    arc.start_curvature *= length;
    arc.end_curvature *= length;
    return LogAestheticCurve(std::vector<double>{0, 0}, 0, arc);
}

/// n points at equal steps, moved by uniform noise of this rms.
Points noisy(std::size_t n, double sigma) {
    const Curve curve = quarter();
    std::mt19937 engine(1);
    Points points(0, 2);
    const auto step = [&] {
        return std::sqrt(3.0) * sigma * (2 * static_cast<double>(engine()) / 4294967295.0 - 1);
    };
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> p =
            curve(curve.domain().hi * static_cast<double>(i) / static_cast<double>(n - 1));
        for (double& x : p) x += step();
        points.push_back(p);
    }
    return points;
}

/// A point and sweep at window 5: with noise samples are clamped, without it none is.
void filter(benchmark::State& state, std::size_t n, double noise) {
    const Points points = noisy(n, noise / static_cast<double>(n));
    FairOptions options;
    options.alpha.value = 0.5;
    options.engine = FairEngine::filter;
    options.window = 5;
    for (auto _ : state) benchmark::DoNotOptimize(fair(points, options).report.sweeps);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n) * options.sweeps);
}

/// lambda whose cutoff is so many points long.
double lambda_of(double wave, std::size_t n, double sigma) {
    const double spacing = 1 / static_cast<double>(n - 1);
    return std::pow(wave * spacing / 6.283185307179586, 8) / (spacing * sigma * sigma);
}

/// What one of `count` units takes: steps times points, or runs.
template <class Units>
void gauss_newton(benchmark::State& state, const Points& points, const FairOptions& options,
                  Units units) {
    std::int64_t count = 0;
    for (auto _ : state) count += units(fair(points, options).report);
    state.SetItemsProcessed(count);
}

FairOptions options_for(std::size_t n, double sigma) {
    FairOptions options;
    options.sigma = sigma;
    options.lambda = lambda_of(40, n, sigma);
    return options;
}

void steps(benchmark::State& state, std::size_t n) {
    const double sigma = 0.05 / static_cast<double>(n);
    gauss_newton(state, noisy(n, sigma), options_for(n, sigma), [n](const FairReport& report) {
        return static_cast<std::int64_t>(n) * report.sweeps;
    });
}

void lambda_given(benchmark::State& state, std::size_t n) {
    const double sigma = 0.05 / static_cast<double>(n);
    gauss_newton(state, noisy(n, sigma), options_for(n, sigma),
                 [](const FairReport&) { return std::int64_t{1}; });
}

void lambda_found(benchmark::State& state, std::size_t n) {
    const double sigma = 0.05 / static_cast<double>(n);
    FairOptions options;
    options.sigma = sigma;
    gauss_newton(state, noisy(n, sigma), options,
                 [](const FairReport&) { return std::int64_t{1}; });
}

void alpha(benchmark::State& state, std::size_t n) {
    const Points points = noisy(n, 1e-3);
    for (auto _ : state) benchmark::DoNotOptimize(alpha_of(points).alpha);
    state.SetItemsProcessed(state.iterations());
}

void segment(benchmark::State& state, double exponent) {
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            log_aesthetic_segment(exponent, 1, 50 * degree_angle, 90 * degree_angle));
    }
    state.SetItemsProcessed(state.iterations());
}

void surface(benchmark::State& state, std::size_t n) {
    Grid grid(n, n, 3);
    std::mt19937 engine(1);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double u = static_cast<double>(i) / static_cast<double>(n - 1) - 0.5;
            const double v = static_cast<double>(j) / static_cast<double>(n - 1) - 0.5;
            const double noise = 1e-3 * (static_cast<double>(engine()) / 4294967295.0 - 0.5);
            grid(i, j, 0) = (1 + noise) * std::cos(v) * std::cos(u);
            grid(i, j, 1) = (1 + noise) * std::cos(v) * std::sin(u);
            grid(i, j, 2) = (1 + noise) * std::sin(v);
        }
    }
    for (auto _ : state) benchmark::DoNotOptimize(fair_surface(grid, {}).report.steps);
    state.SetItemsProcessed(state.iterations());
}

template <class Work>
void add(const char* operation, std::size_t size, Work work) {
    benchmark::RegisterBenchmark(name_of(operation, "batten", size).c_str(), work);
}

const bool is_registered = [] {
    for (const std::size_t n : {std::size_t{100}, std::size_t{1000}}) {
        add("filter-clamped", n, [n](benchmark::State& s) { filter(s, n, 0.05); });
        add("filter", n, [n](benchmark::State& s) { filter(s, n, 0); });
    }
    for (const std::size_t n : {std::size_t{20}, std::size_t{1000}, std::size_t{100000}}) {
        add("fair-step", n, [n](benchmark::State& s) { steps(s, n); });
        add("fair-lambda-given", n, [n](benchmark::State& s) { lambda_given(s, n); });
        add("fair-lambda-found", n, [n](benchmark::State& s) { lambda_found(s, n); });
    }
    add("alpha", 100, [](benchmark::State& s) { alpha(s, 100); });
    add("log-aesthetic-segment", 1, [](benchmark::State& s) { segment(s, 0.5); });
    for (const std::size_t n : {std::size_t{33}, std::size_t{256}}) {
        add("fair-surface", n * n, [n](benchmark::State& s) { surface(s, n); });
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
