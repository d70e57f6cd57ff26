#include "make/fit/isolated.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::fitting {
namespace {

constexpr double least_sigmas = 10;    // no sample of a normal error is there
constexpr double least_contrast = 5;   // against how far neighbours are off each other's lines
constexpr double sigma_of_median = 1.4826;  // of a normal error [Huber1981]

/// How far b is off the line through a and c, as one error of that combination. `u`, `v`: the
/// shares of a and c.
double as_one_error(double off, double u, double v) { return off / std::sqrt(u * u + v * v + 1); }

/// Samples y(x).
class Heights {
public:
    explicit Heights(const Samples& samples) : samples_(samples) {}
    std::size_t size() const { return samples_.size(); }
    bool is_closed() const { return false; }
    double off_line(std::size_t a, std::size_t b, std::size_t c) const {
        const std::span<const double> x = samples_.x, y = samples_.sides[0];
        const double width = x[c] - x[a];
        const double u = width > 0 ? (x[c] - x[b]) / width : 0.5, v = 1 - u;
        return as_one_error(std::fabs(u * y[a] + v * y[c] - y[b]), u, v);
    }

private:
    const Samples& samples_;
};

/// Points in order: distances from the stretch between two of them.
class Sites {
public:
    Sites(PointsView points, Ends ends) : points_(points), ends_(ends) {}
    std::size_t size() const { return points_.size(); }
    bool is_closed() const { return ends_ == Ends::closed; }
    double off_line(std::size_t a, std::size_t b, std::size_t c) const {
        double along = 0, length_sq = 0, off_sq = 0;
        for (int k = 0; k < points_.dim(); ++k) {
            const double d = points_(c, k) - points_(a, k);
            along += d * (points_(b, k) - points_(a, k));
            length_sq += d * d;
        }
        const double v = length_sq > 0 ? std::clamp(along / length_sq, 0.0, 1.0) : 0.5, u = 1 - v;
        for (int k = 0; k < points_.dim(); ++k) {
            const double off = u * points_(a, k) + v * points_(c, k) - points_(b, k);
            off_sq += off * off;
        }
        return as_one_error(std::sqrt(off_sq), u, v);
    }

private:
    PointsView points_;
    Ends ends_;
};

/// Up to three neighbours on each side of i, in order; fewer at the ends of an open row.
template <class Row>
std::vector<std::size_t> neighbours(const Row& row, std::size_t i) {
    std::vector<std::size_t> near;
    const std::size_t n = row.size();
    for (const int step : {-3, -2, -1, 1, 2, 3}) {
        const std::size_t at = i + n + static_cast<std::size_t>(step);
        if (row.is_closed() || (at >= n && at < 2 * n)) near.push_back(at % n);
    }
    return near;
}

template <class Row>
double median_off_line(const Row& row) {
    std::vector<double> all;
    for (std::size_t i = 1; i + 1 < row.size(); ++i) all.push_back(row.off_line(i - 1, i, i + 1));
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return sigma_of_median * *middle;
}

/// The largest of the same among neighbours of i, i itself left out.
template <class Row>
double neighbours_off_line(const Row& row, const std::vector<std::size_t>& near) {
    double largest = 0;
    for (std::size_t k = 1; k + 1 < near.size(); ++k) {
        largest = std::max(largest, row.off_line(near[k - 1], near[k], near[k + 1]));
    }
    return largest;
}

/// `sigma_at` gives an error, or 0 where it is to be estimated.
template <class Row, class SigmaAt>
std::vector<double> factors_of(const Row& row, SigmaAt&& sigma_at) {
    std::vector<double> factors;
    if (row.size() < 7) return factors;
    const double common = sigma_at(0) > 0 ? 0 : median_off_line(row);
    const std::size_t n = row.size(), first = row.is_closed() ? 0 : 1;
    for (std::size_t i = first; i + first < n; ++i) {
        const double off = row.off_line((i + n - 1) % n, i, (i + 1) % n);
        const double sigma = common > 0 ? common : sigma_at(i);
        if (!(off > least_sigmas * sigma)) continue;
        if (!(off > least_contrast * neighbours_off_line(row, neighbours(row, i)))) continue;
        if (factors.empty()) factors.assign(row.size(), 1);
        factors[i] = std::numeric_limits<double>::infinity();
    }
    return factors;
}

}  // namespace

std::vector<double> isolated_factors(const Samples& samples) {
    return factors_of(Heights(samples), [&](std::size_t i) {
        return samples.sigma_known ? samples.sigma_at(i) : 0;
    });
}

std::vector<double> isolated_factors(PointsView points, Ends ends, std::span<const double> sigma) {
    return factors_of(Sites(points, ends),
                      [&](std::size_t i) { return sigma.empty() ? 0 : sigma[i]; });
}

}  // namespace batten::fitting
