#include "batten/shape/curved_knot_surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "num/cox_de_boor.hpp"

namespace batten {
namespace {

constexpr double together = 1e-12;  // of the domain: lines nearer than this run together

void require_lines(std::span<const SplineFunction> lines, Interval domain, const char* name) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Interval own = lines[i].domain();
        if (own.lo <= domain.lo && domain.hi <= own.hi) continue;
        throw Error("surface.lines", std::string(name) + ' ' + std::to_string(i),
                    format_number(own.lo) + " to " + format_number(own.hi),
                    "a knot line covers the whole domain");
    }
}

/// The splines that are not zero at one place.
struct LocalSplines {
    double values[num::most_order];
    std::size_t first = 0;
};

LocalSplines splines_at(std::span<const SplineFunction> lines, double along, double at,
                        Interval domain, int degree) {
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    std::vector<double> knots(order, domain.lo);
    for (const SplineFunction& line : lines) knots.push_back(domain.clamp(line(along)));
    std::sort(knots.begin() + static_cast<std::ptrdiff_t>(order), knots.end());
    knots.insert(knots.end(), order, domain.hi);
    const double near = together * domain.length();
    for (std::size_t i = order; i < knots.size(); ++i) {
        if (knots[i] - knots[i - 1] <= near) knots[i] = knots[i - 1];
    }
    for (std::size_t i = knots.size(); i-- > 0 && domain.hi - knots[i] <= near;) {
        knots[i] = domain.hi;
    }
    const auto inside = knots.begin() + static_cast<std::ptrdiff_t>(order) - 1;
    auto right = std::upper_bound(inside, knots.end(), at);
    if (right == knots.end()) right = std::lower_bound(inside, knots.end(), domain.hi);
    const std::size_t span = static_cast<std::size_t>(right - knots.begin()) - 1;
    LocalSplines local;
    local.first = span + 1 - order;
    num::basis_values(knots, span, degree + 1, at, local.values);
    return local;
}

}  // namespace

CurvedKnotSurface::CurvedKnotSurface(int degree, const Rectangle& domain,
                                     std::vector<SplineFunction> x_lines,
                                     std::vector<SplineFunction> y_lines,
                                     std::vector<double> coefficients)
    : degree_(degree), domain_(domain), x_lines_(std::move(x_lines)),
      y_lines_(std::move(y_lines)), coefficients_(std::move(coefficients)) {
    if (degree < 0 || degree > BSplineBasis::most_degree) {
        throw Error("surface.degree", "surface", std::to_string(degree),
                    "must lie between 0 and 25");
    }
    if (!(domain.x.lo < domain.x.hi) || !(domain.y.lo < domain.y.hi)) {
        throw Error("surface.lines", "domain", "no area", "the domain must have an area");
    }
    require_lines(x_lines_, domain.y, "x line");
    require_lines(y_lines_, domain.x, "y line");
    const std::size_t order = static_cast<std::size_t>(degree) + 1;
    const std::size_t needed = (x_lines_.size() + order) * (y_lines_.size() + order);
    const bool is_finite = std::all_of(coefficients_.begin(), coefficients_.end(),
                                       [](double c) { return std::isfinite(c); });
    if (coefficients_.size() != needed || !is_finite) {
        throw Error("surface.coefficients", "surface", std::to_string(coefficients_.size()),
                    std::to_string(needed) + " finite ones are needed");
    }
}

double CurvedKnotSurface::operator()(double x, double y) const {
    x = domain_.x.clamp(x);
    y = domain_.y.clamp(y);
    const LocalSplines a = splines_at(x_lines_, y, x, domain_.x, degree_);
    const LocalSplines b = splines_at(y_lines_, x, y, domain_.y, degree_);
    const std::size_t order = static_cast<std::size_t>(degree_) + 1;
    const std::size_t width = y_lines_.size() + order;
    double sum = 0;
    for (std::size_t i = 0; i < order; ++i) {
        const double* const c = coefficients_.data() + (a.first + i) * width + b.first;
        double row = 0;
        for (std::size_t j = 0; j < order; ++j) row += c[j] * b.values[j];
        sum += a.values[i] * row;
    }
    return sum;
}

}  // namespace batten
