#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/convert.hpp"
#include "batten/measure/continuity.hpp"
#include "batten/shape/spline_function.hpp"
#include "batten/shape/transform.hpp"

namespace batten {
namespace {

/// Derivatives that agree at a joint, by the grade found there.
int derivatives_at(Continuity grade) {
    return grade == Continuity::C2 ? 2 : grade == Continuity::C1 ? 1 : 0;
}

std::vector<SplineFunction> coordinates_of(const BSplineCurve& curve) {
    const std::span<const double> knots = curve.basis().knots();
    const PointsView points = curve.control_points();
    std::vector<SplineFunction> coordinates;
    for (int k = 0; k < curve.dim(); ++k) {
        std::vector<double> c(points.size());
        for (std::size_t j = 0; j < c.size(); ++j) c[j] = points(j, k);
        coordinates.emplace_back(std::vector<double>(knots.begin(), knots.end()), std::move(c),
                                 curve.basis().degree());
    }
    return coordinates;
}

BSplineCurve curve_through(const std::vector<SplineFunction>& coordinates) {
    const SplineFunction& first = coordinates.front();
    Points points(first.coefficients().size(), static_cast<int>(coordinates.size()));
    for (std::size_t k = 0; k < coordinates.size(); ++k) {
        for (std::size_t j = 0; j < points.size(); ++j) {
            points[j][k] = coordinates[k].coefficients()[j];
        }
    }
    return {BSplineBasis({first.knots().begin(), first.knots().end()}, first.degree()),
            std::move(points)};
}

/// All coordinates without one knot, and a bound of how far points move.
struct Removal {
    std::vector<SplineFunction> coordinates;
    double bound = 0;
};

Removal without(const std::vector<SplineFunction>& coordinates, std::size_t index) {
    Removal result;
    double sum_sq = 0;
    for (const SplineFunction& each : coordinates) {
        KnotRemoval removal = remove_knot(each, index);
        sum_sq += removal.max_error * removal.max_error;
        result.coordinates.push_back(std::move(removal.spline));
    }
    result.bound = std::sqrt(sum_sq);
    return result;
}

}  // namespace

BSplineCurve to_bspline(const Curve& curve) {
    if (const auto* spline = curve.shape<BSplineCurve>()) return *spline;
    const std::optional<PiecewiseCubic> cubic = exact_cubic(curve);
    if (!cubic) {
        throw Error("curve.not-exact", "curve", "no polynomial pieces of degree 3 or less",
                    "only these and B-splines have knots: convert the curve to cubic first");
    }
    std::vector<int> derivatives;
    for (const Joint& joint : continuity(curve)) {
        derivatives.push_back(derivatives_at(joint.continuity));
    }
    return to_bspline(*cubic, derivatives);
}

BSplineCurve remove_knots(const BSplineCurve& curve, double tolerance) {
    if (curve.is_closed() || curve.is_rational()) {
        throw Error("bspline.removal", "curve", curve.is_closed() ? "closed" : "rational",
                    "knots are taken out of open curves of polynomials");
    }
    std::vector<SplineFunction> coordinates = coordinates_of(curve);
    const std::size_t order = static_cast<std::size_t>(curve.basis().degree()) + 1;
    double used = 0;
    for (std::size_t index = order; index + order < coordinates.front().knots().size();) {
        Removal removal = without(coordinates, index);
        if (used + removal.bound <= tolerance) {
            used += removal.bound;
            coordinates = std::move(removal.coordinates);
        } else {
            ++index;
        }
    }
    return curve_through(coordinates);
}

Points power_form(const Curve& curve) {
    if (!curve.degree()) {
        throw Error("curve.not-exact", "curve", "no polynomial pieces",
                    "only polynomials have a power form: convert the curve to cubic first");
    }
    const int degree = *curve.degree();
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    const std::size_t powers = static_cast<std::size_t>(degree) + 1;
    Points rows(curve.pieces(), static_cast<int>(2 + dim * powers));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Interval piece = curve.piece(i);
        const Jet jet = curve.jet_on(i, piece.lo, degree);
        rows[i][0] = piece.lo;
        rows[i][1] = piece.hi;
        double factorial = 1;
        for (std::size_t j = 0; j < powers; ++j) {
            if (j > 0) factorial *= static_cast<double>(j);
            for (std::size_t k = 0; k < dim; ++k) {
                rows[i][2 + k * powers + j] = jet[static_cast<int>(j)][k] / factorial;
            }
        }
    }
    return rows;
}

}  // namespace batten
