#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/base/progress.hpp"

namespace batten {

/// How a curve goes through points. docs/interpolation.md says what each is good for.
enum class Method {
    pseudo_spline,         ///< tangents and speeds of least E L^2, point by point [InoueShibata]
    pseudo_spline_global,  ///< ... all tangents together
    natural_uniform,       ///< natural cubic spline, one unit of the parameter a chord
    natural_chord,         ///< natural cubic spline, the parameter grows as the chords
    hermite_chord,         ///< cubics with tangents along the chord of the neighbours
    hermite_arc,           ///< cubics with tangents of the circle through three points
    spline,                ///< cubic spline with the ends and the parameter asked for
    pchip,                 ///< y(x): monotone where the points are
    makima,                ///< y(x): few oscillations
    lagrange_2,            ///< moving windows of three points [Nakajima]: tangents jump
    lagrange_3,            ///< ... of four points
    arc_chain,             ///< one circular arc a chord, tangents joined [Nakajima, section 5]
    log_aesthetic,         ///< one log-aesthetic arc a span, curvature continuous
};

constexpr std::array<Named<Method>, 13> names_of(Method) {
    return {{{"pseudo-spline", Method::pseudo_spline},
             {"pseudo-spline-global", Method::pseudo_spline_global},
             {"natural-uniform", Method::natural_uniform},
             {"natural-chord", Method::natural_chord},
             {"hermite-chord", Method::hermite_chord},
             {"hermite-arc", Method::hermite_arc},
             {"spline", Method::spline},
             {"pchip", Method::pchip},
             {"makima", Method::makima},
             {"lagrange-2", Method::lagrange_2},
             {"lagrange-3", Method::lagrange_3},
             {"arc-chain", Method::arc_chain},
             {"log-aesthetic", Method::log_aesthetic}}};
}

/// What an open spline does at its two ends.
enum class Ends {
    natural,     ///< no curvature: the second derivative is 0
    clamped,     ///< the direction is given, or that of the first and last chord
    not_a_knot,  ///< the first two pieces, and the last two, are one cubic
};

constexpr std::array<Named<Ends>, 3> names_of(Ends) {
    return {
        {{"natural", Ends::natural}, {"clamped", Ends::clamped}, {"not-a-knot", Ends::not_a_knot}}};
}

/// How fast the parameter of a spline or of a lagrange method grows from point to point.
enum class Parameter {
    uniform,      ///< 1 a chord
    chord,        ///< the chord's length
    centripetal,  ///< its square root, in units of the longest chord
};

constexpr std::array<Named<Parameter>, 3> names_of(Parameter) {
    return {{{"uniform", Parameter::uniform},
             {"chord", Parameter::chord},
             {"centripetal", Parameter::centripetal}}};
}

constexpr double most_weight_exponent = 8;
constexpr double most_alpha = 20;

/// What is asked of a curve through points; `visit_fields` says what each member means.
struct InterpolateOptions {
    Method method = Method::pseudo_spline;
    Ends ends = Ends::natural;
    std::optional<Parameter> parameter;
    std::vector<double> parameter_values;
    bool exact = false;
    bool closed = false;
    std::vector<int> corner;
    std::vector<FixedTangent> tangent;
    double weight_exponent = 1;
    double alpha = -1;
    std::optional<IndexRange> part;
    Progress progress = {};
};

template <class Options, class Visit>
requires std::same_as<std::remove_const_t<Options>, InterpolateOptions>
void visit_fields(Options& o, Visit&& visit) {
    visit("method", o.method, anything, "how the curve goes through the points");
    visit("ends", o.ends, anything, "what an open spline does at its ends (method spline)");
    visit("parameter", o.parameter, anything,
          "how the parameter grows from point to point (spline: chord unless given; lagrange methods: "
          "uniform)");
    visit("parameter_values", o.parameter_values, anything,
          "the parameters themselves, strictly increasing, one a point; closed: one more, where "
          "the curve comes back (spline and lagrange methods)");
    visit("exact", o.exact, anything,
          "find the tangents and speeds of a pseudo-spline by minimisation, without tables");
    visit("closed", o.closed, anything, "go on from the last point to the first");
    visit("corner", o.corner, anything,
          "the points, from 0, where the curve may break its direction (pseudo-spline, hermite "
          "and log-aesthetic methods)");
    visit("tangent", o.tangent, anything,
          "directions fixed at points, from 0 (pseudo-spline, hermite and log-aesthetic methods; the "
          "two ends of an open clamped spline; the start of an arc-chain)");
    visit("weight_exponent", o.weight_exponent,
          between(-most_weight_exponent, most_weight_exponent),
          "how chord lengths weigh in a pseudo-spline's tangents: 1 as in the paper, -1 for evenly "
          "curved arcs through uneven points");
    visit("alpha", o.alpha, between(-most_alpha, most_alpha),
          "the kind of the arcs of method log-aesthetic: -1 clothoids, 0 Nielsen's and 1 logarithmic "
          "spirals, 2 circle involutes");
    visit("part", o.part, anything,
          "keep the curve between two points only, after it has been made through all of them");
}

}  // namespace batten
