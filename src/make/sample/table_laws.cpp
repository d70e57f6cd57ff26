#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/motion_law.hpp"
#include "make/interpolate/function.hpp"
#include "num/sum.hpp"

namespace batten {
namespace {

[[noreturn]] void refuse(const char* code, std::size_t row, double value, const char* rule) {
    throw Error(code, "row " + std::to_string(row + 1), format_number(value), rule, {row});
}

/// The interval of rising numbers that holds x: the last one whose start is not above it.
std::size_t interval_of(std::span<const double> rising, double x) {
    const auto inner_end = rising.end() - 1;
    return static_cast<std::size_t>(std::upper_bound(rising.begin() + 1, inner_end, x) -
                                    (rising.begin() + 1));
}

/// Even speed between shares at evenly spaced times.
MotionLaw::Function even_steps(std::vector<double> shares) {
    return [shares = std::move(shares)](double tau) -> MotionState {
        const double steps = static_cast<double>(shares.size() - 1);
        const double place = tau * steps, nearest = std::round(place);
        // k / steps x steps may miss k by an ulp; the times of samples are such numbers.
        const bool is_at_step = std::fabs(place - nearest) <= 0x1p-51 * nearest;
        const double floor = is_at_step ? nearest : std::floor(place);
        const std::size_t i = std::min(static_cast<std::size_t>(floor), shares.size() - 2);
        const double inside = is_at_step ? floor - static_cast<double>(i)
                                         : place - static_cast<double>(i);
        const double step = shares[i + 1] - shares[i];
        return {inside >= 1 ? shares[i + 1] : shares[i] + step * inside, step * steps};
    };
}

std::vector<double> scaled_by_largest(std::vector<double> weights) {
    double largest = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] >= 0) || !std::isfinite(weights[i])) {
            refuse("motion.weights", i, weights[i], "weights must be finite and not negative");
        }
        largest = std::fmax(largest, weights[i]);
    }
    if (largest == 0) {
        throw Error("motion.weights", "weights", "0", "at least one weight must be above 0");
    }
    for (double& weight : weights) weight /= largest;
    return weights;
}

}  // namespace

MotionLaw MotionLaw::steps(std::span<const double> weights) {
    const std::vector<double> scaled = scaled_by_largest({weights.begin(), weights.end()});
    std::vector<double> shares{0};
    num::Sum sum;
    for (const double weight : scaled) {
        sum.add(weight);
        shares.push_back(sum.value());
    }
    const double total = shares.back();
    for (double& share : shares) share /= total;
    return {even_steps(std::move(shares)), Trusted{}};
}

MotionLaw MotionLaw::positions(std::span<const double> shares) {
    if (shares.size() < 2) {
        throw Error("motion.positions", "positions", std::to_string(shares.size()),
                    "two or more are needed");
    }
    double before = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (!(shares[i] >= before && shares[i] <= 1)) {
            refuse("motion.positions", i, shares[i], "must lie on the curve and not fall");
        }
        before = shares[i];
    }
    return {even_steps({shares.begin(), shares.end()}), Trusted{}};
}

MotionLaw MotionLaw::keyframes(PointsView rows) {
    if (rows.size() < 2 || rows.dim() != 2) {
        throw Error("motion.keys", "keys", std::to_string(rows.size()),
                    "two or more rows of a time and a place are needed");
    }
    double before = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool is_later = i == 0 || rows(i, 0) > rows(i - 1, 0);
        if (!is_later || !std::isfinite(rows(i, 0))) {
            refuse("motion.keys", i, rows(i, 0), "times must be finite and increase");
        }
        if (!(rows(i, 1) >= before && rows(i, 1) <= 1)) {
            refuse("motion.keys", i, rows(i, 1), "places must lie on the curve and not fall");
        }
        before = rows(i, 1);
    }
    const double start = rows(0, 0), duration = rows(rows.size() - 1, 0) - start;
    Points shares(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) shares(i, 0) = (rows(i, 0) - start) / duration;
    return {[curve = interpolation::pchip_curve(shares)](double tau) -> MotionState {
                double jet[4];
                curve.jets_on(interval_of(curve.breaks(), tau), {&tau, 1}, 1, jet);
                return {jet[1], std::fmax(jet[3], 0)};
            },
            Trusted{}};
}

MotionLaw MotionLaw::weighted(PointsView rows) {
    if (rows.size() < 2 || rows.dim() != 2) {
        throw Error("motion.weights", "weights", std::to_string(rows.size()),
                    "two or more rows of a place and a weight are needed");
    }
    std::vector<double> places, weights;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool is_end = i == 0 || i + 1 == rows.size();
        const bool is_placed = is_end ? rows(i, 0) == (i == 0 ? 0.0 : 1.0)
                                      : rows(i, 0) > rows(i - 1, 0) && rows(i, 0) < 1;
        if (!is_placed) {
            refuse("motion.weights", i, rows(i, 0), "places must increase from start to end");
        }
        places.push_back(rows(i, 0));
        weights.push_back(rows(i, 1));
    }
    weights = scaled_by_largest(std::move(weights));
    std::vector<double> times{0};
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double mean = 0.5 * (weights[i] + weights[i + 1]);
        times.push_back(times[i] + mean * (places[i + 1] - places[i]));
    }
    return {[places, weights, times](double tau) -> MotionState {
                const double time = tau * times.back();
                const std::size_t i = interval_of(times, time);
                const double step = places[i + 1] - places[i];
                const double w = weights[i], slope = (weights[i + 1] - w) / step;
                // w u + slope u^2 / 2 = rest, without cancellation.
                const double rest = time - times[i];
                const double here = std::sqrt(std::fmax(w * w + 2 * slope * rest, 0));
                const double u = rest == 0 ? 0 : std::fmin(2 * rest / (w + here), step);
                const double least = 0x1p-40 * times.back();
                return {tau >= 1 ? places.back() : places[i] + u,
                        times.back() / std::fmax(here, least)};
            },
            Trusted{}};
}

}  // namespace batten
