#include "make/fit_surface/mixed_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

/// f(middle) against the line through its neighbours, over the norm of this functional.
std::array<double, 3> second_difference(std::span<const double> t, std::size_t middle) {
    const double gap = t[middle + 1] - t[middle - 1];
    const double left = (t[middle + 1] - t[middle]) / gap;
    const double right = 1 - left;
    const double norm = std::sqrt(1 + left * left + right * right);
    return {-left / norm, 1 / norm, -right / norm};
}

}  // namespace

MixedNoise::MixedNoise(std::span<const double> y) : across_(y.size()) {
    for (std::size_t s = 1; s + 1 < y.size(); ++s) columns_.push_back(second_difference(y, s));
    values_.resize(columns_.size());
}

void MixedNoise::add(std::span<const double> x, std::span<const double> rows) {
    std::fill(across_.begin(), across_.end(), 0.0);
    num::add_combination(second_difference(x, 1), rows, across_);
    for (std::size_t s = 0; s < columns_.size(); ++s) {
        const std::array<double, 3>& b = columns_[s];
        values_[s] = b[0] * across_[s] + b[1] * across_[s + 1] + b[2] * across_[s + 2];
    }
    const double sum_sq = num::sum_of_squares(values_);
    if (!std::isnan(sum_sq)) {
        sum_sq_ += sum_sq;
        count_ += values_.size();
        return;
    }
    for (const double value : values_) {
        if (std::isnan(value)) continue;
        sum_sq_ += value * value;
        ++count_;
    }
}

double MixedNoise::sigma() const {
    return count_ == 0 ? 0 : std::sqrt(sum_sq_ / static_cast<double>(count_));
}

void MixedNoiseOfRows::add(double x, std::span<const double> z) {
    if (x_.size() == 3) {
        x_.erase(x_.begin());
        rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(z.size()));
    }
    x_.push_back(x);
    rows_.insert(rows_.end(), z.begin(), z.end());
    if (x_.size() == 3) noise_.add(x_, rows_);
}

double usable_noise(double noise, double largest) {
    const double least = std::max(noise, std::numeric_limits<double>::epsilon() * largest);
    return least > 0 ? least : 1;
}

double unavoidable_delta2(std::size_t count, double accuracy, double largest, double sigma) {
    const double lost = accuracy * largest / sigma;
    return static_cast<double>(count) * lost * lost;
}

double mixed_noise(const SurfaceSamples& given) {
    MixedNoiseOfRows noise(given.y);
    std::vector<double> row;
    for (std::size_t r = 0; r < given.x.size(); ++r) {
        const std::span<const double> z =
            given.z.values().subspan(r * given.y.size(), given.y.size());
        if (!given.z.has_mask()) {
            noise.add(given.x[r], z);
            continue;
        }
        row.assign(z.begin(), z.end());
        for (std::size_t s = 0; s < row.size(); ++s) {
            if (!given.z.has(r, s)) row[s] = std::numeric_limits<double>::quiet_NaN();
        }
        noise.add(given.x[r], row);
    }
    return noise.sigma();
}

}  // namespace batten::surface_fitting
