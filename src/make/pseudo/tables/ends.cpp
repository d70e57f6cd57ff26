#include "make/pseudo/tables/ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "make/pseudo/tables/tabulated.hpp"
#include "num/patch_kernel.hpp"

namespace batten::pseudo {
namespace {

using std::numbers::pi;

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

/// A number's place in equal parts of [lo, hi].
struct Part {
    Part(double at, double lo, double hi, std::size_t count) {
        const double scaled = (at - lo) * (static_cast<double>(count) / (hi - lo));
        index = std::min(static_cast<std::size_t>(scaled), count - 1);
        x = 2 * (scaled - static_cast<double>(index)) - 1;
    }
    std::size_t index;
    double x;  // -1 to 1
};

double tabulated_share(const Balance& b) {
    const double kink = end_kinks().front();
    const bool is_smooth = b.turn < kink;
    const Part turn = is_smooth ? Part(b.turn, 0, kink, smooth_parts)
                                : Part(b.turn, kink, pi, rough_parts);
    const Part weight(b.weight, 0, 1, is_smooth ? weight_parts : 1);
    const std::size_t index = is_smooth ? turn.index * weight_parts + weight.index
                                        : smooth_parts * weight_parts + turn.index;
    const Share& table = three_point_shares()[index];
    static_assert(share_size == 8);
    const double share = patches::polynomial_8x8(table[0].data(), turn.x, weight.x);
    return share * b.weight / (1 + b.weight) * b.turn;
}

/// Whether w falls at the lower and rises at the upper end of a part between two kinks.
bool has_minimum(const Balance& b, double lo, double hi) {
    const double margin = 1e-9 * b.turn;  // a kink itself belongs to both sides
    return (lo == 0 || b.at(lo + margin).first < 0) &&
           (hi == b.turn || b.at(hi - margin).first > 0);
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

/// The guess is within 0.0129 of the least w: the worst of 10^6 pairs of turn and weight.
constexpr double apart = 0.03;

/// The least w where a kink is near the guess: which side of it is least, no guess can tell.
Tangent least_of_rivals(const Balance& b, double start) {
    std::array<double, 10> ends{0, b.turn};
    std::size_t count = 2;
    for (const double kink : end_kinks()) {
        if (kink < b.turn) {
            ends[count++] = kink;
            ends[count++] = b.turn - kink;
        }
    }
    std::sort(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count));
    Tangent best{start, 0};
    bool is_found = false;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (ends[i + 1] < start - apart || ends[i] > start + apart) continue;
        if (!has_minimum(b, ends[i], ends[i + 1])) continue;
        const Tangent t = least_between(b, ends[i], ends[i + 1], start);
        if (!is_found || t.energy < best.energy) best = t;
        is_found = true;
    }
    return best;
}

/// The least w where there are kinks. J(theta) is concave at its kinks, so w has its minima between
/// them: between the two around the guess, unless one of these is near.
Tangent least_among_kinks(const Balance& b) {
    const double start = tabulated_share(b);
    double lo = 0, hi = b.turn;
    bool has_rivals = false;
    for (const double kink : end_kinks()) {
        if (kink >= b.turn) break;
        for (const double end : {kink, b.turn - kink}) {
            has_rivals |= std::fabs(end - start) <= apart;
            if (end <= start) {
                lo = std::max(lo, end);
            } else {
                hi = std::min(hi, end);
            }
        }
    }
    return has_rivals ? least_of_rivals(b, start) : least_between(b, lo, hi, start);
}

double least(const Balance& b) {
    return b.turn < end_kinks().front() ? tabulated_share(b) : least_among_kinks(b).u;
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

double tabulated_three_point_angle(const ThreePoints& points, double weight_exponent) {
    const double turn = std::fabs(points.turn);
    if (turn == 0) return 0;
    const bool is_first_longer = points.length0 >= points.length1;
    const double longer = is_first_longer ? points.length0 : points.length1;
    const double ratio = (is_first_longer ? points.length1 : points.length0) / longer;
    const bool is_plain = weight_exponent == 1 || ratio == 1;
    const double weight = is_plain ? std::fmax(ratio, 1e-60)
                                   : relative_weight(ratio, weight_exponent);
    double from_longer = turn / 2;
    if (weight < 1) from_longer = least({turn, weight});
    if (weight > 1) from_longer = turn - least({turn, 1 / weight});
    return std::copysign(is_first_longer ? from_longer : turn - from_longer, points.turn);
}

}  // namespace batten::pseudo
