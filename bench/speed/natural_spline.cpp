// The natural cubic spline by chord length through points of the plane, chords included. Batten
// makes a new curve each time; GSL's workspace is reused.
#include <benchmark/benchmark.h>
#include <gsl/gsl_spline.h>

#include <vector>

#include "batten/make/interpolate.hpp"
#include "data.hpp"

namespace batten::bench {
namespace {

void by_batten(benchmark::State& state, std::size_t n) {
    const Points points = wave(n);
    InterpolateOptions options;
    options.method = Method::natural_chord;
    for (auto _ : state) benchmark::DoNotOptimize(curve_through(points, options));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

void by_gsl(benchmark::State& state, std::size_t n) {
    const Points points = wave(n);
    std::vector<double> x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = points(i, 0), y[i] = points(i, 1);
    gsl_spline* const splines[] = {gsl_spline_alloc(gsl_interp_cspline, n),
                                   gsl_spline_alloc(gsl_interp_cspline, n)};
    std::vector<double> t(n);
    for (auto _ : state) {
        fill_chord_parameters(points, t);
        gsl_spline_init(splines[0], t.data(), x.data(), n);
        gsl_spline_init(splines[1], t.data(), y.data(), n);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
    for (gsl_spline* spline : splines) gsl_spline_free(spline);
}

const bool registered = [] {
    for (const std::size_t n : {10, 1000, 10'000, 100'000, 1'000'000}) {
        benchmark::RegisterBenchmark(name_of("natural-spline", "batten", n).c_str(),
                                     [n](benchmark::State& state) { by_batten(state, n); });
        benchmark::RegisterBenchmark(name_of("natural-spline", "GSL", n).c_str(),
                                     [n](benchmark::State& state) { by_gsl(state, n); });
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
