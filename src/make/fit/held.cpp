#include "make/fit/held.hpp"

#include <algorithm>

#include "make/fit/covariance.hpp"
#include "num/cox_de_boor.hpp"

namespace batten::fitting {
namespace {

/// The jump of a derivative at a knot as a linear form of all coefficients, in units of the gaps
/// beside it.
std::vector<double> jump_form(const FixedFit& fixed, HeldDerivative held) {
    const std::span<const double> t = fixed.knots;
    const int k = fixed.system.order();
    const auto place = std::equal_range(t.begin(), t.end(), held.at);
    const std::size_t right = static_cast<std::size_t>(place.second - t.begin()) - 1;
    const std::size_t left = static_cast<std::size_t>(place.first - t.begin()) - 1;
    const double gap = std::min(t[right + 1] - t[right], t[left + 1] - t[left]);
    double unit = 1;
    for (int d = 0; d < held.derivative; ++d) unit *= gap;
    std::vector<double> form(static_cast<std::size_t>(fixed.functions), 0.0);
    double values[num::most_order];
    for (const bool is_right : {false, true}) {
        const std::size_t span = is_right ? right : left;
        num::basis_derivatives(t, span, k, held.at, held.derivative, values);
        const double factor = is_right ? unit : -unit;
        for (int j = 0; j < k; ++j) {
            form[span + static_cast<std::size_t>(j + 1 - k)] += factor * values[j];
        }
    }
    return form;
}

}  // namespace

void hold_smooth(FixedFit& fixed, std::span<const HeldDerivative> held) {
    if (held.empty() || !fixed.undetermined.empty()) return;
    for (const HeldDerivative& h : held) fixed.held.push_back(jump_form(fixed, h));
    fixed.fixed_count += static_cast<int>(held.size());
    fixed.limited = {CoefficientLaw(spline_of(fixed), fixed.system, fixed.held).coefficients()};
}

}  // namespace batten::fitting
