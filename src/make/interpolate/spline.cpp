#include "make/interpolate/spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "num/banded.hpp"

namespace batten::interpolation {
namespace {

using num::TridiagonalRow;

/// The coefficients of a spline as they come to be. In the beginning column 3 holds the chords'
/// slopes and column 2 the right-hand sides; the solution, a sixth of the second derivatives,
/// replaces these.
class SplineBlock {
public:
    SplineBlock(PointsView points, std::vector<double> parameters)
        : breaks_(std::move(parameters)),
          dim_(points.dim()),
          block_(4 * static_cast<std::size_t>(dim_) * breaks_.size()) {
        const std::size_t n = points.size();
        for (int k = 0; k < dim_; ++k) {
            double* const value = column(0, k);
            double* const slope = column(3, k);
            double* const sixth = column(2, k);
            for (std::size_t i = 0; i < n; ++i) value[i] = points(i, k);
            if (n < breaks_.size()) value[n] = value[0];
            for (std::size_t i = 0; i < spans(); ++i) {
                slope[i] = (value[i + 1] - value[i]) / step(i);
            }
            for (std::size_t i = 1; i < spans(); ++i) sixth[i] = slope[i] - slope[i - 1];
        }
    }

    std::size_t dim() const { return static_cast<std::size_t>(dim_); }
    std::size_t spans() const { return breaks_.size() - 1; }
    double step(std::size_t i) const { return breaks_[i + 1] - breaks_[i]; }
    double* slopes(std::size_t coordinate) { return column(3, static_cast<int>(coordinate)); }
    std::vector<double*> sixths() {
        std::vector<double*> columns;
        for (int k = 0; k < dim_; ++k) columns.push_back(column(2, k));
        return columns;
    }
    /// Room for one number a point, until `finish`.
    std::span<double> work() { return {column(1, 0), breaks_.size()}; }

    /// The equation of an inner point.
    TridiagonalRow row(std::size_t i) const {
        const double before = step(i - 1), after = step(i);
        return {before, 2 * (before + after), after};
    }

    /// From slopes and solved sixths to coefficients.
    PiecewiseCubic finish(bool closed) {
        const std::size_t n = spans();
        for (int k = 0; k < dim_; ++k) {
            double* const first = column(1, k);
            double* const sixth = column(2, k);
            double* const slope = column(3, k);
            for (std::size_t i = 0; i < n; ++i) {
                const double h = step(i), q0 = sixth[i], q1 = sixth[i + 1];
                first[i] = slope[i] - h * (2 * q0 + q1);
                sixth[i] = 3 * q0;
                slope[i] = (q1 - q0) / h;
            }
            first[n] = sixth[n] = 0;
        }
        return PiecewiseCubic::power(std::move(block_), dim_, std::move(breaks_), closed);
    }

private:
    double* column(int power, int coordinate) {
        return block_.data() + static_cast<std::size_t>(power * dim_ + coordinate) * breaks_.size();
    }

    std::vector<double> breaks_;
    int dim_;
    std::vector<double> block_;
};

/// The equations of an end point and of its neighbour.
struct EndRows {
    TridiagonalRow end, neighbour;
};

/// An end seen from outside: `outer` and `inner` are its first two parameter steps.
EndRows end_rows(Ends rule, double outer, double inner) {
    const TridiagonalRow neighbour{outer, 2 * (outer + inner), inner};
    if (rule == Ends::clamped) return {{0, 2 * outer, outer}, neighbour};
    if (rule == Ends::natural) return {{0, 1, 0}, neighbour};
    // Not a knot, (q1 - q0) / outer = (q2 - q1) / inner, put into the neighbour's equation, which
    // is divided by (outer + inner) / inner. q0 is found from it at last.
    return {{0, 1, 0}, {0, outer + 2 * inner, inner - outer}};
}

TridiagonalRow reversed(TridiagonalRow row) { return {row.upper, row.diagonal, row.lower}; }

void set_end_values(SplineBlock& block, const SplineEnds& ends) {
    const std::size_t n = block.spans();
    const std::vector<double*> sixths = block.sixths();
    for (std::size_t k = 0; k < block.dim(); ++k) {
        double* const q = sixths[k];
        const double* const slope = block.slopes(k);
        q[0] = ends.first_derivative.empty() ? 0 : slope[0] - ends.first_derivative[k];
        q[n] = ends.last_derivative.empty() ? 0 : ends.last_derivative[k] - slope[n - 1];
        if (ends.rule == Ends::not_a_knot && n > 2) {
            q[1] *= block.step(1) / (block.step(0) + block.step(1));
            q[n - 1] *= block.step(n - 2) / (block.step(n - 2) + block.step(n - 1));
        }
    }
}

void solve_open(SplineBlock& block, const SplineEnds& ends) {
    const std::size_t n = block.spans();
    const std::size_t second = n > 1 ? 1 : 0;
    const EndRows first = end_rows(ends.rule, block.step(0), block.step(second));
    const EndRows last = end_rows(ends.rule, block.step(n - 1), block.step(n - 1 - second));
    const auto row = [&](std::size_t i) {
        if (i == 0) return first.end;
        if (i == n) return reversed(last.end);
        if (i == 1) return first.neighbour;
        return i + 1 == n ? reversed(last.neighbour) : block.row(i);
    };
    num::solve_tridiagonal(n + 1, row, block.sixths(), block.work());
    if (ends.rule != Ends::not_a_knot || n < 3) return;
    for (double* const q : block.sixths()) {
        q[0] = q[1] + block.step(0) / block.step(1) * (q[1] - q[2]);
        q[n] = q[n - 1] + block.step(n - 1) / block.step(n - 2) * (q[n - 1] - q[n - 2]);
    }
}

void solve_parabola(SplineBlock& block) {
    for (double* const q : block.sixths()) {
        q[0] = q[1] = q[2] = q[1] / (3 * (block.step(0) + block.step(1)));
    }
}

std::vector<double> running_sum(const std::vector<double>& steps) {
    std::vector<double> result(steps.size() + 1);
    double sum = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) result[i + 1] = sum += steps[i];
    return result;
}

std::vector<double> centripetal_steps(const Chords& chords) {
    std::vector<double> steps(chords.lengths);
    for (double& step : steps) step = chords.longest * std::sqrt(step / chords.longest);
    return steps;
}

void require_range(const Chords& chords, double sum) {
    constexpr double least = 0x1p-480, most = 0x1p480;
    if (chords.shortest >= least && sum <= most) return;
    throw Error("number.overflow", "chords",
                format_number(chords.shortest < least ? chords.shortest : sum),
                "the coefficients leave the range of a double: scale the points, or choose the "
                "uniform parameter");
}

void require_growth(std::span<const double> lengths, std::span<const double> parameters) {
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        if (parameters[i] < parameters[i + 1]) continue;
        throw Error("interpolate.parameters", "chord from point " + std::to_string(i),
                    format_number(lengths[i]),
                    "too short beside the way of " + format_number(parameters[i]) + " so far", {i});
    }
}

}  // namespace

std::vector<double> parameters_by(Parameter rule, const Chords& chords) {
    if (rule == Parameter::uniform) {
        return running_sum(std::vector<double>(chords.lengths.size(), 1.0));
    }
    std::vector<double> result = rule == Parameter::chord ? running_sum(chords.lengths)
                                                          : running_sum(centripetal_steps(chords));
    require_range(chords, result.back());
    // A step of an ulp of the sum or more makes the sum grow, and no step is below the shortest.
    if (chords.shortest < 0x1p-52 * result.back()) require_growth(chords.lengths, result);
    return result;
}

PiecewiseCubic cubic_spline(PointsView points, std::vector<double> parameters,
                            const SplineEnds& ends) {
    SplineBlock block(points, std::move(parameters));
    set_end_values(block, ends);
    if (ends.rule == Ends::not_a_knot && block.spans() == 2) {
        solve_parabola(block);
    } else {
        solve_open(block, ends);
    }
    return block.finish(false);
}

PiecewiseCubic periodic_spline(PointsView points, std::vector<double> parameters) {
    SplineBlock block(points, std::move(parameters));
    const std::size_t n = block.spans();
    for (std::size_t k = 0; k < block.dim(); ++k) {
        const double* const slope = block.slopes(k);
        block.sixths()[k][0] = slope[0] - slope[n - 1];
    }
    const auto row = [&](std::size_t i) -> TridiagonalRow {
        if (i > 0) return block.row(i);
        const double before = block.step(n - 1), after = block.step(0);
        return {before, 2 * (before + after), after};
    };
    num::solve_cyclic(n, row, block.sixths(), block.work());
    for (double* const q : block.sixths()) q[n] = q[0];
    return block.finish(true);
}

}  // namespace batten::interpolation
