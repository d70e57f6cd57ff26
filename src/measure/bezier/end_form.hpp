#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "num/bernstein.hpp"

namespace batten::bezier {

/// The Bernstein coefficients of one coordinate from its derivatives at both ends.
///
/// With Taylor coefficients c_k at the end that coefficient j is counted from, that is
/// sum over k <= j of C(j, k) / C(n, k) c_k [Farouki2012].
class EndForm {
public:
    explicit EndForm(int degree)
        : degree_(static_cast<std::size_t>(degree)),
          position_(weights(degree_)),
          hodograph_(weights(degree_ - 1)) {}

    /// Number of derivatives, value included, that are asked for at each end.
    std::size_t rows() const { return degree_ / 2 + 1; }

    /// Takes the derivatives of coordinate k out of a jet, as Taylor coefficients in u.
    void take(std::span<const double> jet, std::size_t k, double h, bernstein::Coefficients& out) const {
        const std::size_t dim = jet.size() / rows();
        double factor = 1;
        for (std::size_t row = 0; row < rows(); ++row) {
            out[row] = jet[row * dim + k] * factor;
            factor *= h / static_cast<double>(row + 1);
        }
    }

    void write_position(const bernstein::Coefficients& start, const bernstein::Coefficients& end,
                        std::span<double> out) const {
        for (std::size_t j = 0; j <= degree_; ++j) {
            if (2 * j < degree_) out[j] = sum(position_, start, j);
            if (2 * j > degree_) out[j] = sum(position_, end, degree_ - j);
            if (2 * j == degree_) {
                out[j] = 0.5 * (sum(position_, start, j) + sum(position_, end, j));
            }
        }
    }

    /// Not by differences of the positions, which a far origin would spoil. Only an odd number of
    /// coefficients needs one difference, the middle one: so the hodograph sums up to the chord.
    void write_hodograph(const bernstein::Coefficients& start, const bernstein::Coefficients& end,
                         std::span<double> out) const {
        const std::size_t m = degree_ - 1;
        double rest = (end[0] - start[0]) * static_cast<double>(degree_);
        for (std::size_t j = 0; j <= m; ++j) {
            if (2 * j == m) continue;
            out[j] = 2 * j < m ? slope_sum(start, j) : -slope_sum(end, m - j);
            rest -= out[j];
        }
        if (m % 2 == 0) out[m / 2] = rest;
    }

private:
    std::vector<double> weights(std::size_t n) const {
        std::vector<double> result(rows() * rows());
        for (std::size_t j = 0; j < rows() && j <= n; ++j) {
            for (std::size_t k = 0; k <= j; ++k) {
                result[j * rows() + k] = bernstein::binomial(j, k) / bernstein::binomial(n, k);
            }
        }
        return result;
    }

    double sum(const std::vector<double>& weights, const bernstein::Coefficients& c, std::size_t j) const {
        double total = 0;
        for (std::size_t k = j + 1; k-- > 0;) total += weights[j * rows() + k] * c[k];
        return total;
    }
    /// The same of the derivative, whose Taylor coefficients are (k + 1) c_(k + 1).
    double slope_sum(const bernstein::Coefficients& c, std::size_t j) const {
        double total = 0;
        for (std::size_t k = j + 1; k-- > 0;) {
            total += hodograph_[j * rows() + k] * static_cast<double>(k + 1) * c[k + 1];
        }
        return total;
    }

    std::size_t degree_;
    std::vector<double> position_, hodograph_;
};

}  // namespace batten::bezier
