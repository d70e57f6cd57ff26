#pragma once

#include <vector>

#include "batten/base/progress.hpp"
#include "make/pseudo/global/chain.hpp"
#include "make/pseudo/global/unknowns.hpp"
#include "make/pseudo/segment/descent.hpp"
#include "make/pseudo/segment/minima.hpp"

namespace batten::pseudo {

/// min J of one span as a function of its two angles, to second order.
struct SpanEnergy {
    Minimum minimum;
    Vector<2> gradient{};
    Matrix<2> hessian{};
};

/// ... with the Hessian of min J: that of J less what the magnitudes give way to.
SpanEnergy expand_minimum(const Minimum& minimum);

/// A span, what it weighs (length^p) and its energy now; its angles are those of the minimum.
struct WeighedSpan {
    double weight = 1;
    SpanEnergy energy;
};

/// Spans that share unknowns, and the sum of weight x J with its derivatives.
class GlobalDescent {
public:
    GlobalDescent(std::vector<WeighedSpan> spans, Unknowns unknowns);

    /// Newton's method in a trust region, every span staying on the minimum it can follow. Returns
    /// the steps made; converged if they are fewer than `most_steps`. `alive` is told 1 of 1 time
    /// and again: nobody knows how many steps there will be.
    /// Cost: linear in the spans, about 10 microseconds a span and step.
    int settle(int most_steps, const Progress& alive = {});
    /// Passes the spans that have a lower minimum at their angles to it. True if there was one.
    bool pass_to_least(const Progress& alive);

    const std::vector<WeighedSpan>& spans() const { return spans_; }
    double energy() const { return energy_; }
    double largest_gradient() const;

private:
    void sum_up();
    std::vector<double> restrained_step(double radius) const;
    double promised_by(const std::vector<double>& step) const;
    GlobalDescent moved_by(const std::vector<double>& step, const Progress& alive) const;

    std::vector<WeighedSpan> spans_;
    Unknowns unknowns_;
    double energy_ = 0;
    std::vector<double> downhill_;  // minus the gradient
    ChainMatrix hessian_;
};

}  // namespace batten::pseudo
