// The floor: how fast this machine copies doubles in this run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "data.hpp"

namespace batten::bench {
namespace {

void copy(benchmark::State& state, std::size_t n) {
    const std::vector<double> from(n, 1.5);
    std::vector<double> to(n);
    for (auto _ : state) {
        std::copy(from.begin(), from.end(), to.begin());
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n));
}

const bool registered = [] {
    for (const std::size_t n : {1'000'000, 10'000'000}) {
        benchmark::RegisterBenchmark(name_of("copy", "machine", n).c_str(),
                                     [n](benchmark::State& state) { copy(state, n); });
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
