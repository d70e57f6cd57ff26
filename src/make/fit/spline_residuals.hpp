#pragma once

#include "batten/shape/spline_function.hpp"
#include "make/fit/samples.hpp"
#include "shape/horner.hpp"

namespace batten::fitting {

/// The residuals y - S(x) of one side, sample after sample: who knows that x rises need not ask
/// every x for its piece.
class SplineResiduals {
public:
    SplineResiduals(const Samples& samples, const SplineFunction& spline, int side);

    /// Those of the next samples. The bits of SplineFunction::evaluate.
    void next(std::size_t count, double* out);

private:
    void enter_piece(std::size_t piece);

    const Samples& samples_;
    const SplineFunction& spline_;
    const double* y_;
    std::size_t row_ = 0, piece_ = 0, piece_end_ = 0;
    knots::PowerForm form_{};
};

}  // namespace batten::fitting
