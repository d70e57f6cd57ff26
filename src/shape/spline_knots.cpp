#include <algorithm>
#include <array>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/spline_function.hpp"
#include "num/banded_qr.hpp"
#include "shape/knots.hpp"

/// The same function in other B-splines: more knots, fewer knots, a higher degree.
namespace batten {
namespace {

/// The blossom of the polynomial on knots()[span] ... knots()[span + 1]: symmetric, affine in each
/// of its `degree` arguments, equal to the polynomial where all are equal.
/// Source: [Ramshaw1989].
double blossom(const SplineFunction& s, std::size_t span, std::span<const double> arguments) {
    const std::span<const double> t = s.knots();
    const int degree = s.degree();
    std::array<double, knots::most_order> d;
    for (int j = 0; j <= degree; ++j) d[j] = s.coefficients()[span - degree + j];
    for (int level = 1; level <= degree; ++level) {
        const double at = arguments[level - 1];
        for (int j = 0; j + level <= degree; ++j) {
            const double lo = t[span - degree + level + j];
            const double hi = t[span + 1 + j];
            d[j] = ((hi - at) * d[j] + (at - lo) * d[j + 1]) / (hi - lo);
        }
    }
    return d[0];
}

/// The knot span of `s` for new function `first` over `knots`: that of the stretch of positive
/// length nearest to the middle of the function's support, where the blossom is stablest.
std::size_t span_near(const SplineFunction& s, std::span<const double> knots, std::size_t first,
                      std::size_t degree) {
    const Interval domain = s.domain();
    const std::size_t middle = first + degree / 2;
    std::size_t best = first;
    std::size_t best_distance = knots.size();
    for (std::size_t i = first; i <= first + degree; ++i) {
        const bool is_inside = knots[i] < knots[i + 1] && knots[i + 1] > domain.lo &&
                               knots[i] < domain.hi;
        const std::size_t distance = i > middle ? i - middle : middle - i;
        if (is_inside && distance < best_distance) {
            best = i;
            best_distance = distance;
        }
    }
    const double at = domain.clamp(knots[best] + 0.5 * (knots[best + 1] - knots[best]));
    const std::span<const double> t = s.knots();
    const auto from = t.begin() + s.degree() + 1;
    const auto to = t.begin() + static_cast<std::ptrdiff_t>(s.coefficients().size());
    return static_cast<std::size_t>(std::upper_bound(from, to, at) - t.begin()) - 1;
}

/// The same function over `knots`, which must hold those of `s` inside its domain.
SplineFunction refined(const SplineFunction& s, std::vector<double> knots) {
    const std::size_t degree = static_cast<std::size_t>(s.degree());
    std::vector<double> c(knots.size() - degree - 1);
    for (std::size_t j = 0; j < c.size(); ++j) {
        const std::span<const double> inner(knots.data() + j + 1, degree);
        c[j] = blossom(s, span_near(s, knots, j, degree), inner);
    }
    return {std::move(knots), std::move(c), s.degree()};
}

/// The knots inside the open domain.
std::vector<double> interior_knots(const SplineFunction& s) {
    std::vector<double> inside;
    for (const double t : s.knots()) {
        if (t > s.domain().lo && t < s.domain().hi) inside.push_back(t);
    }
    return inside;
}

std::vector<double> clamped_knots(Interval domain, std::span<const double> inside, int degree) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, domain.lo);
    knots.insert(knots.end(), inside.begin(), inside.end());
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, domain.hi);
    return knots;
}

}  // namespace

SplineFunction clamped(const SplineFunction& spline) {
    std::vector<double> knots =
        clamped_knots(spline.domain(), interior_knots(spline), spline.degree());
    const std::span<const double> own = spline.knots();
    const bool is_clamped =
        !spline.is_closed() && std::equal(own.begin(), own.end(), knots.begin(), knots.end());
    return is_clamped ? spline : refined(spline, std::move(knots));
}

SplineFunction insert_knots(const SplineFunction& spline, std::span<const double> knots) {
    std::vector<double> inside = interior_knots(spline);
    for (const double t : knots) {
        if (!(t > spline.domain().lo && t < spline.domain().hi)) {
            throw Error("spline.knots", "new knot", format_number(t),
                        "must lie inside the spline's domain");
        }
        inside.insert(std::upper_bound(inside.begin(), inside.end(), t), t);
    }
    return refined(spline, clamped_knots(spline.domain(), inside, spline.degree()));
}

KnotRemoval remove_knot(const SplineFunction& spline, std::size_t index) {
    const SplineFunction from = spline.is_closed() ? clamped(spline) : spline;
    const std::span<const double> t = from.knots();
    const int degree = from.degree();
    if (index >= t.size() || !(t[index] > from.domain().lo && t[index] < from.domain().hi)) {
        throw Error("spline.knots", "index", std::to_string(index),
                    "must be that of a knot inside the domain");
    }
    std::vector<double> fewer(t.begin(), t.end());
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(index));
    const std::size_t last = static_cast<std::size_t>(
        std::upper_bound(fewer.begin(), fewer.end(), t[index]) - fewer.begin()) - 1;
    // Row i says how c[i] comes from the new coefficients i - 1 and i, if the knot were inserted.
    const int columns = static_cast<int>(from.coefficients().size()) - 1;
    num::BandedQr system({2, columns, 0, 1});
    std::vector<double> shares(static_cast<std::size_t>(columns) + 1);
    for (int i = 0; i <= columns; ++i) {
        double share = 0;  // of the new coefficient i
        const int span = static_cast<int>(last);
        if (i <= span - degree) {
            share = 1;
        } else if (i <= span) {
            share = (t[index] - fewer[i]) / (fewer[i + degree] - fewer[i]);
        }
        shares[i] = share;
        const int first = std::min(std::max(i - 1, 0), columns - 2);
        std::array<double, 3> row{0, 0, from.coefficients()[i]};
        if (i - 1 >= 0) row[i - 1 - first] += 1 - share;
        if (i < columns) row[i - first] += share;
        system.absorb(first, row.data(), 1);
    }
    system.finish();
    std::vector<double> c(static_cast<std::size_t>(columns));
    system.solve(0, c);
    double change = 0;  // the coefficients' change bounds the function's
    for (int i = 0; i <= columns; ++i) {
        double back = 0;
        if (i - 1 >= 0) back += (1 - shares[i]) * c[i - 1];
        if (i < columns) back += shares[i] * c[i];
        change = std::max(change, std::fabs(back - from.coefficients()[i]));
    }
    return {SplineFunction(std::move(fewer), std::move(c), degree), change};
}

SplineFunction elevate_degree(const SplineFunction& spline, int by) {
    if (by < 1 || spline.degree() + by > knots::most_order - 1) {
        throw Error("spline.degree", "by", std::to_string(by),
                    "must be positive and lead to degree 25 at most");
    }
    const std::size_t degree = static_cast<std::size_t>(spline.degree());
    std::vector<double> inside;
    const std::vector<double> before = interior_knots(spline);
    for (std::size_t i = 0; i < before.size(); ++i) {
        inside.push_back(before[i]);
        if (i + 1 == before.size() || before[i + 1] != before[i]) inside.push_back(before[i]);
    }
    std::vector<double> knots =
        clamped_knots(spline.domain(), inside, static_cast<int>(degree) + 1);
    std::vector<double> c(knots.size() - degree - 2);
    std::array<double, knots::most_order> arguments;
    for (std::size_t j = 0; j < c.size(); ++j) {
        const std::size_t span = span_near(spline, knots, j, degree + 1);
        double sum = 0;
        for (std::size_t without = 0; without <= degree; ++without) {
            for (std::size_t i = 0, n = 0; i <= degree; ++i) {
                if (i != without) arguments[n++] = knots[j + 1 + i];
            }
            sum += blossom(spline, span, {arguments.data(), degree});
        }
        c[j] = sum / static_cast<double>(degree + 1);
    }
    SplineFunction higher(std::move(knots), std::move(c), static_cast<int>(degree) + 1);
    return by == 1 ? higher : elevate_degree(higher, by - 1);
}

}  // namespace batten
