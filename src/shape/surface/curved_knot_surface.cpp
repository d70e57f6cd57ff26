#include "batten/shape/curved_knot_surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "shape/surface/series.hpp"

namespace batten {
namespace {

using surfaces::Series;

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

/// Lines of one direction, seen from a place: `at` across them, `along` them.
struct Bundle {
    std::span<const SplineFunction> lines;
    Interval domain;
    double along, at;
    std::size_t interval;
    bool is_x;  ///< whether `at` is x
};

/// A line's place and its derivatives along itself over their factorials.
template <std::size_t N>
using Knot = std::array<double, N + 1>;

template <std::size_t N>
Knot<N> knot_of(const SplineFunction& line, double along, Interval domain) {
    Knot<N> knot{};
    knot[0] = domain.clamp(line(along));
    if (!(domain.lo < knot[0] && knot[0] < domain.hi)) return knot;
    double factorial = 1;
    for (std::size_t r = 1; r <= N; ++r) {
        factorial *= static_cast<double>(r);
        knot[r] = line(along, static_cast<int>(r)) / factorial;
    }
    return knot;
}

/// The ends of the domain `order` times and the lines between them, rising.
template <std::size_t N>
std::vector<Knot<N>> knots_of(const Bundle& bundle, std::size_t order) {
    const Interval domain = bundle.domain;
    std::vector<Knot<N>> knots(order, Knot<N>{domain.lo});
    knots.reserve(bundle.lines.size() + 2 * order);
    for (const SplineFunction& line : bundle.lines) {
        knots.push_back(knot_of<N>(line, bundle.along, domain));
    }
    // Lines that touch stand in the order that they have behind the touching.
    std::sort(knots.begin() + static_cast<std::ptrdiff_t>(order), knots.end());
    knots.insert(knots.end(), order, Knot<N>{domain.hi});
    const double near = together * domain.length();
    for (std::size_t i = order; i < knots.size(); ++i) {
        if (knots[i][0] - knots[i - 1][0] <= near) knots[i][0] = knots[i - 1][0];
    }
    for (std::size_t i = knots.size(); i-- > 0 && domain.hi - knots[i][0] <= near;) {
        knots[i] = Knot<N>{domain.hi};
    }
    return knots;
}

/// The span asked for, or the one that holds the place.
template <std::size_t N>
std::size_t span_of(const std::vector<Knot<N>>& knots, const Bundle& bundle, std::size_t order) {
    const std::size_t asked = order - 1 + bundle.interval;
    if (bundle.interval != KnotCell::found && knots[asked][0] < knots[asked + 1][0]) return asked;
    const auto inside = knots.begin() + static_cast<std::ptrdiff_t>(order) - 1;
    auto right = std::upper_bound(inside, knots.end(), bundle.at,
                                  [](double at, const Knot<N>& knot) { return at < knot[0]; });
    if (right == knots.end()) {
        right = std::lower_bound(inside, knots.end(), bundle.domain.hi,
                                 [](const Knot<N>& knot, double at) { return knot[0] < at; });
    }
    return static_cast<std::size_t>(right - knots.begin()) - 1;
}

/// The splines that are not zero at one place.
template <std::size_t N>
struct LocalSplines {
    Series<N> values[BSplineBasis::most_degree + 1];
    std::size_t first = 0;
};

template <std::size_t N>
Series<N> series_of(const Knot<N>& knot, bool is_in_y) {
    Series<N> series;
    for (std::size_t r = 0; r <= N; ++r) series.term(r, is_in_y ? r : 0) = knot[r];
    return series;
}

/// The recurrence of the B-splines [DeBoor2001, X(9)], knots and place as Taylor series.
template <std::size_t N>
void find_splines(const Bundle& bundle, std::size_t order, LocalSplines<N>& local) {
    const std::vector<Knot<N>> knots = knots_of<N>(bundle, order);
    const std::size_t span = span_of<N>(knots, bundle, order);
    local.first = span + 1 - order;
    Knot<N> place{bundle.at};
    if constexpr (N > 0) place[1] = 1;
    const Series<N> at = series_of<N>(place, !bundle.is_x);
    Series<N> left[BSplineBasis::most_degree + 1], right[BSplineBasis::most_degree + 1];
    local.values[0] = Series<N>{};
    local.values[0].c[0] = 1;
    for (std::size_t j = 1; j < order; ++j) {
        const Series<N> below = series_of<N>(knots[span + 1 - j], bundle.is_x);
        const Series<N> above = series_of<N>(knots[span + j], bundle.is_x);
        left[j] = at - below;
        right[j] = above - at;
        Series<N> saved;
        for (std::size_t r = 0; r < j; ++r) {
            const Series<N> gap = series_of<N>(knots[span + r + 1], bundle.is_x) -
                                  series_of<N>(knots[span + 1 + r - j], bundle.is_x);
            const Series<N> share = local.values[r] / gap;
            local.values[r] = right[r + 1] * share;
            local.values[r] += saved;
            saved = left[j - r] * share;
        }
        local.values[j] = saved;
    }
}

/// The surface's Taylor series at a place.
template <std::size_t N>
Series<N> series_at(const CurvedKnotSurface& s, KnotCell cell, double x, double y) {
    const Rectangle& domain = s.domain();
    x = domain.x.clamp(x);
    y = domain.y.clamp(y);
    const std::size_t order = static_cast<std::size_t>(s.degree()) + 1;
    LocalSplines<N> a, b;
    find_splines<N>({s.x_lines(), domain.x, y, x, cell.x, true}, order, a);
    find_splines<N>({s.y_lines(), domain.y, x, y, cell.y, false}, order, b);
    const std::size_t width = s.y_lines().size() + order;
    Series<N> sum;
    for (std::size_t i = 0; i < order; ++i) {
        const double* const c = s.coefficients().data() + (a.first + i) * width + b.first;
        Series<N> row;
        for (std::size_t j = 0; j < order; ++j) row.add(c[j], b.values[j]);
        sum += a.values[i] * row;
    }
    return sum;
}

template <std::size_t N>
double derivative_at(const CurvedKnotSurface& s, double x, double y, Partial derivative) {
    const std::size_t total = static_cast<std::size_t>(derivative.x + derivative.y);
    double factor = 1;
    for (const int order : {derivative.x, derivative.y}) {
        for (int r = 2; r <= order; ++r) factor *= r;
    }
    return factor * series_at<N>(s, {}, x, y).term(total, static_cast<std::size_t>(derivative.y));
}

std::vector<double> places_of(const Bundle& bundle) {
    std::vector<double> places;
    for (const Knot<0>& knot : knots_of<0>(bundle, 1)) places.push_back(knot[0]);
    return places;
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

double CurvedKnotSurface::operator()(double x, double y, Partial derivative) const {
    const int total = derivative.x + derivative.y;
    if (total > most_derivatives) {
        throw Error("surface.derivative", "derivative",
                    std::to_string(derivative.x) + ',' + std::to_string(derivative.y),
                    "where knot lines are curved, derivatives go up to order 9 in all");
    }
    if (total == 0) return value_in({}, x, y);
    if (total <= 2) return derivative_at<2>(*this, x, y, derivative);
    return derivative_at<most_derivatives>(*this, x, y, derivative);
}

double CurvedKnotSurface::value_in(KnotCell cell, double x, double y) const {
    return series_at<0>(*this, cell, x, y).c[0];
}

HeightJet CurvedKnotSurface::jet_in(KnotCell cell, double x, double y) const {
    const Series<2> s = series_at<2>(*this, cell, x, y);
    return {s.c[0], s.c[1], s.c[2], 2 * s.c[3], s.c[4], 2 * s.c[5]};
}

std::vector<double> CurvedKnotSurface::x_knots(double y) const {
    return places_of({x_lines_, domain_.x, domain_.y.clamp(y), 0, KnotCell::found, true});
}

std::vector<double> CurvedKnotSurface::y_knots(double x) const {
    return places_of({y_lines_, domain_.y, domain_.x.clamp(x), 0, KnotCell::found, false});
}

CurvedKnotSurface CurvedKnotSurface::transposed() const {
    const std::size_t order = static_cast<std::size_t>(degree_) + 1;
    const std::size_t rows = x_lines_.size() + order, columns = y_lines_.size() + order;
    std::vector<double> c(coefficients_.size());
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) c[j * rows + i] = coefficients_[i * columns + j];
    }
    return {degree_, {domain_.y, domain_.x}, y_lines_, x_lines_, std::move(c)};
}

}  // namespace batten
