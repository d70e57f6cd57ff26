#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/interval.hpp"
#include "batten/shape/curve.hpp"

/// One coordinate of a curve as a function of its parameter, in the sense of y(x).
///
/// All functions throw `curve.coordinate` unless 0 <= coordinate < dim, and `curve.not-finite`.
/// On polynomial pieces nothing is missed; other curves are followed by polynomials first.
namespace batten {

/// The integral of a coordinate over the parameter from part.lo to part.hi; with the opposite sign
/// if part.lo > part.hi. Exact but for rounding on polynomial pieces. Throws `curve.outside`.
double integral(const Curve& curve, int coordinate, Interval part);

/// All parameters where the coordinate has `value`, rising: crossings and touches. Where it keeps
/// the value over whole pieces: the ends of these pieces. The seam of a closed curve is listed
/// once. Accuracy: rounding of the coordinate / slope.
std::vector<double> roots(const Curve& curve, int coordinate, double value);

enum class ExtremumKind { minimum, maximum };

constexpr std::array<Named<ExtremumKind>, 2> names_of(ExtremumKind) {
    return {{{"minimum", ExtremumKind::minimum}, {"maximum", ExtremumKind::maximum}}};
}

struct Extremum {
    double t = 0;
    double value = 0;
    ExtremumKind kind = ExtremumKind::maximum;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, Extremum>
void visit_fields(Report& r, Visit&& visit) {
    visit("t", r.t, "where the coordinate stops rising or falling");
    visit("value", r.value, "the coordinate there");
    visit("kind", r.kind, "minimum or maximum");
}

/// The local extrema inside the domain, rising in t; corners included, and of a flat stretch
/// between a rise and a fall its middle. The ends of the domain are none.
std::vector<Extremum> extrema(const Curve& curve, int coordinate);

/// The smallest and the largest value of the coordinate over the whole domain.
Interval range(const Curve& curve, int coordinate);

}  // namespace batten
