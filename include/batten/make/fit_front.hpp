#pragma once

#include <array>
#include <optional>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/make/fit_surface.hpp"
#include "batten/shape/curved_knot_surface.hpp"

namespace batten {

/// What to try for a surface with a front or a jump along one curve x = phi(y).
struct FitFrontOptions {
    int most_lines = 5;       ///< knot lines that follow the front; 4 can make a jump
    int front_intervals = 3;  ///< of the cubic spline phi
    int y_strips = 3;         ///< straight knot lines across
    std::optional<double> sigma;
    int most_steps = 60;      ///< of a descent
};

struct FrontReport {
    bool has_front = false;   ///< the criterion prefers the curved lines to a tensor product
    bool is_jump = false;     ///< the lines were run together: the surface is not continuous
    std::array<int, 2> intervals{};
    int parameters = 0;       ///< coefficients
    int line_parameters = 0;  ///< moved: those of phi, gaps, lines beside
    double delta2 = 0;
    double sigma2 = 0;        ///< delta2 / (N - p), the paper's count
    double bic = 0;           ///< moved parameters charged
    double tensor_bic = 0;    ///< of the automatic tensor product
    std::vector<std::vector<double>> lines;  ///< coefficients of the curved ones
    int steps = 0;
    Status status = Status::met;
};

template <class Visit>
void visit_fields(const FrontReport& r, Visit&& visit) {
    visit("has_front", r.has_front, "whether the criterion prefers curved lines to straight ones");
    visit("is_jump", r.is_jump, "whether the surface is not continuous across the front");
    visit("intervals", r.intervals, "numbers of strips in x and y");
    visit("parameters", r.parameters, "p: number of coefficients");
    visit("parameters_charged", r.parameters + r.line_parameters, "p and those of the lines");
    visit("delta2", r.delta2, "weighted sum of squared residuals");
    visit("sigma2", r.sigma2, "delta2 / (N - p)");
    visit("bic", r.bic, "delta2 + (p and those of the lines) ln N");
    visit("tensor_bic", r.tensor_bic, "the same of the automatic tensor product");
    visit("lines", r.lines, "coefficients of every curved line, a cubic spline of y over equal "
                            "intervals");
    visit("steps", r.steps, "steps of the descent that won");
}

struct FrontFit {
    CurvedKnotSurface surface;
    FrontReport report;
};

/// The surface with a bundle of knot lines phi(y) + offset along its steepest path, one more line
/// on each side of it, and straight lines of constant y; lines and coefficients of the least
/// delta2 found from a narrow and from a wide bundle. Cubic.
///
/// Scope: one front, crossing all rows, one x for every y. `has_front` says whether bic prefers it
/// to the tensor product of `fit_surface`; the front's surface is returned in either case.
/// Status `not_converged` where a descent stopped at `most_steps`.
/// Cost:   some milliseconds a step for 3,000 nodes.
/// Throws: what fit_surface throws about samples; `fit.too-few` below 8 lines in x or 4 in y.
/// Source: variable projection [GolubPereyra1973], Kaufman's form; the derivative by a knot as in
/// docs/surfaces.md.
FrontFit fit_front(const SurfaceSamples& samples, const FitFrontOptions& options = {});

}  // namespace batten
