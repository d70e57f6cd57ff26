#include "make/fair/surface/evenness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "make/fair/surface/bend.hpp"

namespace batten::fairing {
namespace {

using Eigen::Index;

/// Modes beyond this many times the stiffness that is halved are left at 0.
constexpr double stiffest = 1e4;
constexpr int most_solves = 60;        ///< conjugate gradient steps
constexpr double rough_residual = 0.03, fine_residual = 1e-3;  ///< of conjugate gradients
constexpr int rough_steps = 2, fine_steps = 20;
constexpr double fine_move = 1e-3;     ///< of sigma
constexpr double least_weight = 0.1, most_weight = 1e7;
constexpr int patience = 4;    ///< weights in a row that may be worse
constexpr double exact = 1e-10;  ///< of the extent: less noise leaves nothing to even out

/// When steps end, and how exactly each is solved.
struct Haste {
    int most_steps;
    double residual;
    double move;
};

class Evening {
public:
    explicit Evening(const EvennessGoal& goal);
    Evened run();

private:
    Index modes_below_limit(const GridAxis& axis) const;
    Plane field_of(const Plane& modes) const;   ///< on all nodes
    Plane modes_of(const Plane& field) const;   ///< its transpose
    Planes moved(const Plane& modes) const;
    double objective(const Plane& modes);
    Plane change(const Plane& right, double residual) const;
    bool step(double residual);
    bool go(const Haste& haste);
    double expected_error() const;
    void find_weight();

    const EvennessGoal& goal_;
    CurvatureField field_;
    CurvatureField::Symbol symbol_;
    Plane u_modes_, v_modes_, stiffness_, waves_;  ///< of pairs of modes: 1 + mu s, and the symbol
    double unit_ = 0;      ///< w of weight 1
    double weight_ = 0;    ///< w
    double move_ = 0;      ///< where steps end
    double last_move_ = 0;
    Plane at_;             ///< in modes
    int steps_ = 0;
};

Evening::Evening(const EvennessGoal& goal)
    : goal_(goal),
      field_(goal.knots, goal.target,
             normals_of(goal.smooth.planes, goal.knots, static_cast<std::size_t>(goal.u.held))),
      symbol_(field_.symbol(goal.smooth.planes)) {
    const Index mu = modes_below_limit(goal.u), mv = modes_below_limit(goal.v);
    u_modes_ = goal.u.modes.leftCols(mu);
    v_modes_ = goal.v.modes.leftCols(mv);
    stiffness_.resize(mu, mv);
    waves_.resize(mu, mv);
    for (Index a = 0; a < mu; ++a) {
        for (Index b = 0; b < mv; ++b) {
            const double s = goal.u.stiffness[a], t = goal.v.stiffness[b];
            stiffness_(a, b) = 1 + goal.smooth.mu * (s + t);
            waves_(a, b) = symbol_(std::pow(s, 0.125) / goal.u.spacing,
                                   std::pow(t, 0.125) / goal.v.spacing);
        }
    }
    const double wave = std::pow(2 * goal.smooth.mu, -0.125);
    const double halved = symbol_(wave / goal.u.spacing, wave / goal.v.spacing);
    unit_ = halved > 0 ? 1 / halved : 0;
    move_ = fine_move * std::sqrt(goal.smooth.sigma_sq);
    at_ = Plane::Zero(mu, mv);
}

Index Evening::modes_below_limit(const GridAxis& axis) const {
    Index count = std::min<Index>(4, axis.free);
    while (count < axis.free && goal_.smooth.mu * axis.stiffness[count] < stiffest) ++count;
    return count;
}

Plane Evening::field_of(const Plane& modes) const {
    const Planes& p = goal_.smooth.planes;
    Plane field = Plane::Zero(p.at[0].rows(), p.at[0].cols());
    field.block(goal_.u.held, goal_.v.held, goal_.u.free, goal_.v.free).noalias() =
        u_modes_ * (modes * v_modes_.transpose());
    return field;
}

Plane Evening::modes_of(const Plane& field) const {
    return u_modes_.transpose() *
           (field.block(goal_.u.held, goal_.v.held, goal_.u.free, goal_.v.free) * v_modes_);
}

Planes Evening::moved(const Plane& modes) const {
    const Plane along = field_of(modes);
    Planes planes = goal_.smooth.planes;
    for (std::size_t k = 0; k < 3; ++k) {
        planes.at[k] += along.cwiseProduct(field_.normals().at[k]);
    }
    return planes;
}

double Evening::objective(const Plane& modes) {
    field_.evaluate(moved(modes));
    return modes.cwiseAbs2().cwiseProduct(stiffness_).sum() +
           weight_ * field_.roughness_sq(field_.values());
}

/// Solves the linearised problem: conjugate gradients, the matrix replaced by its mean symbol.
Plane Evening::change(const Plane& right, double residual) const {
    const Plane precondition = (stiffness_ + weight_ * waves_).cwiseInverse();
    Plane x = Plane::Zero(right.rows(), right.cols()), rest = right;
    Plane z = precondition.cwiseProduct(rest), along = z;
    double size = rest.cwiseProduct(z).sum();
    const double enough = residual * residual * size;
    for (int k = 0; k < most_solves && size > enough; ++k) {
        const Plane bent = field_.changed(field_of(along));
        const Plane image = stiffness_.cwiseProduct(along) +
                            weight_ * modes_of(field_.transposed(field_.roughened(bent)));
        const double share = size / along.cwiseProduct(image).sum();
        x += share * along;
        rest -= share * image;
        z = precondition.cwiseProduct(rest);
        const double next = rest.cwiseProduct(z).sum();
        along = z + (next / size) * along;
        size = next;
    }
    return x;
}

/// One Gauss-Newton step, halved until the sum falls; whether it did.
bool Evening::step(double residual) {
    field_.linearise(moved(at_));
    const double before = at_.cwiseAbs2().cwiseProduct(stiffness_).sum() +
                          weight_ * field_.roughness_sq(field_.values());
    const Plane right = -stiffness_.cwiseProduct(at_) -
                        weight_ * modes_of(field_.transposed(field_.roughened(field_.values())));
    Plane by = change(right, residual);
    ++steps_;
    for (int halving = 0; halving < 8; ++halving) {
        const Plane next = at_ + by;
        if (objective(next) <= before) {
            last_move_ = field_of(by).cwiseAbs().maxCoeff();
            at_ = next;
            return true;
        }
        by *= 0.5;
    }
    last_move_ = 0;  // rounding is all that is left to gain
    return false;
}

bool Evening::go(const Haste& haste) {
    for (int k = 0; k < haste.most_steps; ++k) {
        if (!step(haste.residual) || last_move_ <= haste.move) return true;
    }
    return false;
}

/// Mean squared error along the normals, up to a constant.
double Evening::expected_error() const {
    const Planes planes = moved(at_);
    const Planes& n = field_.normals();
    Plane off = Plane::Zero(n.at[0].rows(), n.at[0].cols());
    for (std::size_t k = 0; k < 3; ++k) {
        off += (planes.at[k] - goal_.data.at[k]).cwiseProduct(n.at[k]);
    }
    const double used = (stiffness_ + weight_ * waves_).cwiseInverse().sum();
    return off.squaredNorm() + 2 * goal_.smooth.sigma_sq * used;
}

void Evening::find_weight() {
    Plane best = at_;
    double best_weight = 0, least = expected_error();
    int worse = 0;
    for (double w = least_weight; w <= most_weight && worse < patience; w *= 10) {
        weight_ = w * unit_;
        go({rough_steps, rough_residual, move_});
        const double error = expected_error();
        worse = error < least ? 0 : worse + 1;
        if (worse > 0) continue;
        least = error;
        best = at_;
        best_weight = weight_;
    }
    at_ = best;
    weight_ = best_weight;
}

Evened Evening::run() {
    const bool is_exact = !goal_.weight && goal_.smooth.sigma_sq < exact * exact;
    if (unit_ == 0 || is_exact) return {goal_.smooth.planes, 0, 0, true};
    if (goal_.weight) {
        weight_ = *goal_.weight * unit_;
    } else {
        find_weight();
    }
    const bool rests = weight_ == 0 || go({fine_steps, fine_residual, move_});
    return {moved(at_), weight_ / unit_, steps_, rests};
}

}  // namespace

Evened evened(const EvennessGoal& goal) { return Evening(goal).run(); }

}  // namespace batten::fairing
