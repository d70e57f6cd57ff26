// A million values of a cubic spline, parameters sorted or in no order, into memory that is reused.
#include <benchmark/benchmark.h>
#include <gsl/gsl_spline.h>

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>
#include <numeric>
#include <vector>

#include "batten/shape/cubic_evaluator.hpp"
#include "data.hpp"

namespace batten::bench {
namespace {

constexpr std::size_t count = 1'000'000;

using Parameters = std::vector<double> (*)(std::size_t, double);

std::vector<double> parameters_for(Parameters make, std::size_t knots) {
    return make(count, static_cast<double>(knots - 1));
}

void finish(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void by_batten(benchmark::State& state, Parameters make, std::size_t knots, int order) {
    const CubicEvaluator evaluator(*height_curve(knots).shape<PiecewiseCubic>());
    const std::vector<double> t = parameters_for(make, knots);
    std::vector<double> out(count * static_cast<std::size_t>(order + 1));
    for (auto _ : state) {
        evaluator.evaluate(t, order, out);
        benchmark::ClobberMemory();
    }
    finish(state);
}

void by_gsl(benchmark::State& state, Parameters make, std::size_t knots, int order) {
    const std::vector<double> y = heights(knots), t = parameters_for(make, knots);
    std::vector<double> x(knots), out(count * static_cast<std::size_t>(order + 1));
    std::iota(x.begin(), x.end(), 0.0);
    gsl_spline* const spline = gsl_spline_alloc(gsl_interp_cspline, knots);
    gsl_interp_accel* const found = gsl_interp_accel_alloc();
    gsl_spline_init(spline, x.data(), y.data(), knots);
    for (auto _ : state) {
        double* to = out.data();
        for (const double at : t) {
            *to++ = gsl_spline_eval(spline, at, found);
            if (order < 2) continue;
            *to++ = gsl_spline_eval_deriv(spline, at, found);
            *to++ = gsl_spline_eval_deriv2(spline, at, found);
        }
        benchmark::ClobberMemory();
    }
    gsl_interp_accel_free(found);
    gsl_spline_free(spline);
    finish(state);
}

void by_boost(benchmark::State& state, Parameters make, std::size_t knots) {
    const std::vector<double> y = heights(knots), t = parameters_for(make, knots);
    const boost::math::interpolators::cardinal_cubic_b_spline<double> spline(y.begin(), y.end(), 0.0,
                                                                             1.0);
    std::vector<double> out(count);
    for (auto _ : state) {
        for (std::size_t i = 0; i < count; ++i) out[i] = spline(t[i]);
        benchmark::ClobberMemory();
    }
    finish(state);
}

void add(const std::string& operation, Parameters make, std::size_t knots, int order) {
    benchmark::RegisterBenchmark(
        name_of(operation, "batten", knots).c_str(),
        [=](benchmark::State& state) { by_batten(state, make, knots, order); });
    benchmark::RegisterBenchmark(
        name_of(operation, "GSL", knots).c_str(),
        [=](benchmark::State& state) { by_gsl(state, make, knots, order); });
    if (order > 0) return;
    benchmark::RegisterBenchmark(
        name_of(operation, "Boost", knots).c_str(),
        [=](benchmark::State& state) { by_boost(state, make, knots); });
}

const bool registered = [] {
    for (const std::size_t knots : {100, 10'000}) {
        add("evaluate-sorted", &sorted_parameters, knots, 0);
        add("evaluate-random", &random_parameters, knots, 0);
        add("evaluate-derivatives", &sorted_parameters, knots, 2);
    }
    return true;
}();

}  // namespace
}  // namespace batten::bench
