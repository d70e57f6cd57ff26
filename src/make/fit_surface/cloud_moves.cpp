#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fit_surface/cloud_system.hpp"
#include "make/fit_surface/moved_lines.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::surface_fitting {
namespace {

/// Lines, the best coefficients for them, what they leave of the samples.
struct CloudState {
    KnotPair knots;
    std::unique_ptr<CloudSystem> system;
    std::vector<double> c, e;
    std::size_t loose = 0;  ///< coefficients that samples do not determine
    double delta2 = std::numeric_limits<double>::infinity();
};

CloudState cloud_state(const Cloud& cloud, KnotPair knots, int degree) {
    CloudState state;
    const BSplineBasis x(knots[0], degree), y(knots[1], degree);
    state.knots = std::move(knots);
    state.system = std::make_unique<CloudSystem>(cloud, x, y);
    CloudFit fit = state.system->solved();
    state.c = std::move(fit.solution.coefficients);
    state.loose = fit.open.size() + fit.faint;
    state.e = state.system->weighted_residuals(state.c);
    state.delta2 = 0;
    for (const double e : state.e) state.delta2 += e * e;
    return state;
}

/// dS/dt_l = sum of order splines M_i, over knots with t_l once more, times rows of splines across.
struct LineSlope {
    std::size_t knot;
    std::vector<double> fine;
    std::vector<double> rows;  ///< order x functions across
};

/// One direction: the slopes by all of its lines that move.
class SideSlopes {
public:
    SideSlopes(const std::vector<double>& knots, int degree, std::size_t first_column)
        : t_(knots), order_(static_cast<std::size_t>(degree) + 1), first_column_(first_column) {
        for (const std::size_t l : simple_knots(t_, degree)) {
            std::vector<double> fine = t_;
            fine.insert(fine.begin() + static_cast<std::ptrdiff_t>(l), t_[l]);
            slopes_.push_back({l, std::move(fine), {}});
        }
    }

    std::size_t count() const { return slopes_.size(); }
    std::size_t knot(std::size_t i) const { return slopes_[i].knot; }

    /// `at(i, j)`: the coefficient of function i along and j across, of `across` ones.
    template <class At>
    void take(std::size_t across, At at) {
        across_ = across;
        for (LineSlope& slope : slopes_) {
            const std::size_t l = slope.knot;
            for (std::size_t i = l + 1 - order_; i <= l; ++i) {
                const double width = t_[i + order_ - 1] - t_[i];
                for (std::size_t j = 0; j < across; ++j) {
                    slope.rows.push_back((at(i - 1, j) - at(i, j)) / width);
                }
            }
        }
    }

    /// Calls visit(column, slope) for all lines with one at a sample: its place along, the first of
    /// its splines there, and its splines across with their first.
    struct Sample {
        double place;
        std::size_t first_along, first_across;
        const double* across;
    };
    template <class Visit>
    void for_slopes(const Sample& at, Visit visit) const {
        const std::size_t span = at.first_along + order_ - 1;
        double values[num::most_order];
        for (std::size_t k = 0; k < slopes_.size(); ++k) {
            const LineSlope& slope = slopes_[k];
            const std::size_t l = slope.knot;
            if (l + order_ < span + 2 || l > span + order_ - 1) continue;
            const std::size_t fine_span = l <= span ? span + 1 : span;
            num::basis_values(slope.fine, fine_span, static_cast<int>(order_), at.place, values);
            double sum = 0;
            for (std::size_t i = 0; i < order_; ++i) {
                // Function i of the span, among those that the slope is made of.
                const std::size_t function = fine_span + 1 - order_ + i;
                if (function < l + 1 - order_ || function > l) continue;
                const double* const row = slope.rows.data() +
                                          (function - (l + 1 - order_)) * across_ +
                                          at.first_across;
                double part = 0;
                for (std::size_t j = 0; j < order_; ++j) part += row[j] * at.across[j];
                sum += values[i] * part;
            }
            visit(first_column_ + k, sum);
        }
    }

private:
    const std::vector<double>& t_;
    std::size_t order_, first_column_, across_ = 0;
    std::vector<LineSlope> slopes_;
};

class CloudLinesMoving : public MovableLines {
public:
    CloudLinesMoving(const Cloud& cloud, KnotPair knots, int degree)
        : cloud_(cloud), degree_(degree), state_(cloud_state(cloud, std::move(knots), degree)) {}

    const KnotPair& knots() const override { return state_.knots; }
    double delta2() const override { return state_.delta2; }

    bool improves_by(KnotPair knots) override {
        CloudState next = cloud_state(cloud_, std::move(knots), degree_);
        if (next.loose > state_.loose || !(next.delta2 < state_.delta2)) return false;
        state_ = std::move(next);
        return true;
    }

    /// All lines together: products of the slopes J less those with their best approximation by
    /// the splines, J^T J - (A^T J)^T (A^T A)^-1 (A^T J).
    std::vector<KnotModel> models() const override {
        const Local &bx = state_.system->x(), &by = state_.system->y();
        const std::size_t q = functions(1);
        SideSlopes x(state_.knots[0], degree_, 0), y(state_.knots[1], degree_, x.count());
        x.take(q, [&](std::size_t i, std::size_t j) { return state_.c[i * q + j]; });
        y.take(functions(0), [&](std::size_t j, std::size_t i) { return state_.c[i * q + j]; });
        KnotModel model = empty_model(x, y);
        Eigen::MatrixXd products = Eigen::MatrixXd::Zero(
            static_cast<Eigen::Index>(functions(0) * q),
            static_cast<Eigen::Index>(model.knots.size()));
        std::vector<std::pair<std::size_t, double>> slopes;
        for (std::size_t n = 0; n < cloud_.count(); ++n) {
            slopes.clear();
            const double weight = cloud_.weight[n];
            const auto keep = [&](std::size_t column, double slope) {
                slopes.emplace_back(column, weight * slope);
            };
            x.for_slopes({cloud_.x[n], bx.first[n], by.first[n], by.at(n)}, keep);
            y.for_slopes({cloud_.y[n], by.first[n], bx.first[n], bx.at(n)}, keep);
            add_sample(n, slopes, model, products);
        }
        const Eigen::MatrixXd fitted = state_.system->factor().solve(products);
        const Eigen::MatrixXd taken = products.transpose() * fitted;
        for (std::size_t i = 0; i < model.knots.size(); ++i) {
            for (std::size_t j = 0; j < model.knots.size(); ++j) {
                model.normal(i, j) -=
                    0.5 * (taken(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +
                           taken(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)));
            }
        }
        return {model};
    }

private:
    std::size_t functions(std::size_t side) const {
        return state_.knots[side].size() - static_cast<std::size_t>(degree_) - 1;
    }

    static KnotModel empty_model(const SideSlopes& x, const SideSlopes& y) {
        KnotModel model;
        for (std::size_t k = 0; k < x.count(); ++k) model.knots.push_back({0, x.knot(k)});
        for (std::size_t k = 0; k < y.count(); ++k) model.knots.push_back({1, y.knot(k)});
        model.gradient.assign(model.knots.size(), 0.0);
        model.normal = num::SymmetricMatrix(model.knots.size());
        return model;
    }

    void add_sample(std::size_t n, const std::vector<std::pair<std::size_t, double>>& slopes,
                    KnotModel& model, Eigen::MatrixXd& products) const {
        const Local &bx = state_.system->x(), &by = state_.system->y();
        const std::size_t q = functions(1);
        for (const auto& [column, slope] : slopes) {
            model.gradient[column] -= state_.e[n] * slope;
            for (const auto& [other, its] : slopes) model.normal(column, other) += slope * its;
            for (std::size_t i = 0; i < bx.order; ++i) {
                const double factor = cloud_.weight[n] * slope * bx.at(n)[i];
                double* const to = products.col(static_cast<Eigen::Index>(column)).data() +
                                   (bx.first[n] + i) * q + by.first[n];
                for (std::size_t j = 0; j < by.order; ++j) to[j] += factor * by.at(n)[j];
            }
        }
    }

    const Cloud& cloud_;
    int degree_;
    CloudState state_;
};

}  // namespace

MovedLines move_lines(const Cloud& cloud, KnotPair knots, int degree) {
    if (degree == 0) return {std::move(knots), 0, 0, true};
    CloudLinesMoving lines(cloud, std::move(knots), degree);
    return descend(lines, degree);
}

}  // namespace batten::surface_fitting
