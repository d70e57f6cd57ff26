#pragma once

#include <array>
#include <span>
#include <string_view>

namespace batten {

/// F(x, y) = A x^3 + B y^3 + C x^2 y + D x y^2 + E x^2 + F y^2 + G x y + H x + I y + J, which is 0
/// on a plane parametric cubic [HaradaNakamae, eq. 2 and table 1].
///
/// F is 0 everywhere where both cubic coefficients are 0 and where the piece is straight; and it
/// loses digits away from the origin (some 7 at 1e5 times the size). On the curve
/// F_x / F_y = -y' / x', so nothing needs it but the paper.
struct ImplicitCubic {
    std::array<double, 10> coefficients{};  ///< A ... J

    double operator()(double x, double y) const;
    /// The partial derivatives [HaradaNakamae, eq. 9].
    double along_x(double x, double y) const;
    double along_y(double x, double y) const;
};

/// From x = a0 + a1 t + a2 t^2 + a3 t^3 and likewise y: Sylvester's determinant, 6 x 6. Best in
/// coordinates relative to the piece's start.
ImplicitCubic implicit_cubic(const std::array<double, 4>& a, const std::array<double, 4>& b);

/// One product of the determinant.
struct ImplicitTerm {
    char coefficient;          ///< 'A' ... 'J'
    int factor;
    std::string_view factors;  ///< "a0b3b3b3"
};

/// All 102 of them.
std::span<const ImplicitTerm> implicit_terms();

}  // namespace batten
