// Length, to 1e-12, and area of a curve of cubic pieces that is there already.
#include <benchmark/benchmark.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "batten/make/interpolate.hpp"
#include "batten/measure/area.hpp"
#include "batten/measure/length.hpp"
#include "data.hpp"

namespace batten::bench {
namespace {

Curve curve_of(std::size_t n) {
    InterpolateOptions options;
    options.method = Method::natural_chord;
    return curve_through(wave(n), options);
}

void length_by_batten(benchmark::State& state, std::size_t n) {
    const Curve curve = curve_of(n);
    for (auto _ : state) benchmark::DoNotOptimize(length(curve).value);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

/// The same pieces, their speed asked for one parameter at a time.
void length_by_boost(benchmark::State& state, std::size_t n) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
    const Curve curve = curve_of(n);
    for (auto _ : state) {
        double sum = 0;
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const auto speed = [&](double t) {
                double jet[4];
                curve.jets_on(i, {&t, 1}, 1, jet);
                return std::sqrt(jet[2] * jet[2] + jet[3] * jet[3]);
            };
            sum += Rule::integrate(speed, curve.piece(i).lo, curve.piece(i).hi, 10, 1e-12);
        }
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

void area_by_batten(benchmark::State& state, std::size_t n) {
    const Curve curve = curve_of(n);
    for (auto _ : state) benchmark::DoNotOptimize(area(curve).value);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

const bool registered = [] {
    for (const std::size_t n : {1000, 100'000}) {
        benchmark::RegisterBenchmark(name_of("length", "batten", n).c_str(),
                                     [n](benchmark::State& state) { length_by_batten(state, n); });
        benchmark::RegisterBenchmark(name_of("length", "Boost", n).c_str(),
                                     [n](benchmark::State& state) { length_by_boost(state, n); });
        benchmark::RegisterBenchmark(name_of("area", "batten", n).c_str(),
                                     [n](benchmark::State& state) { area_by_batten(state, n); });
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
