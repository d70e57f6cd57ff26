#include "make/fit/curve_tally.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit/normals.hpp"

namespace batten::fitting {
namespace {

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
        const int dim = static_cast<int>(parts_.size()) + 1;
        const auto [left, beside] = normals_of(tangent, dim);
        const double a = inner(off, left), b = inner(off, beside);
        const double seen = std::hypot(a, b);
        parts_[0][i] = seen > 0 ? a / seen * size : size;
        if (dim == 3) parts_[1][i] = seen > 0 ? b / seen * size : 0;
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
