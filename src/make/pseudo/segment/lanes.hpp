#pragma once

#include <cmath>

namespace batten::pseudo {

/// Two doubles worked on side by side by the vector instructions every target has (SSE2, NEON,
/// wasm SIMD or plain code); each lane has the bits of the scalar computation.
struct Lanes {
    static constexpr int count = 2;
    using Vector = double __attribute__((vector_size(count * sizeof(double))));
    Vector at{};

    Lanes() = default;
    explicit(false) Lanes(double all) : at{all, all} {}
    Lanes(double first, double second) : at{first, second} {}
    explicit Lanes(Vector v) : at(v) {}

    Lanes& operator+=(const Lanes& b) {
        at += b.at;
        return *this;
    }
    friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.at + b.at); }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.at - b.at); }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.at * b.at); }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.at / b.at); }
    friend Lanes square_root(const Lanes& a) { return {std::sqrt(a.at[0]), std::sqrt(a.at[1])}; }
    double sum() const { return at[0] + at[1]; }
};

}  // namespace batten::pseudo
