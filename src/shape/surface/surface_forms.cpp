#include <algorithm>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/spline_surface.hpp"
#include "num/gauss.hpp"
#include "shape/surface/inside.hpp"
#include "shape/surface/sides.hpp"

namespace batten {

namespace surfaces {

num::TensorSide side_of(const BSplineBasis& basis, std::span<const double> places,
                        int derivative) {
    const std::size_t order = static_cast<std::size_t>(basis.degree()) + 1;
    num::TensorSide side{basis.degree() + 1, basis.size(), {}, {}};
    side.first.resize(places.size());
    side.values.resize(places.size() * order);
    std::vector<double> rows(static_cast<std::size_t>(derivative + 1) * order);
    for (std::size_t r = 0; r < places.size(); ++r) {
        const std::size_t span = basis.span_of(places[r]);
        side.first[r] = span + 1 - order;
        basis.nonzero_on(span, places[r], derivative, rows);
        std::copy_n(rows.end() - static_cast<std::ptrdiff_t>(order), order,
                    side.values.begin() + static_cast<std::ptrdiff_t>(r * order));
    }
    return side;
}

void require_inside(Interval domain, Interval part, const char* axis) {
    if (part.lo <= part.hi && domain.contains(part.lo) && domain.contains(part.hi)) return;
    throw Error("surface.outside", axis,
                format_number(part.lo) + " to " + format_number(part.hi),
                "must lie in the surface's domain [" + format_number(domain.lo) + ", " +
                    format_number(domain.hi) + "]");
}

}  // namespace surfaces

namespace {

using surfaces::require_inside;

/// The integral of every function of a basis over `part`.
std::vector<double> function_integrals(const BSplineBasis& basis, Interval part) {
    std::vector<double> sums(basis.size(), 0.0);
    const std::size_t order = static_cast<std::size_t>(basis.degree()) + 1;
    const num::GaussRule rule = num::gauss_legendre(basis.degree() / 2 + 1);
    std::vector<double> values(order);
    for (std::size_t piece = 0; piece + 1 < basis.breaks().size(); ++piece) {
        const Interval common{std::max(part.lo, basis.breaks()[piece]),
                              std::min(part.hi, basis.breaks()[piece + 1])};
        if (!(common.lo < common.hi)) continue;
        const std::size_t span = basis.span_of_piece(piece);
        for (std::size_t q = 0; q < rule.nodes.size(); ++q) {
            const double half = 0.5 * common.length();
            basis.nonzero_on(span, common.middle() + half * rule.nodes[q], 0, values);
            for (std::size_t j = 0; j < order; ++j) {
                sums[span + 1 - order + j] += half * rule.weights[q] * values[j];
            }
        }
    }
    return sums;
}

/// Bezier ordinates of one piece: `c` are the coefficients of its functions, `step` apart.
void to_bezier(const BSplineBasis& basis, std::size_t span, const double* c, std::size_t step,
               double* out) {
    const int degree = basis.degree();
    const double* const t = basis.knots().data() + span;
    double d[BSplineBasis::most_degree + 1];
    for (int m = 0; m <= degree; ++m) {
        for (int i = 0; i <= degree; ++i) d[i] = c[static_cast<std::size_t>(i) * step];
        for (int level = 1; level <= degree; ++level) {
            const double u = level <= degree - m ? t[0] : t[1];
            for (int i = degree; i >= level; --i) {
                const double left = t[i - degree], right = t[i - level + 1];
                const double share = (u - left) / (right - left);
                d[i] = (1 - share) * d[i - 1] + share * d[i];
            }
        }
        out[static_cast<std::size_t>(m) * step] = d[degree];
    }
}

std::vector<double> patch_heights(const SplineSurface& surface, std::size_t x_span,
                                  std::size_t y_span) {
    const std::size_t x_order = static_cast<std::size_t>(surface.x_basis().degree()) + 1;
    const std::size_t y_order = static_cast<std::size_t>(surface.y_basis().degree()) + 1;
    std::vector<double> heights(x_order * y_order);
    for (std::size_t i = 0; i < x_order; ++i) {
        for (std::size_t j = 0; j < y_order; ++j) {
            heights[i * y_order + j] =
                surface.coefficient(x_span + 1 - x_order + i, y_span + 1 - y_order + j);
        }
    }
    std::vector<double> from = heights;
    for (std::size_t i = 0; i < x_order; ++i) {
        to_bezier(surface.y_basis(), y_span, from.data() + i * y_order, 1,
                  heights.data() + i * y_order);
    }
    from = heights;
    for (std::size_t j = 0; j < y_order; ++j) {
        to_bezier(surface.x_basis(), x_span, from.data() + j, y_order, heights.data() + j);
    }
    return heights;
}

}  // namespace

double integral(const SplineSurface& surface, const Rectangle& part) {
    require_inside(surface.domain().x, part.x, "x");
    require_inside(surface.domain().y, part.y, "y");
    const std::vector<double> a = function_integrals(surface.x_basis(), part.x);
    const std::vector<double> b = function_integrals(surface.y_basis(), part.y);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        double row = 0;
        for (std::size_t j = 0; j < b.size(); ++j) row += surface.coefficient(i, j) * b[j];
        sum += a[i] * row;
    }
    return sum;
}

double integral(const SplineSurface& surface) { return integral(surface, surface.domain()); }

SplineFunction section_at_y(const SplineSurface& surface, double y) {
    require_inside(surface.domain().y, {y, y}, "y");
    const BSplineBasis& basis = surface.x_basis();
    const double places[] = {y};
    const num::TensorSide side = surfaces::side_of(surface.y_basis(), places);
    std::vector<double> c(basis.size(), 0.0);
    for (std::size_t i = 0; i < c.size(); ++i) {
        for (int j = 0; j < side.order; ++j) {
            c[i] += side.values[static_cast<std::size_t>(j)] *
                    surface.coefficient(i, side.first[0] + static_cast<std::size_t>(j));
        }
    }
    return {{basis.knots().begin(), basis.knots().end()}, std::move(c), basis.degree()};
}

SplineFunction section_at_x(const SplineSurface& surface, double x) {
    require_inside(surface.domain().x, {x, x}, "x");
    const BSplineBasis& basis = surface.y_basis();
    const double places[] = {x};
    const num::TensorSide side = surfaces::side_of(surface.x_basis(), places);
    std::vector<double> c(basis.size(), 0.0);
    for (int i = 0; i < side.order; ++i) {
        for (std::size_t j = 0; j < c.size(); ++j) {
            c[j] += side.values[static_cast<std::size_t>(i)] *
                    surface.coefficient(side.first[0] + static_cast<std::size_t>(i), j);
        }
    }
    return {{basis.knots().begin(), basis.knots().end()}, std::move(c), basis.degree()};
}

std::vector<BezierPatch> bezier_patches(const SplineSurface& surface) {
    const BSplineBasis &x = surface.x_basis(), &y = surface.y_basis();
    std::vector<BezierPatch> patches;
    for (std::size_t i = 0; i + 1 < x.breaks().size(); ++i) {
        for (std::size_t j = 0; j + 1 < y.breaks().size(); ++j) {
            const Rectangle part{{x.breaks()[i], x.breaks()[i + 1]},
                                 {y.breaks()[j], y.breaks()[j + 1]}};
            patches.push_back(
                {part, patch_heights(surface, x.span_of_piece(i), y.span_of_piece(j))});
        }
    }
    return patches;
}

std::vector<double> even_places(Interval range, std::size_t count) {
    std::vector<double> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 1);
        places[i] = range.clamp(range.lo + share * range.length());
    }
    places.back() = range.hi;
    return places;
}

}  // namespace batten
