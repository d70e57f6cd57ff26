#pragma once

#include <memory>
#include <span>
#include <vector>

#include "batten/make/fit_bands.hpp"
#include "make/fit/fixed_fit.hpp"

namespace batten {
namespace fitting {

/// What one solved problem says about the error of its coefficients, and of what is linear in
/// them: everything in units of the data's sigma.
class CoefficientLaw {
public:
    /// `held`: linear forms of the coefficients that are known exactly; what they say is not in
    /// doubt any more.
    CoefficientLaw(SplineFunction spline, const KnotSystem& system,
                   const std::vector<std::vector<double>>& held = {});
    /// From what another one said of itself: spline(), qr() and known().
    CoefficientLaw(SplineFunction spline, num::BandedQr qr,
                   std::vector<std::vector<double>> known);

    /// The derivatives at x of the B-splines that are not zero there.
    struct Functions {
        int first;
        std::vector<double> values;
    };

    const SplineFunction& spline() const { return spline_; }
    const num::BandedQr& qr() const { return qr_; }
    /// R^-T of what is known exactly, made orthonormal.
    const std::vector<std::vector<double>>& known() const { return known_; }
    int functions() const { return qr_.shape().columns + qr_.shape().border; }
    Functions functions_at(double x, int derivative) const;
    /// The unknown that holds coefficient c.
    std::size_t unknown(int c) const;
    /// As a vector over all unknowns.
    std::vector<double> spread(const Functions& f) const;
    /// R^-T a, for a functional a of the unknowns, less what is known exactly: its variance is the
    /// square of the norm.
    std::vector<double> forward(std::vector<double> a) const;
    /// (R^T R)^-1 a.
    std::vector<double> apply(std::vector<double> a) const;
    /// The best coefficients where every held form is 0. Open splines without border, side 0; not
    /// of a law put together from parts, which has no sides.
    std::vector<double> coefficients() const;
    /// The variance of S(x) or of a derivative.
    double variance(double x, int derivative) const;
    /// The variance of the integral over `part`.
    double integral_variance(Interval part) const;

private:
    int functions_at(double x, int derivative, double* values) const;
    void find_band();
    std::vector<double> without_known(std::vector<double> v) const;

    SplineFunction spline_;
    num::BandedQr qr_;
    std::vector<double> band_;  ///< (R^T R)^-1 inside the band; open splines without held forms
    std::vector<std::vector<double>> known_;
};

/// A fit with other knots that the data find plausible too.
struct Alternative {
    double weight;
    CoefficientLaw law;
};

/// How wide: `scale` multiplies every deviation; bands are those of Student's t with so many
/// degrees of freedom where sigma was estimated (0: it is known, and they are the normal ones).
struct Width {
    double scale = 1;
    double degrees = 0;
};

}  // namespace fitting

struct FitCovariance::Model {
    fitting::CoefficientLaw own;
    std::vector<fitting::Alternative> alternatives;  ///< weights add up to 1; may be empty
    fitting::Width width;
};

}  // namespace batten
