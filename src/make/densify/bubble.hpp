#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "make/densify/windows.hpp"

/// The arithmetic of one cell: P + s (Q - P) - s (1 - s) g(s). Every caller runs through these few
/// lines, whether dimension and degree are known to the compiler or not, and so gets the same bits.
namespace batten::lagrange {

/// Some coordinates of one point, taken together: one number, or a pair in one register.
template <std::size_t N>
struct Lanes;

template <>
struct Lanes<1> {
    using Type = double;
    static double load(const double* from) { return *from; }
    static void store(double a, double* to) { *to = a; }
    static double sum(double a) { return a; }
};

template <>
struct Lanes<2> {
    using Type __attribute__((vector_size(16))) = double;  // GCC's and clang's; IEEE lane by lane
    static Type load(const double* from) { return Type{from[0], from[1]}; }
    static void store(Type a, double* to) {
        to[0] = a[0];
        to[1] = a[1];
    }
    static double sum(Type a) { return a[0] + a[1]; }
};

/// How many power coefficients g has, in how many dimensions, how many of them are taken together.
struct RunTimeSize {
    std::size_t terms, dim;
    static constexpr std::size_t lanes = 1;

    std::vector<double> bubble_room() const { return std::vector<double>(terms * dim); }
};
template <std::size_t Terms, std::size_t Dim, std::size_t Lanes>
struct FixedSize {
    static constexpr std::size_t terms = Terms, dim = Dim, lanes = Lanes;

    std::array<double, Terms * Dim> bubble_room() const { return {}; }
};

/// The coefficients of g, term by term; `other(i)`: the coordinates of the recipe's i-th point.
template <class Size, class Point>
inline void make_bubble(Size size, const Recipe& recipe, const double* p, const double* q,
                        Point&& other, double* g) {
    using L = Lanes<Size::lanes>;
    for (std::size_t k = 0; k < size.dim; k += Size::lanes) {
        const auto start = L::load(p + k), chord = L::load(q + k) - start;
        for (std::size_t i = 0; i < size.terms; ++i) {
            const auto off = (L::load(other(i) + k) - start) - recipe.place[i] * chord;
            for (std::size_t j = 0; j < size.terms; ++j) {
                double* const to = g + j * size.dim + k;
                const auto term = recipe.matrix[j * size.terms + i] * off;
                L::store(i == 0 ? term : L::load(to) + term, to);
            }
        }
    }
}

/// Whether a quick bound of |g| shows the cell no further from the middle of its chord d than |d|:
/// |s - 1/2| |d| + s (1 - s) |g| <= |d| for all s where |g| <= (2 + sqrt 3) |d|. Never where a
/// number is not finite, the chord vanishes or its square is beyond a double.
template <class Size>
inline bool is_surely_tame(Size size, const double* p, const double* q, const double* g) {
    using L = Lanes<Size::lanes>;
    constexpr double c_sq = 13.928203230275509;  // (2 + sqrt 3)^2
    double chord_sq = 0, start_sq = 0, end_sq = 0, sum_sq = 0;
    for (std::size_t k = 0; k < size.dim; k += Size::lanes) {
        const auto chord = L::load(q + k) - L::load(p + k);
        chord_sq += L::sum(chord * chord);
        typename L::Type end{};
        for (std::size_t j = 0; j < size.terms; ++j) {
            const auto term = L::load(g + j * size.dim + k);
            if (j == 0) start_sq += L::sum(term * term);
            if (size.terms > 2) sum_sq += L::sum(term * term);
            end = end + term;
        }
        end_sq += L::sum(end * end);
    }
    // Up to two terms g is linear, so largest at an end.
    const double g_sq = size.terms <= 2 ? std::max(start_sq, end_sq)
                                        : static_cast<double>(size.terms) * sum_sq;
    return g_sq < c_sq * chord_sq && chord_sq <= std::numeric_limits<double>::max();
}

/// `count` points of a cell, one after the other. `factors`: for each point s, then
/// -s (1 - s) s^j for each term j.
template <class Size>
inline void put_points(Size size, const double* p, const double* q, const double* g,
                       const double* factors, std::size_t count, double* __restrict out) {
    using L = Lanes<Size::lanes>;
    for (std::size_t k = 0; k < size.dim; k += Size::lanes) {
        const auto start = L::load(p + k), chord = L::load(q + k) - start;
        const double* factor = factors;
        for (std::size_t i = 0; i < count; ++i, factor += 1 + size.terms) {
            auto x = start + factor[0] * chord;
            for (std::size_t j = 0; j < size.terms; ++j) {
                x = x + factor[1 + j] * L::load(g + j * size.dim + k);
            }
            L::store(x, out + i * size.dim + k);
        }
    }
}

/// Fills in the 1 + terms factors of the point at s.
inline void put_factors(double s, std::size_t terms, double* factors) {
    factors[0] = s;
    double factor = -s * (1 - s);
    for (std::size_t j = 0; j < terms; ++j, factor *= s) factors[1 + j] = factor;
}

}  // namespace batten::lagrange
