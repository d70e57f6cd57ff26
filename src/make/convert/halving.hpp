#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/shape/curve.hpp"

namespace batten::conversion {

/// Pieces are halved at most this often: 2^-40 of a piece is below what a drawing or a machine
/// can tell, and a curve that is still rough there is reported as not met.
constexpr int deepest_halving = 40;

inline double distance(std::span<const double> a, std::span<const double> b) {
    double sum_sq = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum_sq += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum_sq);
}

/// Breaks at which halving may stop: all parts pass `fits`.
template <class Fits>
std::vector<double> halved(const Curve& curve, const Fits& fits) {
    std::vector<double> breaks{curve.domain().lo};
    for (std::size_t piece = 0; piece < curve.pieces(); ++piece) {
        const Interval whole = curve.piece(piece);
        const double shortest = std::ldexp(whole.length(), -deepest_halving);
        std::vector<Interval> open{whole};
        while (!open.empty()) {
            const Interval part = open.back();
            open.pop_back();
            if (part.length() <= shortest || fits(piece, part)) {
                breaks.push_back(part.hi);
            } else {
                open.push_back({part.middle(), part.hi});
                open.push_back({part.lo, part.middle()});
            }
        }
    }
    return breaks;
}

}  // namespace batten::conversion
