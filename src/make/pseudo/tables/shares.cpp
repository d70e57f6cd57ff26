#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "make/pseudo/tables/end_slopes.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/tabulated.hpp"
#include "num/patch_kernel.hpp"

namespace batten::pseudo {
namespace {

using std::numbers::pi;

/// w = J(u) + weight J(turn - u), 0 < weight < 1: the heavier side's weight is 1.
///
/// The least u grows with the weight and is at most turn / 2: J grows with its angle, so from one
/// weight to a larger one w rises more the smaller u is.
struct Balance {
    double turn, weight;

    Slopes at(double u) const {
        const double v = turn - u;
        const Slopes heavy = slopes_on(piece_at(u), u), light = slopes_on(piece_at(v), v);
        return {heavy.value + weight * light.value, heavy.first - weight * light.first,
                heavy.second + weight * light.second};
    }
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

double share_at(std::size_t index, double x, double y) {
    static_assert(share_size == 8);
    return patches::polynomial_8x8(three_point_shares()[index][0].data(), x, y);
}

double angle_of(const Balance& b, double share) {
    return share * b.weight / (1 + b.weight) * b.turn;
}

/// Where the shares of the bands lie, and in which part of a band a weight does.
class Bands {
public:
    Bands() {
        const std::span<const TurnPart> turns = turn_parts();
        assert(turns.size() <= later_starts_.size());
        later_starts_.fill(2 * pi);
        for (std::size_t i = 1; i < turns.size(); ++i) later_starts_[i - 1] = turns[i].lo;
        for (std::size_t band = 0; band < bands; ++band) {
            const std::span<const int> cuts = band_cuts(band);
            for (std::size_t part = 0; part + 1 < cuts.size(); ++part) {
                for (int cell = cuts[part]; cell < cuts[part + 1]; ++cell) {
                    parts_[band][static_cast<std::size_t>(cell)] =
                        static_cast<std::uint8_t>(parts_of_turn + part);
                }
            }
            cuts_[band] = cuts.data();
            first_[band] = parts_of_turn;
            parts_of_turn += cuts.size() - 1;
        }
    }
    /// Without a branch: turns go either way.
    std::size_t turn_part(double turn) const {
        std::size_t index = 0;
        for (const double start : later_starts_) index += turn >= start ? 1 : 0;
        return index;
    }
    /// The share at y of a band, 0 to 1, and at x of a part of the turn, -1 to 1.
    double share(std::size_t turn_part, double x, std::size_t band, double y) const {
        const double scaled = std::clamp(y * cells, 0.0, cells - 1e-9);
        const std::size_t part = parts_[band][static_cast<std::size_t>(scaled)];
        const int* const cut = cuts_[band] + (part - first_[band]);
        const double in_part = (2 * scaled - (cut[0] + cut[1])) / (cut[1] - cut[0]);
        return share_at(smooth_parts * weight_parts + turn_part * parts_of_turn + part, x, in_part);
    }

    std::size_t parts_of_turn = 0;

private:
    static constexpr std::size_t most_turn_parts = 16;
    static constexpr int cells = 256;
    std::array<std::array<std::uint8_t, cells>, bands> parts_{};
    std::array<const int*, bands> cuts_{};
    std::array<std::size_t, bands> first_{};
    std::array<double, most_turn_parts> later_starts_{};
};

const Bands& band_index() {
    static const Bands index;
    return index;
}

/// Below the last of turn_parts().
double banded_share(const Balance& b) {
    const std::span<const TurnPart> parts = turn_parts();
    const std::size_t index = band_index().turn_part(b.turn);
    const TurnPart& part = parts[index];
    const double x = (2 * b.turn - (part.lo + part.hi)) / (part.hi - part.lo);
    std::array<double, bands + 1> ties{1};
    for (std::size_t k = 0; k < part.ties.size(); ++k) {
        ties[k + 1] = patches::polynomial_8(part.ties[k].data(), x);
    }
    std::size_t band = 0;
    for (std::size_t k = 1; k < bands; ++k) band += b.weight < ties[k] ? 1 : 0;
    const double y = (b.weight - ties[band + 1]) / (ties[band] - ties[band + 1]);
    return band_index().share(index, x, band, y);
}

double smooth_share(const Balance& b) {
    const Part turn(b.turn, 0, end_kinks().front(), smooth_parts);
    const Part weight(b.weight, 0, 1, weight_parts);
    return share_at(turn.index * weight_parts + weight.index, turn.x, weight.x);
}

/// A first guess beyond turn_parts().
double far_share(const Balance& b) {
    const Part turn(b.turn, turn_parts().back().hi, pi, far_parts);
    const std::size_t before =
        smooth_parts * weight_parts + turn_parts().size() * band_index().parts_of_turn;
    return share_at(before + turn.index, turn.x, 2 * b.weight - 1);
}

/// Where one of the two J has a kink, and the slopes of w on both sides of it.
struct Kink {
    double at, slope_before, slope_after;
};

constexpr std::size_t end_kink_count = bands - 1;
using Kinks = std::array<Kink, 2 * end_kink_count>;

/// Those of J(theta) itself.
const std::array<Kink, end_kink_count>& kinks_of_ends() {
    static const auto kinks = [] {
        std::array<Kink, end_kink_count> all{};
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double at = end_kinks()[k];
            const EndPiece* const after = &piece_at(at);
            all[k] = {at, slopes_on(after[-1], at).first, slopes_on(*after, at).first};
        }
        return all;
    }();
    return kinks;
}

/// In order. Requires: a turn above all kinks.
Kinks kinks_of(const Balance& b) {
    Kinks kinks{};
    for (std::size_t k = 0; k < end_kink_count; ++k) {
        const Kink& end = kinks_of_ends()[k];
        const double rest = b.turn - end.at;
        const double other = slopes_on(piece_at(rest), rest).first;
        kinks[2 * k] = {end.at, end.slope_before - b.weight * other,
                        end.slope_after - b.weight * other};
        kinks[2 * k + 1] = {rest, other - b.weight * end.slope_after,
                            other - b.weight * end.slope_before};
    }
    std::sort(kinks.begin(), kinks.end(), [](const Kink& a, const Kink& c) { return a.at < c.at; });
    return kinks;
}

struct Tangent {
    double u = 0, energy = 0;
};

/// The least w between two kinks, where w is convex: Newton's method in a shrinking bracket.
Tangent least_between(const Balance& b, double lo, double hi, double start) {
    constexpr int most_steps = 60;
    constexpr double close = 1e-6;           // Newton's next step would be 1e-12
    const double margin = 1e-3 * (hi - lo);  // a kink itself belongs to both sides
    double u = std::clamp(start, lo + margin, hi - margin);
    for (int i = 0; i < most_steps; ++i) {
        const Slopes w = b.at(u);
        (w.first > 0 ? hi : lo) = u;
        const double newton = -w.first / w.second;
        const bool is_newton = u + newton > lo && u + newton < hi;
        const double step = is_newton ? newton : 0.5 * (lo + hi) - u;
        u += step;
        if (is_newton && std::fabs(step) < close * b.turn) {
            return {u, w.value + 0.5 * w.first * step};
        }
        if (hi - lo < 1e-15 * b.turn) break;
    }
    return {u, b.at(u).value};
}

/// Beyond turn_parts(). w is convex between its kinks and falls at each of them to a lesser slope,
/// so its minima are in those intervals at whose beginning it falls and at whose end it rises. There
/// is such a one, for w falls at 0 and rises at the turn; mostly there is no other.
double least_among_kinks(const Balance& b) {
    const double start = angle_of(b, far_share(b));
    Tangent best;
    bool is_found = false;
    const auto look = [&](const Kink& from, const Kink& to) {
        if (from.slope_after >= 0 || to.slope_before <= 0) return;
        const Tangent t = least_between(b, from.at, to.at, start);
        if (!is_found || t.energy < best.energy) best = t;
        is_found = true;
    };
    Kink last{0, -1, -1};
    for (const Kink& kink : kinks_of(b)) {
        look(last, kink);
        last = kink;
    }
    look(last, {b.turn, 1, 1});
    return is_found ? best.u : start;
}

double least(const Balance& b) {
    if (b.turn < end_kinks().front()) return angle_of(b, smooth_share(b));
    if (b.turn < turn_parts().back().hi) return angle_of(b, banded_share(b));
    return least_among_kinks(b);
}

}  // namespace

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
