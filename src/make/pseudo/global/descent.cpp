#include "make/pseudo/global/descent.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "make/pseudo/segment/kernel.hpp"

namespace batten::pseudo {
namespace {

constexpr std::size_t fixed = SpanUnknowns::fixed;

void add(std::vector<double>& to, std::size_t unknown, double value) {
    if (unknown != fixed) to[unknown] += value;
}

double largest(const std::vector<double>& values) {
    double result = 0;
    for (double value : values) result = std::fmax(result, std::fabs(value));
    return result;
}

}  // namespace

SpanEnergy expand_minimum(const Minimum& minimum) {
    const Expansion<4> j = expand_all(minimum.segment);
    SpanEnergy e{minimum, {j.gradient[angle0], j.gradient[angle1]}, {}};
    for (std::size_t b = 0; b < 2; ++b) {
        const Quadratic<2> mixed{
            0,
            {j.hessian[ln_r0][angle0 + b], j.hessian[ln_r1][angle0 + b]},
            {{{j.hessian[0][0], j.hessian[0][1]}, {j.hessian[1][0], j.hessian[1][1]}}}};
        const auto response = shifted_newton_step<2>(mixed, 0);
        for (std::size_t a = 0; a < 2; ++a) {
            e.hessian[a][b] = j.hessian[angle0 + a][angle0 + b];
            if (!response) continue;
            e.hessian[a][b] += j.hessian[ln_r0][angle0 + a] * (*response)[0] +
                               j.hessian[ln_r1][angle0 + a] * (*response)[1];
        }
    }
    return e;
}

GlobalDescent::GlobalDescent(std::vector<WeighedSpan> spans, Unknowns unknowns)
    : spans_(std::move(spans)), unknowns_(std::move(unknowns)) {
    sum_up();
}

double GlobalDescent::largest_gradient() const { return largest(downhill_); }

void GlobalDescent::sum_up() {
    const std::size_t n = unknowns_.count;
    energy_ = 0;
    downhill_.assign(n, 0);
    hessian_.diagonal.assign(n, 0);
    hessian_.beside.assign(n, 0);
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        const auto& [weight, e] = spans_[i];
        const SpanUnknowns ends = unknowns_.of_span[i];
        energy_ += weight * e.minimum.pseudo_energy;
        add(downhill_, ends.start, -weight * e.gradient[0]);
        add(downhill_, ends.end, -weight * e.gradient[1]);
        add(hessian_.diagonal, ends.start, weight * e.hessian[0][0]);
        add(hessian_.diagonal, ends.end, weight * e.hessian[1][1]);
        if (ends.start == fixed || ends.end == fixed) continue;
        if (ends.start == ends.end) {
            hessian_.diagonal[ends.start] += 2 * weight * e.hessian[0][1];
        } else {
            hessian_.beside[ends.start] += weight * e.hessian[0][1];
        }
    }
}

GlobalDescent GlobalDescent::moved_by(const std::vector<double>& step,
                                      const Progress& alive) const {
    GlobalDescent moved = *this;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        alive.at(1, 1);
        const SpanUnknowns ends = unknowns_.of_span[i];
        if (ends.start == fixed && ends.end == fixed) continue;
        PseudoSegment segment = spans_[i].energy.minimum.segment;
        if (ends.start != fixed) segment.theta0 += step[ends.start];
        if (ends.end != fixed) segment.theta1 += step[ends.end];
        moved.spans_[i].energy = expand_minimum(minimum_near(segment));
    }
    moved.sum_up();
    return moved;
}

std::vector<double> GlobalDescent::restrained_step(double radius) const {
    double shift = 1e-14;
    while (true) {
        const auto step = solve_shifted(hessian_, shift, downhill_);
        if (step && largest(*step) <= radius) return *step;
        shift = std::fmax(1e-6, 4 * shift);
    }
}

double GlobalDescent::promised_by(const std::vector<double>& step) const {
    double decrease = 0;
    const std::size_t n = step.size();
    for (std::size_t i = 0; i < n; ++i) {
        decrease += step[i] * (downhill_[i] - 0.5 * hessian_.diagonal[i] * step[i] -
                               hessian_.beside[i] * step[(i + 1) % n]);
    }
    return decrease;
}

int GlobalDescent::settle(int most_steps, const Progress& alive) {
    constexpr double noise = 1e-13;
    constexpr double least_turn = 2e-16;  // below the rounding error of an angle
    double radius = 0.25;
    double size_before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_steps; ++k) {
        if (downhill_.empty() || largest(downhill_) == 0) return k;
        const std::vector<double> step = restrained_step(radius);
        const double size = largest(step);
        const double promised = promised_by(step);
        const bool is_final = promised <= noise * energy_;
        if (size < least_turn || (is_final && !(size < 0.5 * size_before))) return k;
        GlobalDescent fresh = moved_by(step, alive);
        if (is_final) {
            size_before = size;
        } else {
            const double ratio = (energy_ - fresh.energy_) / promised;
            if (ratio < 0.25) radius = 0.25 * size;
            if (ratio > 0.75) radius = std::fmin(std::fmax(radius, 2 * size), 0.5);
            if (!(ratio > 0)) continue;
        }
        *this = std::move(fresh);
    }
    return most_steps;
}

bool GlobalDescent::pass_to_least(const Progress& alive) {
    bool has_passed = false;
    for (WeighedSpan& span : spans_) {
        alive.at(1, 1);
        const Minimum& now = span.energy.minimum;
        const Minimum least = least_minimum(now.segment.theta0, now.segment.theta1);
        if (!(least.pseudo_energy < now.pseudo_energy * (1 - 1e-12))) continue;
        span.energy = expand_minimum(least);
        has_passed = true;
    }
    if (has_passed) sum_up();
    return has_passed;
}

}  // namespace batten::pseudo
