#include "batten/make/natural_spline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "batten/base/error.hpp"
#include "make/interpolate/chords.hpp"
#include "make/interpolate/natural_pass.hpp"
#include "make/interpolate/spline.hpp"
#include "num/banded.hpp"
#include "shape/cubic_room.hpp"

namespace batten::interpolation {
namespace {

/// Rows worked on while they are in the nearest cache: in loops without a chain, of which the
/// compiler makes vectors, and in the chain of the elimination.
constexpr std::size_t window_rows = 256;

/// Chord after chord. False, with the breaks half done, where a chord is not plain: `parameters_by`
/// knows what is wrong.
bool plain_breaks(PointsView points, std::span<double> breaks) {
    const double* const p = points.coordinates().data();
    const std::size_t spans = points.size() - 1;
    std::array<double, window_rows> lengths;
    double shortest = 0x1p480, sum = 0;
    breaks[0] = 0;
    for (std::size_t from = 0; from < spans; from += window_rows) {
        const std::size_t count = std::min(window_rows, spans - from);
        const double* const q = p + 2 * from;
        for (std::size_t i = 0; i < count; ++i) {
            const double x = q[2 * i + 2] - q[2 * i], y = q[2 * i + 3] - q[2 * i + 1];
            lengths[i] = std::sqrt(x * x + y * y);
        }
        for (std::size_t i = 0; i < count; ++i) {
            shortest = std::min(shortest, lengths[i]);
            breaks[from + i + 1] = sum += lengths[i];
        }
    }
    return shortest >= 0x1p-480 && sum <= 0x1p480 && shortest >= 0x1p-52 * sum;
}

/// `cubic_spline` with natural ends, its operations in an order that touches memory twice.
/// Elimination goes from both ends to the middle row, substitution back; what one row needs of the
/// points comes just before the first, what comes of it just after the second.
class NaturalPass {
public:
    NaturalPass(PointsView points, std::span<const double> breaks, std::span<double> block)
        : points_(points.coordinates().data()),
          breaks_(breaks.data()),
          rows_(breaks.size()),
          middle_(rows_ / 2),
          pairs_(rows_ - 1 - middle_),
          block_(block.data()) {}

    void run() {
        set_ends();
        eliminate();
        substitute(solve_middle());
    }

private:
    using Two = std::array<double, 2>;
    /// Sixths of the second derivatives of some rows, a column a coordinate.
    using Window = std::array<std::array<double, window_rows + 1>, 2>;
    /// How far the substitution has come on one side.
    struct Front {
        Two sixth;
        Window window;
    };

    double* column(std::size_t power, std::size_t coordinate) const {
        return block_ + (2 * power + coordinate) * rows_;
    }
    double step(std::size_t i) const { return breaks_[i + 1] - breaks_[i]; }
    /// Until a span is finished, its column 1 holds the share of the row.
    double* shares() const { return column(1, 0); }
    std::array<double*, 2> sixths() const { return {column(2, 0), column(2, 1)}; }
    bool is_even() const { return pairs_ < middle_; }
    num::TridiagonalRow row(std::size_t i) const {
        if (i == 0 || i + 1 == rows_) return {0, 1, 0};
        const double before = step(i - 1), after = step(i);
        return {before, 2 * (before + after), after};
    }

    void set_ends();
    void start_spans(std::size_t from, std::size_t to) const;
    void start_rows(std::size_t from, std::size_t to) const;
    void eliminate();
    Two solve_middle();
    void substitute(Two middle) const;
    void substitute_window(std::size_t from, std::size_t to, Front& left, Front& right) const;
    void finish_spans(std::size_t from, std::size_t to, const Window& window) const;

    const double* points_;
    const double* breaks_;
    std::size_t rows_, middle_, pairs_;
    double* block_;
    num::banded::Front<2> down_, up_;
};

/// The last zeros stay: the equation of an end is x = 0.
void NaturalPass::set_ends() {
    const std::size_t last = rows_ - 1;
    for (std::size_t k = 0; k < 2; ++k) {
        column(0, k)[last] = points_[2 * last + k];
        column(1, k)[last] = column(2, k)[last] = column(3, k)[last] = 0;
        column(2, k)[0] = 0;
    }
}

/// Values and slopes.
void NaturalPass::start_spans(std::size_t from, std::size_t to) const {
    double* const x = column(0, 0);
    double* const y = column(0, 1);
    double* const slope_x = column(3, 0);
    double* const slope_y = column(3, 1);
    for (std::size_t i = from; i < to; ++i) {
        const double h = step(i);
        const double x0 = points_[2 * i], y0 = points_[2 * i + 1];
        const double x1 = points_[2 * i + 2], y1 = points_[2 * i + 3];
        x[i] = x0;
        y[i] = y0;
        slope_x[i] = (x1 - x0) / h;
        slope_y[i] = (y1 - y0) / h;
    }
}

/// Right-hand sides.
void NaturalPass::start_rows(std::size_t from, std::size_t to) const {
    from = std::max<std::size_t>(from, 1);
    to = std::min(to, rows_ - 1);
    for (std::size_t k = 0; k < 2; ++k) {
        const double* const slope = column(3, k);
        double* const sixth = column(2, k);
        for (std::size_t i = from; i < to; ++i) sixth[i] = slope[i] - slope[i - 1];
    }
}

void NaturalPass::eliminate() {
    const std::size_t last = rows_ - 1;
    const std::array<double*, 2> x = sixths();
    double* const share = shares();
    for (std::size_t from = 0; from < pairs_; from += window_rows) {
        const std::size_t to = std::min(from + window_rows, pairs_);
        start_spans(from, to);
        start_rows(from, to);
        start_spans(last - to, last - from);
        start_rows(last - to + 1, last - from + 1);
        for (std::size_t i = from; i < to; ++i) {
            const std::size_t j = last - i;
            const num::TridiagonalRow r = row(j);
            num::banded::eliminate(down_, row(i), i, x);
            num::banded::eliminate(up_, {r.upper, r.diagonal, r.lower}, j, x);
            share[i] = down_.share;
            share[j] = up_.share;
        }
    }
}

/// A sixth of the second derivative at the middle row.
NaturalPass::Two NaturalPass::solve_middle() {
    const std::array<double*, 2> x = sixths();
    if (is_even()) {
        start_spans(pairs_, middle_);
        start_rows(pairs_, middle_);
        num::banded::eliminate(down_, row(pairs_), pairs_, x);
    }
    start_rows(middle_, middle_ + 1);
    const num::TridiagonalRow r = row(middle_);
    const double pivot = r.diagonal - (r.lower * down_.share + r.upper * up_.share);
    Two result;
    for (std::size_t k = 0; k < 2; ++k) {
        const double known = r.lower * down_.values[k] + r.upper * up_.values[k];
        result[k] = (x[k][middle_] - known) / pivot;
    }
    return result;
}

void NaturalPass::substitute(Two middle) const {
    const std::size_t last = rows_ - 1;
    Front left, right;
    left.sixth = right.sixth = middle;
    if (is_even()) {
        for (std::size_t k = 0; k < 2; ++k) {
            left.window[k][1] = left.sixth[k];
            left.window[k][0] = left.sixth[k] =
                column(2, k)[pairs_] - down_.share * left.sixth[k];
        }
        finish_spans(pairs_, middle_, left.window);
    }
    for (std::size_t to = pairs_; to > 0;) {
        const std::size_t from = to - std::min(window_rows, to);
        substitute_window(from, to, left, right);
        finish_spans(from, to, left.window);
        finish_spans(last - to, last - from, right.window);
        to = from;
    }
}

/// Rows `from` to `to` and as many from the other end.
void NaturalPass::substitute_window(std::size_t from, std::size_t to, Front& left,
                                    Front& right) const {
    const std::array<double*, 2> x = sixths();
    const double* const share = shares();
    for (std::size_t k = 0; k < 2; ++k) {
        left.window[k][to - from] = left.sixth[k];
        right.window[k][0] = right.sixth[k];
    }
    for (std::size_t i = to; i-- > from;) {
        const std::size_t j = rows_ - 1 - i;
        for (std::size_t k = 0; k < 2; ++k) {
            left.sixth[k] = x[k][i] - share[i] * left.sixth[k];
            right.sixth[k] = x[k][j] - share[j] * right.sixth[k];
            left.window[k][i - from] = left.sixth[k];
            right.window[k][to - i] = right.sixth[k];
        }
    }
}

/// Coefficients. None is beyond a double: slopes are at most 2, and steps between 2^-480 and 2^480.
void NaturalPass::finish_spans(std::size_t from, std::size_t to, const Window& window) const {
    for (std::size_t k = 0; k < 2; ++k) {
        double* const first = column(1, k);
        double* const second = column(2, k);
        double* const third = column(3, k);
        const double* const q = window[k].data();
        for (std::size_t i = from; i < to; ++i) {
            const double h = step(i), q0 = q[i - from], q1 = q[i - from + 1];
            first[i] = third[i] - h * (2 * q0 + q1);
            second[i] = 3 * q0;
            third[i] = (q1 - q0) / h;
        }
    }
}

}  // namespace

std::optional<PiecewiseCubic> plain_natural_curve(PointsView points) {
    if (points.dim() != 2) return std::nullopt;
    const cubics::Room room(points.size(), 2);
    if (!plain_breaks(points, room.breaks())) return std::nullopt;
    NaturalPass(points, room.breaks(), room.block()).run();
    return room.curve(false);
}

}  // namespace batten::interpolation

namespace batten {

void natural_spline(PointsView points, std::span<double> breaks, std::span<double> block) {
    require_dimension(points, 2, 2);
    require_count(points, 2);
    if (breaks.size() != points.size() || block.size() != 8 * points.size()) {
        throw Error("curve.coefficients", "breaks and block",
                    std::to_string(breaks.size()) + " and " + std::to_string(block.size()),
                    "1 and 8 numbers a point are needed, of " + std::to_string(points.size()));
    }
    if (!interpolation::plain_breaks(points, breaks)) {
        const std::vector<double> careful = interpolation::parameters_by(
            Parameter::chord, interpolation::chords_of(points, false));
        std::copy(careful.begin(), careful.end(), breaks.begin());
    }
    interpolation::NaturalPass(points, breaks, block).run();
}

}  // namespace batten
