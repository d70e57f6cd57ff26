#include "batten/shape/spline_surface.hpp"

#include <cassert>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "num/tensor.hpp"
#include "shape/surface/sides.hpp"

namespace batten {
namespace {

constexpr int most_surface_order = BSplineBasis::most_degree + 1;

/// The functions of one direction at one place, derivatives 0 ... order.
struct PlaceValues {
    double values[3 * most_surface_order];
    std::size_t first;
    int width;

    PlaceValues(const BSplineBasis& basis, double t, int order) : width(basis.degree() + 1) {
        const std::size_t span = basis.span_of(t);
        first = span - static_cast<std::size_t>(basis.degree());
        basis.nonzero_on(span, t, order, {values, static_cast<std::size_t>((order + 1) * width)});
    }
    const double* operator[](int derivative) const { return values + derivative * width; }
};

double product(const SplineSurface& surface, const PlaceValues& x, const double* a,
               const PlaceValues& y, const double* b) {
    double sum = 0;
    for (int i = 0; i < x.width; ++i) {
        const double* const c = surface.coefficients().data() +
                                (x.first + static_cast<std::size_t>(i)) * surface.y_basis().size() +
                                y.first;
        double row = 0;
        for (int j = 0; j < y.width; ++j) row += c[j] * b[j];
        sum += a[i] * row;
    }
    return sum;
}

}  // namespace

SplineSurface::SplineSurface(BSplineBasis x_basis, BSplineBasis y_basis,
                             std::vector<double> coefficients)
    : x_(std::move(x_basis)), y_(std::move(y_basis)), coefficients_(std::move(coefficients)) {
    if (x_.is_periodic() || y_.is_periodic()) {
        throw Error("surface.basis", x_.is_periodic() ? "x" : "y", "periodic",
                    "the bases of a spline surface end");
    }
    if (coefficients_.size() != x_.size() * y_.size()) {
        throw Error("surface.coefficients", "surface", std::to_string(coefficients_.size()),
                    std::to_string(x_.size()) + " x " + std::to_string(y_.size()) + " are needed");
    }
    for (std::size_t i = 0; i < coefficients_.size(); ++i) {
        if (std::isfinite(coefficients_[i])) continue;
        throw Error("surface.coefficients", "coefficient " + std::to_string(i),
                    format_number(coefficients_[i]), "coefficients must be finite");
    }
}

double SplineSurface::operator()(double x, double y, Partial derivative) const {
    if (derivative.x <= 2 && derivative.y <= 2) {
        const PlaceValues at_x(x_, x, derivative.x), at_y(y_, y, derivative.y);
        return product(*this, at_x, at_x[derivative.x], at_y, at_y[derivative.y]);
    }
    const double xs[] = {x}, ys[] = {y};
    double out[1];
    evaluate(xs, ys, derivative, out);
    return out[0];
}

HeightJet SplineSurface::jet(double x, double y) const {
    const PlaceValues a(x_, x, 2), b(y_, y, 2);
    const auto at = [&](int i, int j) { return product(*this, a, a[i], b, b[j]); };
    return {at(0, 0), at(1, 0), at(0, 1), at(2, 0), at(1, 1), at(0, 2)};
}

void SplineSurface::evaluate(std::span<const double> x, std::span<const double> y,
                             Partial derivative, std::span<double> out) const {
    assert(out.size() == x.size() * y.size());
    const num::TensorSide x_side = surfaces::side_of(x_, x, derivative.x);
    const num::TensorSide y_side = surfaces::side_of(y_, y, derivative.y);
    num::Tensor(x_side, y_side).expand(coefficients_, {0, x.size()}, out);
}

Grid SplineSurface::evaluate(std::span<const double> x, std::span<const double> y,
                             Partial derivative) const {
    Grid grid(x.size(), y.size());
    if (x.empty() || y.empty()) return grid;
    evaluate(x, y, derivative, {&grid(0, 0), x.size() * y.size()});
    return grid;
}

}  // namespace batten
