#include "make/fit_surface/cloud.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::surface_fitting {
namespace {

/// Of the largest diagonal: what smoothness weighs. Enough for a regular matrix; its pull on
/// coefficients that the samples determine is taken out by the corrections.
constexpr double faint_weight = 0x1p-36;
constexpr int most_corrections = 6;
constexpr int parts_of_strip = 4;
constexpr double nothing = 1e-20;      // of the largest diagonal
constexpr double small_pivot = 1e-9;   // the same, after elimination

void require_cloud(const ScatteredSamples& given) {
    const std::size_t n = given.x.size();
    if (given.y.size() != n || given.z.size() != n ||
        (!given.sigma.empty() && given.sigma.size() != n)) {
        throw Error("fit-surface.sizes", "samples", std::to_string(n) + " places",
                    "there are as many x, y, heights and errors");
    }
    const struct {
        std::span<const double> values;
        const char* name;
    } columns[] = {{given.x, "x"}, {given.y, "y"}, {given.z, "z"}};
    for (const auto& column : columns) {
        for (std::size_t i = 0; i < n; ++i) {
            if (std::isfinite(column.values[i])) continue;
            throw Error("points.not-finite", std::string("column ") + column.name,
                        format_number(column.values[i]), "coordinates must be finite", {i});
        }
    }
    for (std::size_t i = 0; i < given.sigma.size(); ++i) {
        if (given.sigma[i] > 0) continue;
        throw Error("fit.sigma", "sigma", format_number(given.sigma[i]), "errors must be above 0",
                    {i});
    }
}

Interval range_of_values(std::span<const double> values, const char* name) {
    if (values.size() < 2) {
        throw Error("fit.too-few", "samples", std::to_string(values.size()),
                    "at least two samples are needed");
    }
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    if (*least < *largest) return {*least, *largest};
    throw Error("fit.x-equal", name, format_number(*least), "the places are not all on one line");
}

/// The splines of every sample that are not 0 there.
struct Local {
    std::size_t order;
    std::vector<std::size_t> first;
    std::vector<double> values;

    const double* at(std::size_t i) const { return values.data() + i * order; }
};

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

/// One fit: matrix, factor, corrections.
class CloudSystem {
public:
    CloudSystem(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y)
        : cloud_(cloud), x_(local_splines(x, cloud.x)), y_(local_splines(y, cloud.y)),
          p_(x.size()), q_(y.size()), degree_(x.degree()) {
        gather();
    }

    CloudFit solved() {
        CloudFit fit;
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix());
        fit.solution.coefficients.assign(p_ * q_, 0.0);
        double before = std::numeric_limits<double>::infinity();
        for (int round = 0; round <= most_corrections; ++round) {
            const Eigen::VectorXd step = factor.solve(gradient(fit.solution.coefficients));
            const double size = step.norm();
            if (!(size < 0.5 * before)) break;
            for (std::size_t k = 0; k < p_ * q_; ++k) {
                fit.solution.coefficients[k] += step[static_cast<Eigen::Index>(k)];
            }
            fit.solution.iterations = round;
            before = size;
        }
        find_open(fit, factor.vectorD());
        return fit;
    }

    std::vector<double> weighted_residuals(const std::vector<double>& c) const {
        std::vector<double> e(cloud_.count());
        for (std::size_t n = 0; n < e.size(); ++n) {
            double sum = 0;
            for (std::size_t i = 0; i < x_.order; ++i) {
                const double* const row = c.data() + (x_.first[n] + i) * q_ + y_.first[n];
                double part = 0;
                for (std::size_t j = 0; j < y_.order; ++j) part += row[j] * y_.at(n)[j];
                sum += x_.at(n)[i] * part;
            }
            e[n] = cloud_.weight[n] * (cloud_.z[n] - sum);
        }
        return e;
    }

    /// The rule's measure of the strips of one direction.
    std::vector<double> strips(const std::vector<double>& e, const BSplineBasis& along, bool by_x,
                               StripRule rule) const {
        const std::span<const double> breaks = along.breaks();
        const Local& across = by_x ? y_ : x_;
        const std::size_t functions = rule == StripRule::projected ? (by_x ? q_ : p_) : 1;
        const std::size_t parts = (breaks.size() - 1) * parts_of_strip;
        std::vector<double> sums(parts * functions, 0.0), squares(parts * functions, 0.0);
        for (std::size_t n = 0; n < e.size(); ++n) {
            const double at = by_x ? cloud_.x[n] : cloud_.y[n];
            const std::size_t strip = strip_at(breaks, at);
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

private:
    static std::size_t strip_at(std::span<const double> breaks, double at) {
        const auto inside = breaks.subspan(1, breaks.size() - 2);
        return static_cast<std::size_t>(std::upper_bound(inside.begin(), inside.end(), at) -
                                        inside.begin());
    }

    /// The lower half of A^T W A, neighbours by offset; and A^T W z.
    void gather() {
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

    double diagonal(std::size_t k) const {
        const std::size_t d = static_cast<std::size_t>(degree_);
        return entries_[k * (d + 1) * width_ + d];
    }

    Eigen::SparseMatrix<double> matrix() const {
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
    void add_differences(std::size_t count, std::size_t stride, Add add) const {
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

    Eigen::VectorXd gradient(const std::vector<double>& c) const {
        Eigen::VectorXd g = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p_ * q_));
        const std::vector<double> e = weighted_residuals(c);
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

    void find_open(CloudFit& fit, const Eigen::VectorXd& pivots) const {
        for (std::size_t k = 0; k < p_ * q_; ++k) {
            if (diagonal(k) > nothing * largest_) continue;
            fit.open.push_back({static_cast<int>(k / q_), static_cast<int>(k % q_)});
        }
        std::size_t small = 0;
        for (const double pivot : pivots) small += !(pivot > small_pivot * largest_);
        fit.faint = small > fit.open.size() ? small - fit.open.size() : 0;
    }

    const Cloud& cloud_;
    Local x_, y_;
    std::size_t p_, q_;
    int degree_;
    std::size_t width_ = 0;
    std::vector<double> entries_;
    double largest_ = 0;
};

void measure(const Cloud& cloud, const std::vector<double>& e, Misfit& misfit) {
    Psi beyond{};
    for (std::size_t n = 0; n < e.size(); ++n) {
        const double size = std::fabs(e[n]);
        misfit.delta2 += size * size;
        misfit.max_residual = std::max(misfit.max_residual, size / cloud.weight[n]);
        for (int w = 1; w <= psi_count && size > w; ++w) {
            beyond[static_cast<std::size_t>(w - 1)] += 1;
        }
    }
    const double count = static_cast<double>(e.size());
    for (std::size_t w = 0; w < psi_count; ++w) misfit.psi[w] = (count - beyond[w]) / count;
}

}  // namespace

Cloud prepared_cloud(const ScatteredSamples& given, const FitSurfaceOptions& options) {
    require_cloud(given);
    Cloud cloud{given.x, given.y, given.z, std::vector<double>(given.x.size(), 1.0),
                {range_of_values(given.x, "x"), range_of_values(given.y, "y")}};
    if (!given.sigma.empty()) {
        for (std::size_t i = 0; i < given.sigma.size(); ++i) cloud.weight[i] = 1 / given.sigma[i];
        cloud.source = SigmaSource::column;
        cloud.sigma_known = true;
    } else if (options.sigma) {
        std::fill(cloud.weight.begin(), cloud.weight.end(), 1 / *options.sigma);
        cloud.source = SigmaSource::number;
        cloud.sigma_known = true;
        cloud.sigma = options.sigma;
    } else {
        double largest = 0;
        for (const double z : given.z) largest = std::max(largest, std::fabs(z));
        cloud.least_delta2 = unavoidable_delta2(cloud.count(), direct_accuracy, largest, 1);
    }
    return cloud;
}

CloudFit fit_cloud(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y,
                   StripRule rule) {
    CloudSystem system(cloud, x, y);
    CloudFit fit = system.solved();
    const std::vector<double> e = system.weighted_residuals(fit.solution.coefficients);
    measure(cloud, e, fit.misfit);
    fit.misfit.x_strips = system.strips(e, x, true, rule);
    fit.misfit.y_strips = system.strips(e, y, false, rule);
    return fit;
}

}  // namespace batten::surface_fitting
