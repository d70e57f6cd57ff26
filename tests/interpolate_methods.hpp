#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "batten/make/interpolate.hpp"
#include "random.hpp"

/// Methods of interpolation with their options, points for them, and how far their curves differ.
namespace batten::testing {

struct Asked {
    std::string name;
    InterpolateOptions options;
};

inline Asked method(Method m, bool closed = false) {
    Asked asked{std::string(name_of(m)), {}};
    asked.options.method = m;
    asked.options.closed = closed;
    if (closed) asked.name += " closed";
    return asked;
}

inline Asked spline(Ends ends, Parameter parameter) {
    Asked asked = method(Method::spline);
    asked.options.ends = ends;
    asked.options.parameter = parameter;
    asked.name += " " + std::string(name_of(ends)) + " " + std::string(name_of(parameter));
    return asked;
}

inline std::vector<Asked> hermite_types(bool closed) {
    return {method(Method::hermite_chord, closed), method(Method::hermite_arc, closed),
            method(Method::pseudo_spline, closed)};
}

/// All methods that take any points of the plane, global ones last.
inline std::vector<Asked> planar_methods() {
    std::vector<Asked> all = hermite_types(false);
    for (const Asked& closed : hermite_types(true)) all.push_back(closed);
    for (const Parameter p : {Parameter::uniform, Parameter::chord, Parameter::centripetal}) {
        for (const Ends e : {Ends::natural, Ends::clamped, Ends::not_a_knot}) {
            all.push_back(spline(e, p));
        }
        all.push_back(spline(Ends::natural, p));
        all.back().options.closed = true;
        all.back().name += " closed";
    }
    all.push_back(method(Method::natural_uniform));
    all.push_back(method(Method::natural_chord));
    all.push_back(method(Method::pseudo_spline_global));
    all.push_back(method(Method::pseudo_spline_global, true));
    return all;
}

inline std::vector<Asked> all_methods() {
    std::vector<Asked> all = planar_methods();
    all.push_back(method(Method::pchip));
    all.push_back(method(Method::makima));
    return all;
}

inline bool is_function(const Asked& asked) {
    return asked.options.method == Method::pchip || asked.options.method == Method::makima;
}

/// A walk that turns by up to 150 degrees, or rises in x where the method asks for it.
inline Points outline(Random& random, std::size_t count, const Asked& asked) {
    Points points(count, 2);
    double x = 0, y = 0, angle = 0;
    for (std::size_t i = 0; i < count; ++i) {
        points(i, 0) = x;
        points(i, 1) = y;
        angle += random.within(-2.6, 2.6);
        const double step = random.within(0.3, 1);
        x += is_function(asked) ? step : step * std::cos(angle);
        y += step * std::sin(angle);
    }
    return points;
}

/// The share of a piece where curves are compared.
inline constexpr double shares[] = {0.0, 0.25, 0.625, 1.0};

inline std::vector<double> at(const Curve& curve, std::size_t piece, double share, int order = 0) {
    const Interval part = curve.piece(piece);
    const Jet jet =
        curve.jet_on(piece, share == 1 ? part.hi : part.lo + share * part.length(), order);
    return {jet[order].begin(), jet[order].end()};
}

/// Largest distance at the same places of the same pieces, in the second curve's pieces `shift`
/// later, counted around.
inline double distance(const Curve& a, const Curve& b, std::size_t shift = 0) {
    double largest = 0;
    for (std::size_t i = 0; i < a.pieces(); ++i) {
        for (const double share : shares) {
            const auto p = at(a, i, share), q = at(b, (i + shift) % b.pieces(), share);
            for (std::size_t k = 0; k < p.size(); ++k) {
                largest = std::max(largest, std::fabs(p[k] - q[k]));
            }
        }
    }
    return largest;
}

}  // namespace batten::testing
