// The whole way of the pseudo-spline: the curve, its length and its area. Beside it the G2 spiro
// spline of libspiro with its Bezier pieces, without length and area.
#include <benchmark/benchmark.h>
#include <spiroentrypoints.h>

#include <vector>

#include "batten/make/pseudo_spline.hpp"
#include "data.hpp"

namespace batten::bench {
namespace {

void by_batten(benchmark::State& state, const Points& points) {
    const std::size_t n = points.size();
    std::vector<double> block(8 * n);
    for (auto _ : state) {
        const PseudoSplineMeasures measures = pseudo_spline(points, {}, block);
        benchmark::DoNotOptimize(measures.length + measures.area);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

/// Counts what libspiro draws.
struct Counter {
    bezctx base{};
    std::size_t pieces = 0;
};

void count_piece(bezctx* context) { ++reinterpret_cast<Counter*>(context)->pieces; }

Counter counter() {
    Counter result;
    result.base.moveto = [](bezctx*, double, double, int) {};
    result.base.lineto = [](bezctx* c, double, double) { count_piece(c); };
    result.base.quadto = [](bezctx* c, double, double, double, double) { count_piece(c); };
    result.base.curveto = [](bezctx* c, double, double, double, double, double, double) {
        count_piece(c);
    };
    result.base.mark_knot = [](bezctx*, int) {};
    return result;
}

void by_spiro(benchmark::State& state, std::size_t n) {
    const Points points = wave(n);
    std::vector<spiro_cp> given(n);
    for (std::size_t i = 0; i < n; ++i) given[i] = {points(i, 0), points(i, 1), 'c'};
    for (auto _ : state) {
        std::vector<spiro_cp> copy = given;
        Counter drawn = counter();
        if (SpiroCPsToBezier0(copy.data(), static_cast<int>(n), 0, &drawn.base) != 1) {
            state.SkipWithError("libspiro found no curve");
            return;
        }
        benchmark::DoNotOptimize(drawn.pieces);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

const bool registered = [] {
    for (const std::size_t n : {100, 1000, 10'000, 100'000, 1'000'000}) {
        benchmark::RegisterBenchmark(name_of("pseudo-spline", "batten", n).c_str(),
                                     [n](benchmark::State& state) { by_batten(state, wave(n)); });
        benchmark::RegisterBenchmark(
            name_of("pseudo-spline-sharp", "batten", n).c_str(),
            [n](benchmark::State& state) { by_batten(state, sharp_way(n)); });
    }
    for (const std::size_t n : {100, 1000, 10'000, 100'000}) {
        benchmark::RegisterBenchmark(name_of("pseudo-spline", "libspiro", n).c_str(),
                                     [n](benchmark::State& state) { by_spiro(state, n); });
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
