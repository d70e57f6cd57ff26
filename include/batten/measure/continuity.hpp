#pragma once

#include <array>
#include <concepts>
#include <type_traits>
#include <vector>

#include "batten/base/fields.hpp"
#include "batten/shape/curve.hpp"

namespace batten {

/// How smoothly two pieces meet. Each grade includes those before it, except that G2 does not ask
/// for C1: a joint whose curvature agrees while the speed jumps is G2.
enum class Continuity {
    gap,  ///< the ends are apart
    C0,   ///< the ends meet
    G1,   ///< the tangents agree
    C1,   ///< the first derivatives agree
    G2,   ///< tangents and curvatures agree
    C2,   ///< the first and second derivatives agree
};

constexpr std::array<Named<Continuity>, 6> names_of(Continuity) {
    return {{{"gap", Continuity::gap},
             {"C0", Continuity::C0},
             {"G1", Continuity::G1},
             {"C1", Continuity::C1},
             {"G2", Continuity::G2},
             {"C2", Continuity::C2}}};
}

/// What is present at one joint.
struct Joint {
    double t = 0;
    Continuity continuity = Continuity::C0;
};

template <class Report, class Visit>
    requires std::same_as<std::remove_const_t<Report>, Joint>
void visit_fields(Report& joint, Visit&& visit) {
    visit("t", joint.t, "parameter of the joint");
    visit("continuity", joint.continuity, "the highest grade present there");
}

/// The continuity at every inner break, in order; for a closed curve the seam comes first, at the
/// start of the domain.
///
/// Two numbers agree when they differ by less than 1e-8 of the scale they have at the joint, or
/// by the rounding of the coordinates. The scales: the extent for points; for first derivatives
/// v, the larger of speed and chord / h of the two pieces, h being the shorter piece's length in
/// t; v / h for second derivatives; 1 for directions; 1 / (v h) or the curvature itself for
/// curvatures.
///
/// Cost: 2 jets a joint. Throws: `curve.not-finite`.
std::vector<Joint> continuity(const Curve& curve);

}  // namespace batten
