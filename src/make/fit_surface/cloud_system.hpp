#pragma once

#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "make/fit_surface/cloud.hpp"

namespace batten::surface_fitting {

/// The splines of every sample that are not 0 there.
struct Local {
    std::size_t order;
    std::vector<std::size_t> first;
    std::vector<double> values;

    const double* at(std::size_t i) const { return values.data() + i * order; }
};

Local local_splines(const BSplineBasis& basis, std::span<const double> places);

/// One fit of scattered heights: matrix, factor, corrections.
class CloudSystem {
public:
    using Factor = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

    /// Borrows the cloud.
    CloudSystem(const Cloud& cloud, const BSplineBasis& x, const BSplineBasis& y);

    /// The fit without its misfit. Factorises; to be called before `factor`.
    CloudFit solved();
    /// Of the normal matrix with its faint smoothness.
    const Factor& factor() const { return *factor_; }
    const Local& x() const { return x_; }
    const Local& y() const { return y_; }

    std::vector<double> weighted_residuals(const std::vector<double>& c) const;
    /// The rule's measure of the strips of one direction.
    std::vector<double> strips(const std::vector<double>& e, const BSplineBasis& along, bool by_x,
                               StripRule rule) const;

private:
    void gather();
    double diagonal(std::size_t k) const;
    Eigen::SparseMatrix<double> matrix() const;
    template <class Add>
    void add_differences(std::size_t count, std::size_t stride, Add add) const;
    /// What splines see of residuals: A^T W e.
    Eigen::VectorXd gradient(const std::vector<double>& e) const;
    template <class Coefficients>
    double height(std::size_t n, const Coefficients& c) const;
    std::vector<double> weighted_values(const Eigen::VectorXd& c) const;
    void find_open(CloudFit& fit, const Eigen::VectorXd& pivots) const;

    const Cloud& cloud_;
    Local x_, y_;
    std::size_t p_, q_;
    int degree_;
    std::size_t width_ = 0;
    std::vector<double> entries_;
    double largest_ = 0;
    std::unique_ptr<Factor> factor_;
};

}  // namespace batten::surface_fitting
