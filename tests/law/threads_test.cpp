#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "batten/make/pseudo_spline.hpp"
#include "batten/measure/arc_length_map.hpp"
#include "batten/shape/cubic_evaluator.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace {

using batten::Curve;

/// n pieces around a spiral.
Curve spiral_of_cubics(int n) {
    batten::Points points(2), start(2), end(2);
    std::vector<double> breaks;
    const auto row = [](double t, double scale) {
        return std::vector<double>{scale * t * std::cos(t), scale * t * std::sin(t)};
    };
    const auto slope = [](double t) {
        return std::vector<double>{std::cos(t) - t * std::sin(t), std::sin(t) + t * std::cos(t)};
    };
    for (int i = 0; i <= n; ++i) {
        const double t = 0.25 * i;
        breaks.push_back(t);
        points.push_back(row(t, 1));
        if (i > 0) end.push_back(slope(t));
        if (i < n) start.push_back(slope(t));
    }
    return batten::PiecewiseCubic::hermite(points, start, end, breaks, false);
}

Curve callable_circle() {
    return batten::CallableCurve{
        [](double t, int order, std::span<double> out) {
            for (int k = 0; k <= order; ++k) {
                const double phase = t + k * std::numbers::pi / 2;
                out[2 * k] = std::cos(phase);
                out[2 * k + 1] = std::sin(phase);
            }
        },
        2, {0, 1, 2, 3, 4, 5, 6}, false};
}

std::vector<double> evaluated(const Curve& curve) {
    constexpr int samples = 2000, order = 2;
    const batten::Interval domain = curve.domain();
    std::vector<double> t;
    for (int i = 0; i <= samples; ++i) {
        t.push_back(domain.lo + (domain.hi - domain.lo) * i / samples);
    }
    std::vector<double> out(t.size() * (order + 1) * 2);
    curve.jets(t, order, out);
    for (const double one : t) {
        const batten::Jet jet = curve.jet(one, order);
        out.insert(out.end(), jet.values().begin(), jet.values().end());
    }
    return out;
}

/// Each thread copies the curve, evaluates it and drops the copy.
void expect_same_bits_from_many_threads(const Curve& curve) {
    const std::vector<double> alone = evaluated(curve);
    std::vector<std::vector<double>> results(8);
    std::vector<std::thread> threads;
    for (std::vector<double>& result : results) {
        threads.emplace_back([&result, &curve] {
            const Curve mine = curve;
            result = evaluated(mine);
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::vector<double>& result : results) EXPECT_EQ(result, alone);
}

TEST(OneCurveInManyThreads, GivesTheSameBitsWhenItIsMadeOfCubics) {
    expect_same_bits_from_many_threads(spiral_of_cubics(40));
}

TEST(OneCurveInManyThreads, GivesTheSameBitsWhenItIsTheUsersFunction) {
    expect_same_bits_from_many_threads(callable_circle());
}

TEST(OneCurveInManyThreads, GivesTheSameBitsWhenItIsAPartOfAnother) {
    expect_same_bits_from_many_threads(batten::trimmed(spiral_of_cubics(40), {0.3, 8.1}));
}

TEST(OneArcLengthMapInManyThreads, GivesTheSameBitsAsItsPiecesAreMade) {
    const Curve curve = spiral_of_cubics(40);
    const auto walked = [](const batten::ArcLengthMap& map) {
        std::vector<double> s, t(500);
        for (int i = 0; i < 500; ++i) s.push_back(map.length() * i / 499);
        map.t_of(s, t);
        t.insert(t.end(), map.joints().begin(), map.joints().end());
        return t;
    };
    const std::vector<double> alone = walked(batten::ArcLengthMap(curve));
    const batten::ArcLengthMap shared(curve);
    std::vector<std::vector<double>> results(8);
    std::vector<std::thread> threads;
    for (std::vector<double>& result : results) {
        threads.emplace_back([&result, &shared, &walked] { result = walked(shared); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::vector<double>& result : results) EXPECT_EQ(result, alone);
}

// The tables are unpacked, and the processor asked what it offers, by whoever comes first.
TEST(PseudoSplinesAndOneEvaluatorInManyThreads, GiveTheSameBits) {
    batten::Points points(400, 2);
    double direction = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        direction += 1.7 * std::sin(1.3 * static_cast<double>(i));
        points(i, 0) = points(i - 1, 0) + std::cos(direction);
        points(i, 1) = points(i - 1, 1) + std::sin(direction);
    }
    const Curve spiral = spiral_of_cubics(100);
    const batten::CubicEvaluator evaluator(*spiral.shape<batten::PiecewiseCubic>());
    std::vector<double> t(5000);
    for (std::size_t i = 0; i < t.size(); ++i) {
        t[i] = spiral.domain().hi * static_cast<double>(i) / static_cast<double>(t.size());
    }
    std::vector<double> lengths(8);
    std::vector<std::vector<double>> values(8, std::vector<double>(2 * t.size()));
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        threads.emplace_back([&, k] {
            lengths[k] = batten::pseudo_spline(points).length;
            evaluator.evaluate(t, 0, values[k]);
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t k = 1; k < lengths.size(); ++k) {
        EXPECT_EQ(lengths[k], lengths[0]);
        EXPECT_EQ(values[k], values[0]);
    }
}

}  // namespace
