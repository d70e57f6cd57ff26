#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/make/fit_report.hpp"

namespace batten {

/// One step on the way to the final numbers of strips.
struct SurfaceStep : FitCriteria {
    std::array<int, 2> intervals{};
    int parameters = 0;
    std::vector<double> psi;
};

template <class Visit>
void visit_fields(const SurfaceStep& r, Visit&& visit) {
    visit("intervals", r.intervals, "numbers of strips in x and y");
    visit("parameters", r.parameters, "number of coefficients");
    visit_fields(static_cast<const FitCriteria&>(r), visit);
    visit("psi", r.psi, "shares of the residuals within 1, 2, ... 10 sigma");
}

/// How far a surface is from one that needs no grid of coefficients.
struct Separability {
    double additive = 0;  ///< share of the data's variation beyond the best u(x) + v(y)
    double product = 0;   ///< share of the data's square sum beyond the best u(x) v(y)
};

template <class Visit>
void visit_fields(const Separability& r, Visit&& visit) {
    visit("additive", r.additive, "share of the surface's variation beyond u(x) + v(y)");
    visit("product", r.product, "share of the surface's sum of squares beyond u(x) v(y)");
}

/// What is told of every surface that was fitted, whatever its knot lines.
struct SurfaceQuality : FitCriteria {
    std::array<int, 2> intervals{};
    int parameters = 0;
    int parameters_charged = 0;
    std::optional<double> chi2_p;
    std::vector<double> psi;
    std::vector<double> breaks_x, breaks_y;
    Separability separability;
    double oscillation = 0;
    std::vector<SurfaceStep> path;
    std::size_t samples = 0;
    std::size_t missing = 0;
    SigmaSource sigma_source = SigmaSource::estimated;
    std::optional<double> sigma;
    double max_residual = 0;
    Status status = Status::met;
    std::vector<std::string> notes;  ///< told last
};

template <class Visit>
void visit_fields(const SurfaceQuality& r, Visit&& visit) {
    visit("intervals", r.intervals, "numbers of strips in x and y");
    visit("parameters", r.parameters, "p: number of coefficients");
    visit("parameters_charged", r.parameters_charged, "p and the knot lines that were moved");
    visit_fields(static_cast<const FitCriteria&>(r), visit);
    visit("chi2_p", r.chi2_p, "probability of a larger delta2 if the errors are as stated");
    visit("psi", r.psi, "shares of the residuals within 1, 2, ... 10 sigma");
    visit("breaks_x", r.breaks_x, "distinct straight knot lines in x, both ends included");
    visit("breaks_y", r.breaks_y, "distinct straight knot lines in y");
    visit("separability", r.separability, "what cannot be written with one function a direction");
    visit("oscillation", r.oscillation,
          "how the surface bends between nodes, against how its nodes bend: about 1 where it is "
          "smooth, large where it swings between them");
    visit("path", r.path, "every pair of numbers of strips tried; psi only where nodes were read for it");
    visit("samples", r.samples, "N: nodes with a height");
    visit("missing", r.missing, "nodes without one");
    visit("sigma_source", r.sigma_source, "where the errors of the data come from");
    visit("sigma", r.sigma, "the error used, where it is one number");
    visit("max_residual", r.max_residual, "largest |residual|, data units");
}

struct FitSurfaceReport : SurfaceQuality {
    std::vector<double> knots_x, knots_y;
    std::vector<std::array<int, 2>> undetermined;
    int iterations = 0;
};

template <class Visit>
void visit_fields(const FitSurfaceReport& r, Visit&& visit) {
    visit_fields(static_cast<const SurfaceQuality&>(r), visit);
    visit("knots_x", r.knots_x, "the full knot vector in x");
    visit("knots_y", r.knots_y, "the full knot vector in y");
    visit("undetermined", r.undetermined, "coefficients i,j that the data do not determine");
    visit("iterations", r.iterations, "conjugate-gradient steps, where nodes are missing");
    visit("notes", r.notes, "what else there is to say");
}

}  // namespace batten
