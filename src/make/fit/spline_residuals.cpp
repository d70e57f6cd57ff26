#include "make/fit/spline_residuals.hpp"

#include <algorithm>

#include "make/fit/interval_rows.hpp"
#include "num/lanes.hpp"

namespace batten::fitting {
namespace {

using knots::PowerForm;
using num::Lanes;
using num::lanes;

/// Samples of one piece.
struct PieceRun {
    const double *x, *y;
    std::size_t count;
    double origin;
};

template <int Degree>
BATTEN_INLINE void subtract_form(const PieceRun& run, const PowerForm& form, double* out) {
    std::size_t i = 0;
    for (; i + lanes <= run.count; i += lanes) {
        Lanes x, y, value;
        num::load(run.x + i, x);
        num::load(run.y + i, y);
        knots::horner_at<Degree, Lanes>(form, x - run.origin, value);
        num::store(y - value, out + i);
    }
    for (; i < run.count; ++i) {
        double value;
        knots::horner_at<Degree, double>(form, run.x[i] - run.origin, value);
        out[i] = run.y[i] - value;
    }
}

constexpr int most_unrolled = 5;

BATTEN_CLONES void subtract_piece(const PieceRun& run, int degree, const PowerForm& form,
                                  double* out) {
    switch (degree) {
        case 0: return subtract_form<0>(run, form, out);
        case 1: return subtract_form<1>(run, form, out);
        case 2: return subtract_form<2>(run, form, out);
        case 3: return subtract_form<3>(run, form, out);
        case 4: return subtract_form<4>(run, form, out);
        default: return subtract_form<most_unrolled>(run, form, out);
    }
}

}  // namespace

SplineResiduals::SplineResiduals(const Samples& samples, const SplineFunction& spline, int side)
    : samples_(samples),
      spline_(spline),
      y_(samples.sides[static_cast<std::size_t>(side)].data()) {
    enter_piece(0);
}

void SplineResiduals::enter_piece(std::size_t piece) {
    piece_ = piece;
    const std::span<const double> breaks = spline_.breaks();
    const bool is_last = piece + 1 == spline_.pieces();
    const Rows rest{row_, samples_.size()};
    piece_end_ = is_last ? samples_.size()
                         : end_of_run(samples_, rest, {breaks[piece], breaks[piece + 1]});
    for (int j = 0; j <= spline_.degree(); ++j) {
        form_[static_cast<std::size_t>(j)] = spline_.power(j)[piece];
    }
}

void SplineResiduals::next(std::size_t count, double* out) {
    const double* const x = samples_.x.data();
    if (spline_.degree() > most_unrolled) {
        spline_.evaluate(samples_.x.subspan(row_, count), 0, {out, count});
        for (std::size_t i = 0; i < count; ++i) out[i] = y_[row_ + i] - out[i];
        row_ += count;
        return;
    }
    for (const std::size_t to = row_ + count; row_ < to;) {
        while (row_ == piece_end_) enter_piece(piece_ + 1);
        const std::size_t last = std::min(piece_end_, to);
        subtract_piece({x + row_, y_ + row_, last - row_, spline_.breaks()[piece_]},
                       spline_.degree(), form_, out);
        out += last - row_;
        row_ = last;
    }
}

}  // namespace batten::fitting
