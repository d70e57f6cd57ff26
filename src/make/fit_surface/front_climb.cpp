#include "make/fit_surface/front_climb.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "make/fit_surface/front_jump.hpp"

namespace batten::surface_fitting {
namespace {

std::array<int, 4> numbers_of(const FrontShape& shape) {
    return {shape.bundle, shape.beside, shape.front_intervals, shape.y_strips};
}

}  // namespace

SurfaceStep step_of(const Nodes& nodes, const FrontTrial& trial) {
    const FrontShape& shape = trial.descent.shape;
    SurfaceStep step{fit_criteria(trial.descent.state.delta2, nodes.count, shape.coefficients(),
                                  SigmaKnowledge::known),
                     {shape.lines() + 1, shape.y_strips},
                     shape.coefficients(),
                     {}};
    step.bic = trial.bic;
    return step;
}

FrontClimb::FrontClimb(const Nodes& nodes, FrontTrial start, int most_steps)
    : nodes_(nodes), best_(std::move(start)), most_steps_(most_steps) {
    tried_.insert(numbers_of(best_.descent.shape));
    path_.push_back(step_of(nodes_, best_));
}

void FrontClimb::run(const FrontLimits& limits) {
    const int lines = std::max(jump_lines, limits.lines);
    const int across = std::min(limits.intervals, static_cast<int>(nodes_.y.size()) - 3);
    const Move moves[] = {{&FrontShape::y_strips, 1, 1, across},
                          {&FrontShape::y_strips, -1, 1, across},
                          {&FrontShape::front_intervals, 1, 1, across},
                          {&FrontShape::front_intervals, -1, 1, across},
                          {&FrontShape::bundle, 1, 2, lines},
                          {&FrontShape::bundle, -1, 2, lines},
                          {&FrontShape::beside, -1, 0, 1},
                          {&FrontShape::beside, 1, 0, 1}};
    for (bool is_rising = true; is_rising;) {
        is_rising = false;
        for (const Move& move : moves) is_rising = takes(move) || is_rising;
    }
}

bool FrontClimb::takes(const Move& move) {
    FrontShape shape = best_.descent.shape;
    shape.*move.number += move.change;
    if (shape.*move.number < move.least || shape.*move.number > move.most) return false;
    if (!tried_.insert(numbers_of(shape)).second) return false;
    FrontTrial next = best_trial(nodes_, shape, carried_over(nodes_, best_.descent, shape),
                                 most_steps_);
    if (std::isfinite(next.bic)) path_.push_back(step_of(nodes_, next));
    if (!(next.bic < best_.bic)) return false;
    best_ = std::move(next);
    return true;
}

}  // namespace batten::surface_fitting
