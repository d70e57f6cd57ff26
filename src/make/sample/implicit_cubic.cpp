#include "batten/make/implicit_cubic.hpp"

namespace batten {
namespace {

/// [HaradaNakamae, table 1].
constexpr ImplicitTerm terms[] = {
    {'A', 1, "b3b3b3"}, {'B', -1, "a3a3a3"}, {'C', -3, "a3b3b3"}, {'D', 3, "a3a3b3"},
    {'E', -3, "a0b3b3b3"}, {'E', 1, "a1b2b3b3"}, {'E', 2, "a2b1b3b3"}, {'E', -1, "a2b2b2b3"},
    {'E', 3, "a3b0b3b3"}, {'E', -3, "a3b1b2b3"}, {'E', 1, "a3b2b2b2"}, {'F', -3, "a0a3a3b3"},
    {'F', 3, "a1a2a3b3"}, {'F', -2, "a1a3a3b2"}, {'F', -1, "a2a2a2b3"}, {'F', 1, "a2a2a3b2"},
    {'F', -1, "a2a3a3b1"}, {'F', 3, "a3a3a3b0"}, {'G', 6, "a0a3b3b3"}, {'G', -3, "a1a2b3b3"},
    {'G', 1, "a1a3b2b3"}, {'G', 2, "a2a2b2b3"}, {'G', -1, "a2a3b1b3"}, {'G', -2, "a2a3b2b2"},
    {'G', -6, "a3a3b0b3"}, {'G', 3, "a3a3b1b2"}, {'H', 3, "a0a0b3b3b3"}, {'H', -2, "a0a1b2b3b3"},
    {'H', -4, "a0a2b1b3b3"}, {'H', 2, "a0a2b2b2b3"}, {'H', -6, "a0a3b0b3b3"},
    {'H', 6, "a0a3b1b2b3"}, {'H', -2, "a0a3b2b2b2"}, {'H', 1, "a1a1b1b3b3"},
    {'H', 3, "a1a2b0b3b3"}, {'H', -1, "a1a2b1b2b3"}, {'H', -1, "a1a3b0b2b3"},
    {'H', -2, "a1a3b1b1b3"}, {'H', 1, "a1a3b1b2b2"}, {'H', -2, "a2a2b0b2b3"},
    {'H', 1, "a2a2b1b1b3"}, {'H', 1, "a2a3b0b1b3"}, {'H', 2, "a2a3b0b2b2"},
    {'H', -1, "a2a3b1b1b2"}, {'H', 3, "a3a3b0b0b3"}, {'H', -3, "a3a3b0b1b2"},
    {'H', 1, "a3a3b1b1b1"}, {'I', -3, "a0a0a3b3b3"}, {'I', 3, "a0a1a2b3b3"},
    {'I', -1, "a0a1a3b2b3"}, {'I', -2, "a0a2a2b2b3"}, {'I', 1, "a0a2a3b1b3"},
    {'I', 2, "a0a2a3b2b2"}, {'I', 6, "a0a3a3b0b3"}, {'I', -3, "a0a3a3b1b2"},
    {'I', -1, "a1a1a1b3b3"}, {'I', 1, "a1a1a2b2b3"}, {'I', 2, "a1a1a3b1b3"},
    {'I', -1, "a1a1a3b2b2"}, {'I', -1, "a1a2a2b1b3"}, {'I', -6, "a1a2a3b0b3"},
    {'I', 1, "a1a2a3b1b2"}, {'I', 4, "a1a3a3b0b2"}, {'I', -1, "a1a3a3b1b1"},
    {'I', 2, "a2a2a2b0b3"}, {'I', -2, "a2a2a3b0b2"}, {'I', 2, "a2a3a3b0b1"},
    {'I', -3, "a3a3a3b0b0"}, {'J', -1, "a0a0a0b3b3b3"}, {'J', 1, "a0a0a1b2b3b3"},
    {'J', 2, "a0a0a2b1b3b3"}, {'J', -1, "a0a0a2b2b2b3"}, {'J', 3, "a0a0a3b0b3b3"},
    {'J', -3, "a0a0a3b1b2b3"}, {'J', 1, "a0a0a3b2b2b2"}, {'J', -1, "a0a1a1b1b3b3"},
    {'J', -3, "a0a1a2b0b3b3"}, {'J', 1, "a0a1a2b1b2b3"}, {'J', 1, "a0a1a3b0b2b3"},
    {'J', 2, "a0a1a3b1b1b3"}, {'J', -1, "a0a1a3b1b2b2"}, {'J', 2, "a0a2a2b0b2b3"},
    {'J', -1, "a0a2a2b1b1b3"}, {'J', -1, "a0a2a3b0b1b3"}, {'J', -2, "a0a2a3b0b2b2"},
    {'J', 1, "a0a2a3b1b1b2"}, {'J', -3, "a0a3a3b0b0b3"}, {'J', 3, "a0a3a3b0b1b2"},
    {'J', -1, "a0a3a3b1b1b1"}, {'J', 1, "a1a1a1b0b3b3"}, {'J', -1, "a1a1a2b0b2b3"},
    {'J', -2, "a1a1a3b0b1b3"}, {'J', 1, "a1a1a3b0b2b2"}, {'J', 1, "a1a2a2b0b1b3"},
    {'J', 3, "a1a2a3b0b0b3"}, {'J', -1, "a1a2a3b0b1b2"}, {'J', -2, "a1a3a3b0b0b2"},
    {'J', 1, "a1a3a3b0b1b1"}, {'J', -1, "a2a2a2b0b0b3"}, {'J', 1, "a2a2a3b0b0b2"},
    {'J', -1, "a2a3a3b0b0b1"}, {'J', 1, "a3a3a3b0b0b0"}};

}  // namespace

std::span<const ImplicitTerm> implicit_terms() { return terms; }

ImplicitCubic implicit_cubic(const std::array<double, 4>& a, const std::array<double, 4>& b) {
    ImplicitCubic result;
    for (const ImplicitTerm& term : terms) {
        double product = term.factor;
        for (std::size_t i = 0; i < term.factors.size(); i += 2) {
            const std::size_t power = static_cast<std::size_t>(term.factors[i + 1] - '0');
            product *= term.factors[i] == 'a' ? a[power] : b[power];
        }
        result.coefficients[static_cast<std::size_t>(term.coefficient - 'A')] += product;
    }
    return result;
}

double ImplicitCubic::operator()(double x, double y) const {
    const auto& [A, B, C, D, E, F, G, H, I, J] = coefficients;
    return x * (x * (A * x + C * y + E) + D * y * y + G * y + H) + y * (y * (B * y + F) + I) + J;
}

double ImplicitCubic::along_x(double x, double y) const {
    const auto& [A, B, C, D, E, F, G, H, I, J] = coefficients;
    return x * (3 * A * x + 2 * C * y + 2 * E) + y * (D * y + G) + H;
}

double ImplicitCubic::along_y(double x, double y) const {
    const auto& [A, B, C, D, E, F, G, H, I, J] = coefficients;
    return y * (3 * B * y + 2 * D * x + 2 * F) + x * (C * x + G) + I;
}

}  // namespace batten
