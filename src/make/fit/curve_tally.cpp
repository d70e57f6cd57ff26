#include "make/fit/curve_tally.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace batten::fitting {
namespace {

using Vector = std::array<double, 3>;

double inner(const Vector& a, const Vector& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Two directions across a tangent, of its length; the second one is the axis of a plane curve.
std::array<Vector, 2> across(const Vector& tangent, bool is_plane) {
    std::size_t smallest = 2;
    for (std::size_t i = 0; i < 2 && !is_plane; ++i) {
        if (std::fabs(tangent[i]) < std::fabs(tangent[smallest])) smallest = i;
    }
    Vector axis{};
    axis[smallest] = 1;
    const Vector first = cross(axis, tangent);
    Vector second = cross(tangent, first);
    const double size = std::sqrt(inner(second, second) / std::max(inner(first, first), 1e-300));
    for (double& x : second) x /= size > 0 ? size : 1;
    return {first, second};
}

class Distances {
public:
    Distances(const Samples& samples, std::span<const SplineFunction> curve) {
        parts_.assign(samples.directions(), std::vector<double>(samples.size()));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            Vector off{}, tangent{};
            for (std::size_t s = 0; s < curve.size(); ++s) {
                off[s] = samples.sides[s][i] - curve[s](samples.x[i]);
                tangent[s] = samples.are_feet ? curve[s](samples.x[i], 1) : 0;
            }
            const double size = std::sqrt(inner(off, off));
            largest_ = std::max(largest_, size);
            if (samples.are_feet) {
                add_across(i, off, tangent, size);
            } else {
                for (std::size_t d = 0; d < parts_.size(); ++d) parts_[d][i] = off[d];
            }
        }
    }

    const std::vector<std::vector<double>>& parts() const { return parts_; }
    double largest() const { return largest_; }

private:
    /// All of the distance counts across, also at ends, where points lie beyond the curve.
    void add_across(std::size_t i, const Vector& off, const Vector& tangent, double size) {
        const bool is_plane = parts_.size() == 1;
        const std::array<Vector, 2> normals = across(tangent, is_plane);
        if (is_plane) {
            parts_[0][i] = std::copysign(size, inner(off, normals[0]));
            return;
        }
        const double a = inner(off, normals[0]), b = inner(off, normals[1]);
        const double seen = std::hypot(a, b);
        parts_[0][i] = seen > 0 ? a / seen * size : size;
        parts_[1][i] = seen > 0 ? b / seen * size : 0;
    }

    std::vector<std::vector<double>> parts_;
    double largest_ = 0;
};

}  // namespace

ResidualTally curve_tally(const Samples& samples, std::span<const SplineFunction> curve) {
    const Distances distances(samples, curve);
    ResidualTally all;
    for (const std::vector<double>& part : distances.parts()) {
        const ResidualTally one = tally(samples, part);
        all.delta2 += one.delta2;
        for (std::size_t w = 0; w < all.psi.size(); ++w) {
            all.psi[w] += one.psi[w] / static_cast<double>(distances.parts().size());
        }
        all.runs += one.runs;
        all.positive += one.positive;
    }
    all.max_residual = distances.largest();
    return all;
}

}  // namespace batten::fitting
