#include "make/fit_surface/axes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten::surface_fitting {
namespace {

/// f(t1) against the line through its neighbours, over the norm of this functional.
std::array<double, 3> second_difference(double t0, double t1, double t2) {
    const double left = (t2 - t1) / (t2 - t0);
    const double right = 1 - left;
    const double norm = std::sqrt(1 + left * left + right * right);
    return {-left / norm, 1 / norm, -right / norm};
}

void require_inside(std::span<const double> lines, Interval domain, const char* name) {
    for (const double line : lines) {
        if (domain.contains(line)) continue;
        throw Error("fit.outside", name, format_number(line), "must lie in the knots' domain");
    }
}

/// A height that is none spoils the sum; only then it is looked for.
void require_finite_rows(std::span<const double> z, std::size_t columns) {
    double lanes[8] = {};
    const std::size_t whole = z.size() / 8 * 8;
    for (std::size_t k = 0; k < whole; k += 8) {
        for (std::size_t l = 0; l < 8; ++l) lanes[l] += 0 * z[k + l];
    }
    for (std::size_t k = whole; k < z.size(); ++k) lanes[0] += 0 * z[k];
    double sum = 0;
    for (const double lane : lanes) sum += lane;
    if (sum == 0) return;
    const auto bad = std::find_if(z.begin(), z.end(), [](double h) { return !std::isfinite(h); });
    const std::size_t at = static_cast<std::size_t>(bad - z.begin());
    throw Error("points.not-finite",
                "node " + std::to_string(at / columns) + ',' + std::to_string(at % columns),
                format_number(*bad), "heights must be finite");
}

}  // namespace

void require_rising(std::span<const double> lines, const char* name) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string place = std::string(name) + ' ' + std::to_string(i);
        if (!std::isfinite(lines[i])) {
            throw Error("points.not-finite", place, format_number(lines[i]),
                        "coordinates must be finite", {i});
        }
        if (i > 0 && !(lines[i - 1] < lines[i])) {
            throw Error("fit-surface.axis", place, format_number(lines[i]),
                        "the lines of a grid must rise");
        }
    }
}

void require_errors(std::span<const double> sigma, std::size_t count, const char* name) {
    if (sigma.empty()) return;
    if (sigma.size() != count) {
        throw Error("fit-surface.sizes", name, std::to_string(sigma.size()),
                    std::to_string(count) + " errors are needed");
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (sigma[i] > 0) continue;
        throw Error("fit.sigma", std::string(name) + ' ' + std::to_string(i),
                    format_number(sigma[i]), "errors must be above 0");
    }
}

void require_columns(const SurfaceColumns& columns, const BSplineBasis& y) {
    require_rising(columns.y, "y");
    require_errors(columns.y_sigma, columns.y.size(), "y_sigma");
    require_inside(columns.y, y.domain(), "y");
    if (columns.y.size() >= 2) return;
    throw Error("fit-surface.axis", "y", std::to_string(columns.y.size()),
                "a grid has at least two lines in each direction");
}

void require_rows(const SurfaceRows& rows, const SurfaceColumns& columns, const BSplineBasis& x,
                  double sigma) {
    require_rising(rows.x, "x");
    require_inside(rows.x, x.domain(), "x");
    require_errors(rows.x_sigma, rows.x.size(), "x_sigma");
    require_errors({&sigma, 1}, 1, "sigma");
    if (rows.z.size() != rows.x.size() * columns.y.size()) {
        throw Error("fit-surface.sizes", "z", std::to_string(rows.z.size()),
                    std::to_string(rows.x.size()) + " whole rows of " +
                        std::to_string(columns.y.size()) + " heights are needed");
    }
    require_finite_rows(rows.z, columns.y.size());
}

std::vector<double> weights_of(std::span<const double> sigma, std::size_t count) {
    std::vector<double> weights(count, 1.0);
    for (std::size_t i = 0; i < sigma.size(); ++i) weights[i] = 1 / sigma[i];
    return weights;
}

void NoiseOfRows::add(double x, std::span<const double> z) {
    if (x_.size() == 2) {
        const std::array<double, 3> a = second_difference(x_[0], x_[1], x);
        std::array<double, 3> across{};  // of the last three columns
        for (std::size_t s = 0; s < y_.size(); ++s) {
            across = {across[1], across[2], a[0] * z_[0][s] + a[1] * z_[1][s] + a[2] * z[s]};
            if (s < 2) continue;
            const std::array<double, 3> b = second_difference(y_[s - 2], y_[s - 1], y_[s]);
            const double value = b[0] * across[0] + b[1] * across[1] + b[2] * across[2];
            sum_ += value * value;
            ++count_;
        }
        x_.erase(x_.begin());
        std::swap(z_[0], z_[1]);
        z_.pop_back();
    }
    x_.push_back(x);
    z_.emplace_back(z.begin(), z.end());
}

double NoiseOfRows::sigma() const {
    return count_ == 0 ? 0 : std::sqrt(sum_ / static_cast<double>(count_));
}

}  // namespace batten::surface_fitting
