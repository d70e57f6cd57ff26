#include "io/draw/shapes/comb.hpp"

#include <algorithm>
#include <cmath>

#include "io/draw/shapes/bend.hpp"

namespace batten::drawing {
namespace {

constexpr double spacing_share = 1.0 / 100;  ///< seven pixels in a picture of 700
constexpr double closeness = 0.1;         ///< share of the spacing that is not seen
constexpr double envelope_tolerance = 3e-4;
/// Tips of two pieces closer than this share of the picture are one tip.
constexpr double joint_tolerance = 2e-3;
/// The cosine of half a degree: a smaller change of direction is not seen as a corner.
constexpr double smooth_cosine = 0.99996;

/// A tooth: where it stands and how the curve bends there.
struct Tooth {
    std::size_t piece = 0;
    double t = 0;
    Bend bend;
    Spot tip{};
};

/// Neighbouring samples of the comb without a break between them.
using Stretch = std::vector<Tooth>;

struct CombBuilder {
    const Curve& curve;
    double tooth;
    double size;

    Tooth tooth_at(std::size_t piece, double t) const {
        Tooth result{piece, t, bend_of(curve, piece, t, size), {}};
        Bend& bend = result.bend;
        const double length = tooth * std::fabs(bend.curvature);
        bend.exists = bend.exists && length <= size;
        for (std::size_t k = 0; k < 3; ++k) {
            result.tip[k] = bend.exists ? bend.at[k] + length * bend.outward[k] : bend.at[k];
        }
        return result;
    }

    bool joined(const Tooth& a, const Tooth& b) const {
        double cosine = 0;
        for (std::size_t k = 0; k < 3; ++k) cosine += a.bend.tangent[k] * b.bend.tangent[k];
        return a.bend.exists && b.bend.exists && cosine >= smooth_cosine &&
               distance(a.tip, b.tip) <= joint_tolerance * size;
    }

    std::vector<Stretch> stretches() const {
        std::vector<Stretch> result(1);
        const auto add = [&](const Tooth& next) {
            if (next.bend.exists) {
                result.back().push_back(next);
            } else if (!result.back().empty()) {
                result.emplace_back();
            }
        };
        for (std::size_t i = 0; i < curve.pieces(); ++i) {
            const auto tip = [&](double t) {
                const Tooth at = tooth_at(i, t);
                return Sample{t, at.tip, at.bend.exists};
            };
            const std::vector<Sample> samples =
                refined(tip, curve.piece(i), least_chords(curve), envelope_tolerance * size);
            for (const Sample& sample : samples) {
                const Tooth next = tooth_at(i, sample.t);
                const bool starts = &sample == &samples.front() && !result.back().empty();
                if (starts && !joined(result.back().back(), next)) result.emplace_back();
                add(next);
            }
        }
        if (result.back().empty()) result.pop_back();
        return result;
    }

    /// The teeth that are shown of one stretch.
    std::vector<Tooth> spread(const Stretch& stretch) const {
        std::vector<double> walked{0};
        for (std::size_t j = 1; j < stretch.size(); ++j) {
            const Tooth &a = stretch[j - 1], &b = stretch[j];
            walked.push_back(walked.back() + 0.5 * distance(a.bend.at, b.bend.at) +
                             0.5 * distance(a.tip, b.tip));
        }
        const double whole = walked.back();
        const int count = std::max(1, static_cast<int>(whole / (spacing_share * size) + 0.5));
        std::vector<Tooth> result{stretch.front()};
        std::size_t j = 1;
        for (int i = 1; i < count; ++i) {
            const double goal = whole * i / count;
            while (j + 1 < stretch.size() && walked[j] < goal) ++j;
            const Tooth &a = stretch[j - 1], &b = stretch[j];
            const double share = (goal - walked[j - 1]) / (walked[j] - walked[j - 1]);
            const double from = a.piece == b.piece ? a.t : curve.piece(b.piece).lo;
            const Tooth next = tooth_at(b.piece, from + share * (b.t - from));
            if (next.bend.exists) result.push_back(next);
        }
        if (stretch.size() > 1) result.push_back(stretch.back());
        return result;
    }
};

/// Stretches too short to be seen, as of ten thousand pieces with jumping curvature, stand behind
/// the one with the longest teeth.
struct Crowd {
    double close;
    Spot place{};
    double tallest = -1;

    bool hides(const Stretch& stretch) {
        const Spot &from = stretch.front().bend.at, &to = stretch.back().bend.at;
        double highest = 0;
        bool is_short = true;
        for (const Tooth& at : stretch) {
            highest = std::max(highest, std::fabs(at.bend.curvature));
            is_short = is_short && distance(from, at.bend.at) < close;
        }
        const bool is_near = tallest >= 0 && distance(place, to) < close;
        if (is_short && is_near && highest <= tallest) return true;
        if (!is_near) place = to;
        tallest = is_near ? std::max(tallest, highest) : highest;
        return false;
    }
};

}  // namespace

Comb comb_of(const Curve& curve, double tooth, double size) {
    const CombBuilder builder{curve, tooth, size};
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    Comb comb{Points(0, curve.dim()), {}};
    const double close = closeness * spacing_share * size;
    const auto same = [&](const Tooth& a, const Tooth& b) {
        return distance(a.bend.at, b.bend.at) < close && distance(a.tip, b.tip) < close;
    };
    Tooth first, last;
    Crowd crowd{close, {}, -1};
    for (const Stretch& stretch : builder.stretches()) {
        if (crowd.hides(stretch)) continue;
        comb.envelope.emplace_back(0, curve.dim());
        for (const Tooth& at : stretch) comb.envelope.back().push_back({at.tip.data(), dim});
        const std::vector<Tooth> teeth = builder.spread(stretch);
        for (const Tooth& next : teeth) {
            const bool ends_at_start = &next == &teeth.back() && same(first, next);
            if (!comb.teeth.empty() && (same(last, next) || ends_at_start)) continue;
            if (comb.teeth.empty()) first = next;
            comb.teeth.push_back({next.bend.at.data(), dim});
            comb.teeth.push_back({next.tip.data(), dim});
            last = next;
        }
    }
    return comb;
}

}  // namespace batten::drawing
