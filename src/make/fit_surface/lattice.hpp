#pragma once

#include <memory>
#include <vector>

#include "make/fit_surface/cloud.hpp"
#include "make/fit_surface/masked_space.hpp"
#include "make/fit_surface/nested.hpp"
#include "make/fit_surface/solve.hpp"

namespace batten::surface_fitting {

/// Knot lines of a surface that grow one at a time, with their solution and its misfit.
class Lattice {
public:
    Lattice(const Nodes& nodes, int degree, StripRule rule);
    Lattice(const Cloud& cloud, int degree, StripRule rule);

    int degree() const { return degree_; }
    std::size_t samples() const { return nodes_ ? nodes_->count : cloud_->count(); }
    bool knows_sigma() const { return nodes_ ? nodes_->sigma_known : cloud_->sigma_known; }
    /// What rounding leaves, where errors are estimated.
    double least_delta2() const { return nodes_ ? nodes_->least_delta2 : cloud_->least_delta2; }
    const std::vector<double>& x_breaks() const { return x_breaks_; }
    const std::vector<double>& y_breaks() const { return y_breaks_; }
    int x_strips() const { return static_cast<int>(x_breaks_.size()) - 1; }
    int y_strips() const { return static_cast<int>(y_breaks_.size()) - 1; }
    int parameters() const { return (x_strips() + degree_) * (y_strips() + degree_); }
    const Misfit& misfit() const { return misfit_; }

    /// Solves and measures for the present lines. False where that needs nodes that are not held.
    /// Throws `points.not-finite`, `number.overflow`.
    bool refit();
    /// Where every residual is asked for, or only their sums.
    enum class Residuals { each, sums };
    /// Gets ready for refits whose lines are those before and some more, where that is worth while.
    /// Of sums only, the nodes of large grids are read once; psi is then not measured. Throws
    /// `fit.too-few` where stored heights do not determine a polynomial.
    void expect_splits(Residuals residuals);
    /// What a fit of its own would give for lines of one of the refits, where it is known.
    struct Fit {
        Axis x, y;
        Solution solution;
        Misfit misfit;
    };
    std::optional<Fit> known_fit(const std::vector<double>& x_breaks,
                                 const std::vector<double>& y_breaks) const;

    /// The strip with the largest measure that can be split, x before y and low before high where
    /// they are equal; none where nothing can be split. Directions with as many strips as `most`
    /// says are left alone (0: no limit).
    struct Strip {
        bool is_x = true;
        std::size_t index = 0;
    };
    std::optional<Strip> worst(std::array<int, 2> most) const;
    /// Whether another strip that can be split fits as badly, to 1e-9, and by more than rounding.
    bool is_tied(Strip worst, std::array<int, 2> most) const;
    void split(Strip strip);

    /// Strips of equal width, if the nodes determine splines over them.
    bool set_equal(int x_strips, int y_strips);
    /// Which direction's strips fit worse as a whole.
    bool is_x_worse() const;

private:
    void require_finite_misfit() const;
    std::unique_ptr<SearchSpace> compressed(int halvings) const;
    std::unique_ptr<SearchSpace> finer_space();
    std::unique_ptr<SearchSpace> locally_finer_space() const;
    bool fits(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks) const;
    bool go_to_finer_strips();
    void expect_masked_splits();
    void take_unit();
    std::unique_ptr<MaskedSpace> masked(int halvings) const;
    bool go_to_masked();
    void set_axes();
    bool can_split(Strip strip) const;
    double measure(Strip s) const {
        return s.is_x ? misfit_.x_strips[s.index] : misfit_.y_strips[s.index];
    }
    std::vector<Strip> strips(std::array<int, 2> most) const;
    Axis axis_over(const std::vector<double>& breaks, Way way) const;
    void set(std::vector<double> x_breaks, std::vector<double> y_breaks);

    const Nodes* nodes_ = nullptr;  ///< either these or the cloud
    const Cloud* cloud_ = nullptr;
    Rectangle domain_;
    int degree_;
    StripRule rule_;
    std::vector<double> used_x_, used_y_, x_breaks_, y_breaks_;
    std::unique_ptr<Axis> x_, y_;  ///< of the present lines, once asked for
    std::optional<Solution> solution_;  ///< of the present lines, unless nested
    Misfit misfit_;
    double unit_ = 1;  ///< of stored heights' errors
    std::unique_ptr<SearchSpace> space_;
    int halvings_ = 0;  ///< of all strips, that gave the space's; 0: strips differ
    std::unique_ptr<Nested> nested_;
    std::unique_ptr<MaskedSpace> masked_;  ///< where nodes are missing
};

}  // namespace batten::surface_fitting
