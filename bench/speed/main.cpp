#include <benchmark/benchmark.h>
#include <malloc.h>

#include <climits>

// Memory that was given back is kept for the next round, on all sides: a page that the system hands
// out anew costs more than the spline on it.
int main(int argc, char** argv) {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, INT_MAX);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
