#include "batten/shape/cubic_evaluator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "batten/api/operation.hpp"
#include "batten/make/interpolate.hpp"
#include "batten/make/natural_spline.hpp"
#include "batten/make/pseudo_spline.hpp"
#include "batten/shape/curve.hpp"
#include "random.hpp"
#include "shape/cubic_kernel.hpp"

namespace {

thread_local long allocations = 0;
/// Of one size, in bytes.
thread_local std::size_t watched_size = 0;
thread_local long watched = 0;

}  // namespace

// Counts the allocations of this program's threads.
void* operator new(std::size_t size) {
    ++allocations;
    watched += size == watched_size ? 1 : 0;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace batten {
namespace cubic_evaluator_law_test {

/// Pieces of very different lengths.
PiecewiseCubic uneven(int dim, int pieces, unsigned seed) {
    testing::Random random(seed);
    std::vector<double> breaks{-3};
    for (int i = 0; i < pieces; ++i) {
        breaks.push_back(breaks.back() + std::pow(10.0, random.within(-4, 1)));
    }
    const std::size_t n = static_cast<std::size_t>(pieces);
    return PiecewiseCubic::hermite(random.points(n + 1, dim), random.points(n, dim),
                                   random.points(n, dim), breaks, false);
}

std::vector<double> parameters(const PiecewiseCubic& curve, unsigned seed) {
    testing::Random random(seed);
    std::vector<double> t(curve.breaks().begin(), curve.breaks().end());
    for (int i = 0; i < 3000; ++i) {
        t.push_back(random.within(curve.breaks().front(), curve.breaks().back()));
        t.push_back(curve.breaks()[static_cast<std::size_t>(
                        random.whole(0, static_cast<int>(curve.pieces()) - 1))] + 1e-6);
    }
    return t;
}

TEST(CubicEvaluator, GivesTheBitsOfTheCurve) {
    for (const int dim : {1, 2, 3}) {
        for (const int pieces : {1, 2, 300}) {
            const PiecewiseCubic cubics = uneven(dim, pieces, 1);
            const CubicEvaluator evaluator(cubics);
            const Curve curve(cubics);
            std::vector<double> t = parameters(cubics, 2);
            for (const bool is_sorted : {false, true}) {
                if (is_sorted) std::sort(t.begin(), t.end());
                for (const int order : {0, 1, 2}) {
                    const std::size_t size = t.size() * static_cast<std::size_t>((order + 1) * dim);
                    std::vector<double> expected(size), out(size);
                    curve.jets(t, order, expected);
                    evaluator.evaluate(t, order, out);
                    EXPECT_EQ(out, expected) << dim << ' ' << pieces << ' ' << order;
                }
            }
        }
    }
}

/// Coefficients piece by piece, as the kernel takes them.
std::vector<double> side_by_side(const PiecewiseCubic& curve) {
    std::vector<double> result;
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        for (int k = 0; k < curve.dim(); ++k) {
            for (int power = 0; power < 4; ++power) {
                result.push_back(curve.coefficients(power, k)[i]);
            }
        }
    }
    return result;
}

TEST(CubicEvaluator, GivesTheSameBitsAtEveryLevelOfTheProcessor) {
    using patches::Level;
    for (const int dim : {1, 2, 3}) {
        const PiecewiseCubic piecewise = uneven(dim, 300, 7);
        const std::vector<double> coefficients = side_by_side(piecewise);
        const std::vector<double> end = Curve(piecewise)(piecewise.breaks().back());
        const std::uint32_t first[] = {0, 299};  // one cell
        const cubics::Indexed indexed{end.size(), piecewise.breaks(), coefficients.data(),
                                      end.data(), first, 1, 0};
        std::vector<double> t = parameters(piecewise, 8);
        for (const bool is_sorted : {false, true}) {
            if (is_sorted) std::sort(t.begin(), t.end());
            for (const int order : {0, 1, 2}) {
                std::vector<double> expected(t.size() * static_cast<std::size_t>((order + 1) * dim));
                Curve(piecewise).jets(t, order, expected);
                for (const Level level : {Level::plain, Level::avx2, Level::avx512}) {
                    if (!patches::is_offered(level)) continue;
                    std::vector<double> out(expected.size());
                    cubics::evaluate_at(level, indexed, t, order, out);
                    EXPECT_EQ(out, expected) << dim << ' ' << order << ' ' << static_cast<int>(level);
                }
            }
        }
    }
}

TEST(CubicEvaluator, AllocatesNothing) {
    const PiecewiseCubic cubics = uneven(2, 300, 3);
    const CubicEvaluator evaluator(cubics);
    const std::vector<double> t = parameters(cubics, 4);
    std::vector<double> out(t.size() * 6);
    const long before = allocations;
    evaluator.evaluate(t, 2, out);
    EXPECT_EQ(allocations, before);
}

/// A way that turns by up to 45 degrees a point.
Points gentle_way(std::size_t n, unsigned seed) {
    testing::Random random(seed);
    Points points(n, 2);
    double direction = 0;
    for (std::size_t i = 1; i < n; ++i) {
        direction += random.within(-0.78, 0.78);
        points(i, 0) = points(i - 1, 0) + std::cos(direction);
        points(i, 1) = points(i - 1, 1) + std::sin(direction);
    }
    return points;
}

// Pairs of angles that the tables lack, which only sharp turns make, go to the minimiser: it
// allocates.
TEST(PseudoSpline, OfGentleTurnsAllocatesTheSameForAnyNumberOfPoints) {
    std::vector<long> counts;
    for (const std::size_t n : {100u, 10000u}) {
        const Points points = gentle_way(n, 5);
        std::vector<double> block(8 * n);
        pseudo_spline(points, {}, block);  // unpacks the tables
        const long before = allocations;
        pseudo_spline(points, {}, block);
        counts.push_back(allocations - before);
    }
    EXPECT_EQ(counts[0], counts[1]);
    EXPECT_LE(counts[0], 4);
}

TEST(NaturalSpline, AllocatesNothing) {
    const Points points = gentle_way(2000, 9);
    std::vector<double> breaks(points.size()), block(8 * points.size());
    const long before = allocations;
    natural_spline(points, breaks, block);
    EXPECT_EQ(allocations, before);
}

/// How many blocks of `size` bytes `work` allocates.
template <class Work>
long blocks_of(std::size_t size, Work work) {
    watched_size = size;
    watched = 0;
    work();
    watched_size = 0;
    return watched;
}

TEST(Operations, HoldTheOwnerOfPointsAndMakeNoCopyOfThem) {
    const auto points = std::make_shared<const Points>(gentle_way(2000, 3));
    const std::size_t bytes = points->coordinates().size_bytes();
    const Operation& operation = *find_operation("interpolate");
    PointsInput given;
    given.borrowed = SharedPoints(*points, points);
    std::vector<Input> inputs(1);
    inputs[0].content = std::move(given);
    std::optional<Outcome> outcome;
    const long by_operation =
        blocks_of(bytes, [&] { outcome = operation.run(inputs, {}, Progress()); });
    EXPECT_EQ(by_operation, blocks_of(bytes, [&] { interpolate(*points, {}); }));
    inputs.clear();
    EXPECT_EQ(points.use_count(), 2);
    outcome.reset();
    EXPECT_EQ(points.use_count(), 1);
}

TEST(PseudoSpline, GivesTheSameBitsFromManyThreads) {
    testing::Random random(6);
    const Points points = random.points(300, 2);
    const double alone = pseudo_spline(points).length;
    std::vector<double> lengths(8);
    std::vector<std::thread> threads;
    for (double& length : lengths) {
        threads.emplace_back([&length, &points] { length = pseudo_spline(points).length; });
    }
    for (std::thread& thread : threads) thread.join();
    for (const double length : lengths) EXPECT_EQ(length, alone);
}

}  // namespace cubic_evaluator_law_test
}  // namespace batten
