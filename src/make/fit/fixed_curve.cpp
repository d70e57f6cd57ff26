#include "make/fit/fixed_curve.hpp"

#include "make/fit/residuals.hpp"

namespace batten::fitting {

BSplineCurve curve_of(const FixedFit& fixed) {
    const std::vector<SplineFunction> coordinates =
        splines_of(fixed, static_cast<std::size_t>(fixed.system.sides()));
    const std::size_t functions = static_cast<std::size_t>(fixed.functions);
    Points control(functions, static_cast<int>(coordinates.size()));
    for (std::size_t j = 0; j < functions; ++j) {
        for (std::size_t s = 0; s < coordinates.size(); ++s) {
            control(j, static_cast<int>(s)) = coordinates[s].coefficients()[j];
        }
    }
    const int degree = coordinates[0].degree();
    const std::span<const double> knots = fixed.knots;
    return coordinates[0].is_closed()
               ? BSplineCurve(BSplineBasis::periodic(knots.subspan(fixed.system.order() - 1,
                                                                   functions + 1),
                                                     degree),
                              std::move(control))
               : BSplineCurve(BSplineBasis(fixed.knots, degree), std::move(control));
}

}  // namespace batten::fitting
