#include "make/fit/smooth_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace batten::fitting {
namespace {

/// Weight of differences beside equations of length 1: its square is at rounding.
constexpr double lightly = 1e-8;

}  // namespace

SmoothEquations::SmoothEquations(int functions, Ends ends, TriangleShape shape)
    : functions_(functions) {
    const int width = shape.order + 1;
    const int border = ends == Ends::closed ? std::min(shape.order, functions) : 0;
    shape_ = functions - border < width
                 ? num::BandShape{0, 0, functions, shape.sides}
                 : num::BandShape{width, functions - border, border, shape.sides};
}

/// `lowest`: the first of its coefficients that is not of the border.
void SmoothEquations::begin(int lowest) {
    const int last = std::max(0, shape_.columns - shape_.width);
    starts_.push_back(std::clamp(lowest - shape_.border, 0, last));
    entries_.resize(entries_.size() + row_width(), 0.0);
}

std::size_t SmoothEquations::at(int start, int function) const {
    const int f = function % functions_;
    return static_cast<std::size_t>(f < shape_.border ? shape_.width + f
                                                      : f - shape_.border - start);
}

double& SmoothEquations::entry(int function) {
    return entries_[entries_.size() - row_width() + at(starts_.back(), function)];
}

void SmoothEquations::add_triangle(const KnotSystem& system) {
    const num::BandedQr& qr = system.qr();
    const num::BandShape& from = qr.shape();
    for (int j = 0; j < from.columns; ++j) {
        const double* const r = qr.row(j);
        if (r[0] == 0) continue;
        begin(j + from.border);
        for (int l = 0; l < from.width && j + l < from.columns; ++l) {
            entry(j + l + from.border) = r[l];
        }
        for (int b = 0; b < from.border; ++b) entry(b) = r[from.width + b];
        scale_to_one(r + from.width + from.border);
    }
    for (int j = 0; j < from.border; ++j) {
        const double* const r = qr.border_row(j);
        if (r[j] == 0) continue;
        begin(functions_);
        for (int b = j; b < from.border; ++b) entry(b) = r[b];
        scale_to_one(r + from.border);
    }
    data_ = starts_.size();
}

void SmoothEquations::scale_to_one(const double* sides) {
    const std::span<double> last = row(starts_.size() - 1);
    std::copy_n(sides, shape_.sides, last.begin() + static_cast<std::ptrdiff_t>(reach()));
    double sum = 0;
    for (const double x : last.first(reach())) sum += x * x;
    lengths_.push_back(std::sqrt(sum));
    for (double& x : last) x /= lengths_.back();
}

void SmoothEquations::add_differences(int order, Ends ends) {
    const int count = ends == Ends::closed ? functions_ : functions_ - order;
    for (int first = 0; first < count; ++first) {
        begin(first);
        double choose = lightly;
        for (int j = 0; j <= order; ++j) {
            entry(first + j) += j % 2 == 0 ? choose : -choose;
            choose = choose * (order - j) / (j + 1);
        }
    }
}

num::BandedQr SmoothEquations::reduced(std::span<const double> scales) const {
    std::vector<std::size_t> order(starts_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return starts_[a] < starts_[b]; });
    num::BandedQr qr(shape_);
    std::vector<double> row(row_width());
    for (const std::size_t i : order) {
        for (std::size_t j = 0; j < row.size(); ++j) {
            row[j] = scales[i] * entries_[i * row_width() + j];
        }
        qr.absorb(starts_[i], row.data(), 1);
    }
    qr.finish();
    return qr;
}

std::vector<double> SmoothEquations::solved() const {
    const num::BandedQr qr = reduced(std::vector<double>(starts_.size(), 1.0));
    const std::size_t p = static_cast<std::size_t>(functions_);
    std::vector<double> c(p * static_cast<std::size_t>(shape_.sides)), raw(p);
    for (int s = 0; s < shape_.sides; ++s) {
        qr.solve(s, raw);
        for (int j = 0; j < functions_; ++j) {
            const int u = j < shape_.border ? shape_.columns + j : j - shape_.border;
            c[static_cast<std::size_t>(s) * p + static_cast<std::size_t>(j)] =
                raw[static_cast<std::size_t>(u)];
        }
    }
    return c;
}

/// Leaves of the data's right-hand sides what `coefficients` do not reach.
void SmoothEquations::subtract(std::span<const double> coefficients) {
    const std::size_t p = static_cast<std::size_t>(functions_);
    for (std::size_t i = 0; i < data_; ++i) {
        const std::span<double> equation = row(i);
        for (int s = 0; s < shape_.sides; ++s) {
            const std::span<const double> c =
                coefficients.subspan(static_cast<std::size_t>(s) * p, p);
            double& side = equation[reach() + static_cast<std::size_t>(s)];
            for (int l = 0; l < shape_.width; ++l) {
                side -= equation[static_cast<std::size_t>(l)] *
                        c[static_cast<std::size_t>(shape_.border + starts_[i] + l)];
            }
            for (int b = 0; b < shape_.border; ++b) {
                side -= equation[static_cast<std::size_t>(shape_.width + b)] *
                        c[static_cast<std::size_t>(b)];
            }
        }
    }
}

std::vector<double> SmoothEquations::solution() {
    std::vector<double> c = solved();
    // What the differences' weight took away comes back as its square: iterated regularisation goes
    // to the solution of the smallest differences [EnglHankeNeubauer1996, 5.1].
    subtract(c);
    const std::vector<double> rest = solved();
    for (std::size_t j = 0; j < c.size(); ++j) c[j] += rest[j];
    return c;
}

num::BandedQr SmoothEquations::triangle() const {
    const double least = *std::min_element(lengths_.begin(), lengths_.end());
    std::vector<double> scales(lengths_.begin(), lengths_.end());
    scales.resize(starts_.size(), least);
    return reduced(scales);
}

}  // namespace batten::fitting
