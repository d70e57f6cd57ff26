#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/points.hpp"
#include "batten/make/fit_surface.hpp"
#include "batten/shape/curved_knot_surface.hpp"

namespace batten {

/// What to try for a surface with fronts or jumps along curves x = phi(y).
struct FitFrontOptions {
    std::optional<double> sigma;
    int most_steps = 60;      ///< of a descent
};

/// Which way fronts run: from the lowest y to the highest, x = phi(y), or the other way round.
enum class FrontRuns { across_rows, across_columns };

constexpr std::array<Named<FrontRuns>, 2> names_of(FrontRuns) {
    return {{{"x(y)", FrontRuns::across_rows}, {"y(x)", FrontRuns::across_columns}}};
}

/// parameters_charged: the coefficients, and what was moved: the places of phi, gaps, lines beside.
/// bic charges these too.
struct FrontReport : SurfaceQuality {
    bool has_front = false;   ///< the criterion prefers the curved lines to a tensor product
    int fronts = 1;           ///< bundles of lines
    bool is_jump = false;     ///< lines were run together: the surface is not continuous
    FrontRuns front = FrontRuns::across_rows;
    std::optional<double> tensor_bic;        ///< of the automatic tensor product, where it was asked
    std::vector<std::vector<double>> lines;  ///< coefficients of the curved ones
    int steps = 0;
};

template <class Visit>
void visit_fields(const FrontReport& r, Visit&& visit) {
    if (r.tensor_bic) {
        visit("has_front", r.has_front,
              "whether the criterion prefers curved lines to straight ones");
        visit("fronts", r.fronts, "how many fronts are followed, from left to right");
        visit("is_jump", r.is_jump, "whether the surface is not continuous across a front");
        visit("tensor_bic", r.tensor_bic, "bic of the automatic tensor product");
    }
    visit("front", r.front, "which coordinate of the front is a function of the other");
    visit_fields(static_cast<const SurfaceQuality&>(r), visit);
    visit("lines", r.lines, "coefficients of every curved line, a cubic spline of y over equal "
                            "intervals");
    visit("steps", r.steps, "steps of the descent that won");
    visit("notes", r.notes, "what else there is to say");
}

struct FrontFit {
    CurvedKnotSurface surface;
    FrontReport report;
    SurfaceFit tensor;  ///< the automatic tensor product
};

/// The surface with bundles of knot lines phi(y) + offset along its steepest paths, a line or none
/// in every space beside them, and straight lines of constant y; lines and coefficients of the
/// least delta2 found from narrow and from wide bundles. Cubic.
///
/// The numbers of lines along a front, of intervals of phi and of strips across are those of the
/// least bic, one at a time more or less; so are the number of fronts, the direction in which they
/// run, and whether the four lines of a bundle run together to a jump. At first at most 5 lines and
/// 3 intervals and strips; only where delta2 / (N - p) stays above 1.15 up to 3 fronts, 6 lines and
/// 4, 6, 8 intervals.
///
/// Scope: fronts that cross all rows (or all columns), one x for every y (or one y for every x),
/// at least 5 cells and a twentieth of the domain apart. One that dies out on its way is one of
/// them; one that closes or turns back is not.
/// `has_front` says whether bic prefers bundles of 4 or 5 lines, 3 intervals and 3 strips to the
/// tensor product of `fit_surface`, which is returned as well; only then other numbers are tried.
/// Lines never leave a spline without a node a row: coefficients would be left to chance.
/// Status `not_converged` where a descent stopped at `most_steps`.
/// Cost:   about a millisecond a step for 3,000 nodes; in all one or two seconds a front.
/// Throws: what fit_surface throws about samples; `fit.too-few` below 8 lines in x or 6 in y.
/// Source: variable projection [GolubPereyra1973], Kaufman's form; the derivative by a knot as in
/// docs/surfaces.md.
FrontFit fit_front(const SurfaceSamples& samples, const FitFrontOptions& options = {});

/// A surface whose curved knot lines are given.
struct LinesFit {
    CurvedKnotSurface surface;
    FrontReport report;  ///< has_front, is_jump and tensor_bic are not asked
};

/// The best coefficients for given lines x = X_i(y), which do not cross in the domain and cover it,
/// and `y_strips` equal strips across. Cubic.
///
/// Throws: what fit_surface throws about samples; `surface.lines` where lines cross or leave the
///         domain; `fit.too-few`; `number.overflow`.
LinesFit fit_with_lines(const SurfaceSamples& samples, std::span<const SplineFunction> lines,
                        int y_strips, std::optional<double> sigma);

/// Cubic splines through rows y, X_1, X_2, …: not-a-knot (two or three rows: the
/// polynomial). Throws `surface.lines` unless y rises over two rows or more and there is
/// a line.
std::vector<SplineFunction> lines_through(const Points& rows);

}  // namespace batten
