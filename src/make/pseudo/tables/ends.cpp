#include "make/pseudo/tables/ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "make/pseudo/tables/tabulated.hpp"

namespace batten::pseudo {
namespace {

constexpr double pi = std::numbers::pi;

/// The piece an angle lies in, by equal cells.
class EndIndex {
public:
    EndIndex() {
        const auto pieces = end_pieces();
        std::size_t piece = 0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double angle = pi * static_cast<double>(cell) / cells;
            while (pieces[piece].hi <= angle) ++piece;
            first_[cell] = static_cast<std::uint16_t>(piece);
        }
    }
    const EndPiece& find(double theta) const {
        const auto pieces = end_pieces();
        const std::size_t cell = static_cast<std::size_t>(theta * (cells / pi));
        std::size_t piece = first_[std::min(cell, cells - 1)];
        while (piece > 0 && theta < pieces[piece].lo) --piece;
        while (piece + 1 < pieces.size() && theta >= pieces[piece].hi) ++piece;
        return pieces[piece];
    }

private:
    static constexpr std::size_t cells = 512;
    std::array<std::uint16_t, cells> first_{};
};

const EndPiece& piece_at(double theta) {
    static const EndIndex index;
    return index.find(theta);
}

/// J, J' and J'' for 0 <= theta <= pi.
struct Slopes {
    double value, first, second;
};

Slopes slopes_at(double theta) {
    const EndPiece& piece = piece_at(theta);
    const double scale = 2 / (piece.hi - piece.lo);
    const double x = (theta - 0.5 * (piece.lo + piece.hi)) * scale;
    double e = piece.energy[end_size - 1], slope = 0, half_second = 0;
    for (std::size_t k = end_size - 1; k-- > 0;) {
        half_second = half_second * x + slope;
        slope = slope * x + e;
        e = e * x + piece.energy[k];
    }
    slope *= scale;
    const double second = 2 * half_second * scale * scale;
    return {theta * theta * e, theta * (2 * e + theta * slope),
            2 * e + theta * (4 * slope + theta * second)};
}

/// w = J(u) + weight J(turn - u), the heavier side's weight being 1.
struct Balance {
    double turn, weight;

    Slopes at(double u) const {
        const Slopes heavy = slopes_at(u), light = slopes_at(turn - u);
        return {heavy.value + weight * light.value, heavy.first - weight * light.first,
                heavy.second + weight * light.second};
    }
};

struct Tangent {
    double u = 0, energy = 0;
};

double guess(const Balance& b) {
    const double part = b.turn * (guess_count / pi);
    const std::size_t k = std::min(static_cast<std::size_t>(part), guess_count - 1);
    const double x = 2 * (part - static_cast<double>(k)) - 1, y = 2 * b.weight - 1;
    const Guess& table = three_point_guesses()[k];
    std::array<double, guess_size> in_x{1, x};
    for (std::size_t i = 2; i < guess_size; ++i) in_x[i] = 2 * x * in_x[i - 1] - in_x[i - 2];
    double sum = 0, before = y, now = 1;
    for (std::size_t j = 0; j < guess_size; ++j) {
        double column = 0;
        for (std::size_t i = 0; i < guess_size; ++i) column += table[i][j] * in_x[i];
        sum += now * column;
        const double next = 2 * y * now - before;
        before = now;
        now = next;
    }
    return sum * b.weight / (1 + b.weight) * b.turn;
}

/// The least w between two neighbouring kinks, by Newton's method in a shrinking bracket.
Tangent least_between(const Balance& b, double lo, double hi, double start) {
    constexpr int most_steps = 60;
    constexpr double close = 1e-6;  // Newton's next step would be 1e-12
    const double margin = 1e-3 * (hi - lo);  // a kink itself belongs to both sides
    double u = std::clamp(start, lo + margin, hi - margin);
    for (int i = 0; i < most_steps; ++i) {
        const Slopes w = b.at(u);
        (w.first > 0 ? hi : lo) = u;
        const double newton = -w.first / w.second;
        const bool is_newton = w.second > 0 && u + newton > lo && u + newton < hi;
        const double step = is_newton ? newton : 0.5 * (lo + hi) - u;
        u += step;
        if (is_newton && std::fabs(step) < close * b.turn) {
            return {u, w.value + 0.5 * w.first * step};
        }
        if (hi - lo < 1e-15 * b.turn) break;
    }
    return {u, b.at(u).value};
}

/// The least w. J(theta) is concave at its kinks, so w has its minima between them; which of two
/// neighbouring ones is least, no guess can tell, but they are never 5 degrees apart.
Tangent least(const Balance& b) {
    constexpr double apart = 0.09;
    std::array<double, 10> ends{0, b.turn};
    std::size_t count = 2;
    for (const double kink : end_kinks()) {
        if (kink < b.turn) {
            ends[count++] = kink;
            ends[count++] = b.turn - kink;
        }
    }
    const double start = guess(b);
    if (count == 2) return least_between(b, 0, b.turn, start);
    std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
    Tangent best;
    bool is_found = false;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (ends[i + 1] < start - apart || ends[i] > start + apart) continue;
        const Tangent t = least_between(b, ends[i], ends[i + 1], start);
        if (!is_found || t.energy < best.energy) best = t;
        is_found = true;
    }
    return best;
}

}  // namespace

TabulatedEnd tabulated_end(double theta) {
    const double size = std::fabs(theta);
    const EndPiece& piece = piece_at(size);
    const double x = (size - 0.5 * (piece.lo + piece.hi)) * (2 / (piece.hi - piece.lo));
    double ratio = piece.ratio[end_size - 1];
    for (std::size_t k = end_size - 1; k-- > 0;) ratio = ratio * x + piece.ratio[k];
    const Slopes j = slopes_at(size);
    return {ratio * theta, j.value, std::copysign(j.first, theta), j.second};
}

ThreePointAngle tabulated_three_point_angle(const ThreePoints& points, double weight_exponent) {
    const double turn = std::fabs(points.turn);
    if (turn == 0) return {};
    const bool is_first_longer = points.length0 >= points.length1;
    const double longer = is_first_longer ? points.length0 : points.length1;
    const double ratio = (is_first_longer ? points.length1 : points.length0) / longer;
    const bool is_plain = weight_exponent == 1 || ratio == 1;
    const double weight = is_plain ? std::fmax(ratio, 1e-60)
                                   : relative_weight(ratio, weight_exponent);
    const double unit = weight_exponent == 1 ? longer : std::pow(longer, weight_exponent);
    Tangent t{turn / 2, 0};
    if (weight == 1) {
        t.energy = 2 * slopes_at(turn / 2).value;
    } else if (weight < 1) {
        t = least({turn, weight});
    } else {
        t = least({turn, 1 / weight});
        t = {turn - t.u, weight * t.energy};
    }
    const double angle = is_first_longer ? t.u : turn - t.u;
    return {std::copysign(angle, points.turn), unit * t.energy, true};
}

}  // namespace batten::pseudo
