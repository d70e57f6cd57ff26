#include "make/fit_surface/cloud_system.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit_surface/axis.hpp"
#include "num/cox_de_boor.hpp"
#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

/// Of the largest diagonal: what smoothness weighs. Enough for a regular matrix; its pull on
/// coefficients that the samples determine is taken out afterwards.
constexpr double faint_weight = 0x1p-36;
constexpr int most_corrections = 100;
/// Of delta2: what the coefficients may still take from it, where steps end and at most.
constexpr double small_energy = 1e-22;
constexpr double fair_energy = 1e-10;
/// Steps without a gain: rounding is all that is left.
constexpr int patience = 5;
constexpr int parts_of_strip = 4;
constexpr double nothing = 1e-20;      // of the largest diagonal
constexpr double small_pivot = 1e-9;   // the same, after elimination

void add(double factor, const Eigen::VectorXd& what, std::vector<double>& to) {
    for (std::size_t k = 0; k < to.size(); ++k) {
        to[k] += factor * what[static_cast<Eigen::Index>(k)];
    }
}

}  // namespace

Local local_splines(const BSplineBasis& basis, std::span<const double> places) {
    Local local{static_cast<std::size_t>(basis.degree()) + 1, {}, {}};
    local.first.resize(places.size());
    local.values.resize(places.size() * local.order);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t span = basis.span_of(places[i]);
        local.first[i] = span + 1 - local.order;
        num::basis_values(basis.knots(), span, static_cast<int>(local.order), places[i],
                          local.values.data() + i * local.order);
    }
    return local;
}

CloudSystem::CloudSystem(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y)
    : cloud_(cloud), x_(local_splines(x, cloud.x)), y_(local_splines(y, cloud.y)), p_(x.size()),
      q_(y.size()), degree_(x.degree()) {
    gather();
}

/// Smoothness pulls on what few samples determine: conjugate gradients without it, from the smooth
/// solution on and preconditioned by it, leave alone what no sample sees.
CloudFit CloudSystem::solved() {
    CloudFit fit;
    factor_ = std::make_unique<Factor>(matrix());
    std::vector<double> c(p_ * q_, 0.0);
    add(1, factor_->solve(gradient(weighted_residuals(c))), c);
    std::vector<double> e = weighted_residuals(c);
    Eigen::VectorXd rest = gradient(e), direction = factor_->solve(rest);
    double energy = rest.dot(direction), least = energy;
    fit.solution.coefficients = c;
    int since_best = 0;
    for (int round = 1; round <= most_corrections && since_best < patience; ++round) {
        const double curvature = num::sum_of_squares(weighted_values(direction));
        if (!(energy > small_energy * num::sum_of_squares(e)) || !(curvature > 0)) break;
        add(energy / curvature, direction, c);
        e = weighted_residuals(c);
        rest = gradient(e);
        const Eigen::VectorXd step = factor_->solve(rest);
        const double fresh = rest.dot(step);
        direction = step + fresh / energy * direction;
        energy = fresh;
        ++since_best;
        if (!(energy < least)) continue;
        since_best = 0;
        least = energy;
        fit.solution.coefficients = c;
        fit.solution.iterations = round;
    }
    fit.solution.is_converged = !(least > fair_energy * num::sum_of_squares(e));
    find_open(fit, factor_->vectorD());
    return fit;
}

template <class Coefficients>
double CloudSystem::height(std::size_t n, const Coefficients& c) const {
    double sum = 0;
    for (std::size_t i = 0; i < x_.order; ++i) {
        const double* const row = c.data() + (x_.first[n] + i) * q_ + y_.first[n];
        double part = 0;
        for (std::size_t j = 0; j < y_.order; ++j) part += row[j] * y_.at(n)[j];
        sum += x_.at(n)[i] * part;
    }
    return sum;
}

std::vector<double> CloudSystem::weighted_values(const Eigen::VectorXd& c) const {
    std::vector<double> values(cloud_.count());
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = cloud_.weight[n] * height(n, c);
    return values;
}

std::vector<double> CloudSystem::weighted_residuals(const std::vector<double>& c) const {
    std::vector<double> e(cloud_.count());
    for (std::size_t n = 0; n < e.size(); ++n) {
        e[n] = cloud_.weight[n] * (cloud_.z[n] - height(n, c));
    }
    return e;
}

/// The rule's measure of the strips of one direction.
std::vector<double> CloudSystem::strips(const std::vector<double>& e,
                                        const BSplineBasis& along, bool by_x,
                                        StripRule rule) const {
    const std::span<const double> breaks = along.breaks();
    const Local& across = by_x ? y_ : x_;
    const std::size_t functions = rule == StripRule::projected ? (by_x ? q_ : p_) : 1;
    const std::size_t parts = (breaks.size() - 1) * parts_of_strip;
    std::vector<double> sums(parts * functions, 0.0), squares(parts * functions, 0.0);
    for (std::size_t n = 0; n < e.size(); ++n) {
        const double at = by_x ? cloud_.x[n] : cloud_.y[n];
        const std::size_t strip = strip_of(along, at);
        const double share = (at - breaks[strip]) / (breaks[strip + 1] - breaks[strip]);
        const std::size_t part = std::min<std::size_t>(
            parts_of_strip - 1, static_cast<std::size_t>(share * parts_of_strip));
        const std::size_t row = (strip * parts_of_strip + part) * functions;
        const std::size_t terms = rule == StripRule::projected ? across.order : 1;
        for (std::size_t j = 0; j < terms; ++j) {
            const std::size_t to =
                row + (rule == StripRule::projected ? across.first[n] + j : 0);
            const double value = rule == StripRule::projected
                                     ? cloud_.weight[n] * across.at(n)[j]
                                     : 1;
            sums[to] += value * e[n];
            squares[to] += value * value;
        }
    }
    std::vector<double> measure(breaks.size() - 1, 0.0);
    for (std::size_t k = 0; k < sums.size(); ++k) {
        if (squares[k] > 0) {
            measure[k / functions / parts_of_strip] +=
                sums[k] * sums[k] / squares[k] / static_cast<double>(functions);
        }
    }
    return measure;
}

/// The lower half of A^T W A, neighbours by offset; and A^T W z.
void CloudSystem::gather() {
    width_ = 2 * static_cast<std::size_t>(degree_) + 1;
    entries_.assign(p_ * q_ * (static_cast<std::size_t>(degree_) + 1) * width_, 0.0);
    const std::size_t d = static_cast<std::size_t>(degree_);
    for (std::size_t n = 0; n < cloud_.count(); ++n) {
        const double weight_sq = cloud_.weight[n] * cloud_.weight[n];
        for (std::size_t i = 0; i <= d; ++i) {
            for (std::size_t j = 0; j <= d; ++j) {
                const double value = weight_sq * x_.at(n)[i] * y_.at(n)[j];
                double* const row = entries_.data() +
                                    ((x_.first[n] + i) * q_ + y_.first[n] + j) * (d + 1) * width_;
                for (std::size_t k = 0; k <= i; ++k) {
                    const double factor = value * x_.at(n)[k];
                    double* const to = row + (i - k) * width_ + d - j;
                    for (std::size_t l = 0; l <= d; ++l) to[l] += factor * y_.at(n)[l];
                }
            }
        }
    }
    largest_ = 0;
    for (std::size_t k = 0; k < p_ * q_; ++k) largest_ = std::max(largest_, diagonal(k));
}

double CloudSystem::diagonal(std::size_t k) const {
    const std::size_t d = static_cast<std::size_t>(degree_);
    return entries_[k * (d + 1) * width_ + d];
}

Eigen::SparseMatrix<double> CloudSystem::matrix() const {
    using Triplet = Eigen::Triplet<double>;
    std::vector<Triplet> triplets;
    const std::size_t d = static_cast<std::size_t>(degree_);
    const auto add = [&](std::size_t row, std::size_t column, double value) {
        if (column <= row && value != 0) {
            triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
        }
    };
    for (std::size_t k = 0; k < p_ * q_; ++k) {
        const std::size_t i = k / q_, j = k % q_;
        for (std::size_t di = 0; di <= std::min(d, i); ++di) {
            for (std::size_t l = 0; l < width_; ++l) {
                if (j + l < d || j + l - d >= q_) continue;
                add(k, (i - di) * q_ + j + l - d,
                    entries_[(k * (d + 1) + di) * width_ + l]);
            }
        }
    }
    add_differences(p_, q_, add);
    add_differences(q_, 1, add);
    const int size = static_cast<int>(p_ * q_);
    Eigen::SparseMatrix<double> result(size, size);
    result.setFromTriplets(triplets.begin(), triplets.end());
    return result;
}

/// Faint squared differences of order 2 (1 where there are but two) between coefficients
/// `stride` apart, `count` in a row.
template <class Add>
void CloudSystem::add_differences(std::size_t count, std::size_t stride, Add add) const {
    const std::vector<double> d = count > 2 ? std::vector<double>{1, -2, 1}
                                            : std::vector<double>{1, -1};
    const double weight = faint_weight * largest_;
    const std::size_t rows = p_ * q_ / count;
    for (std::size_t r = 0; r < rows; ++r) {
        const std::size_t start = stride == 1 ? r * count : r;
        for (std::size_t i = 0; i + d.size() <= count; ++i) {
            for (std::size_t a = 0; a < d.size(); ++a) {
                for (std::size_t b = 0; b <= a; ++b) {
                    add(start + (i + a) * stride, start + (i + b) * stride,
                        weight * d[a] * d[b]);
                }
            }
        }
    }
}

Eigen::VectorXd CloudSystem::gradient(const std::vector<double>& e) const {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p_ * q_));
    for (std::size_t n = 0; n < e.size(); ++n) {
        for (std::size_t i = 0; i < x_.order; ++i) {
            const double factor = cloud_.weight[n] * e[n] * x_.at(n)[i];
            for (std::size_t j = 0; j < y_.order; ++j) {
                g[static_cast<Eigen::Index>((x_.first[n] + i) * q_ + y_.first[n] + j)] +=
                    factor * y_.at(n)[j];
            }
        }
    }
    return g;
}

void CloudSystem::find_open(CloudFit& fit, const Eigen::VectorXd& pivots) const {
    for (std::size_t k = 0; k < p_ * q_; ++k) {
        if (diagonal(k) > nothing * largest_) continue;
        fit.open.push_back({static_cast<int>(k / q_), static_cast<int>(k % q_)});
    }
    std::size_t small = 0;
    for (const double pivot : pivots) small += !(pivot > small_pivot * largest_);
    fit.faint = small > fit.open.size() ? small - fit.open.size() : 0;
}

}  // namespace batten::surface_fitting
