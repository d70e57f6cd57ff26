#include <algorithm>
#include <array>
#include <cmath>

#include "make/sample/walk.hpp"
#include "num/banded.hpp"

namespace batten::sampling {

Places places_of(const ArcLengthMap& map, const MotionLaw& law, const Timing& timing) {
    Places places;
    for (std::size_t i = 0; i < timing.tau.size(); ++i) {
        const MotionState now = law.at(timing.tau[i]);
        places.time.push_back(timing.time(i));
        places.s.push_back(now.share >= 1 ? map.length() : map.length() * now.share);
        places.speed.push_back(map.length() * now.speed / timing.duration);
    }
    places.t.resize(places.size());
    map.t_of(places.s, places.t);
    return places;
}

Points speeds_of(const ArcLengthMap& map, const MotionLaw& law, const Timing& timing) {
    constexpr int instants = 400;
    Points result(instants, 2);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double tau = (static_cast<double>(i) + 0.5) / instants;
        result(i, 0) = timing.start + tau * timing.duration;
        result(i, 1) = map.length() * law.at(tau).speed / timing.duration;
    }
    return result;
}

double spacing_error(const ArcLengthMap& map, const Places& places) {
    double largest = 0, before = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double wrong = map.s_of(places.t[i]) - places.s[i];
        if (i > 0) largest = std::fmax(largest, std::fabs(wrong - before));
        before = wrong;
    }
    return largest;
}

namespace {

/// Points and unit tangents at arc lengths.
struct Chain {
    Points at, tangents;
    std::vector<double> chords;  ///< from each point to the next
    Points directions;           ///< of the chords
};

Chain chain_of(const Curve& curve, const ArcLengthMap& map, std::span<const double> s) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    Chain chain{Points(s.size(), curve.dim()), Points(s.size(), curve.dim()), {},
                Points(s.size() - 1, curve.dim())};
    std::vector<double> t(s.size());
    map.t_of(s, t);
    for (std::size_t i = 0; i < s.size(); ++i) {
        curve.jets(std::span(t).subspan(i, 1), 0, chain.at[i]);
        const std::vector<double> tangent = unit_tangent(curve, t[i]);
        std::copy(tangent.begin(), tangent.end(), chain.tangents[i].begin());
        if (i == 0) continue;
        double length = 0;
        for (std::size_t k = 0; k < dim; ++k) {
            chain.directions[i - 1][k] = chain.at[i][k] - chain.at[i - 1][k];
            length = std::hypot(length, chain.directions[i - 1][k]);
        }
        for (double& x : chain.directions[i - 1]) x = length > 0 ? x / length : 0;
        chain.chords.push_back(length);
    }
    return chain;
}

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

double unevenness(const std::vector<double>& chords) {
    const auto [least, most] = std::minmax_element(chords.begin(), chords.end());
    return *most - *least;
}

/// How far the inner arc lengths move in a Newton step for equal chords.
std::vector<double> newton_step(const Chain& chain) {
    const std::size_t inner = chain.chords.size() - 1;
    std::vector<double> move(inner), work(inner);
    for (std::size_t i = 0; i < inner; ++i) move[i] = chain.chords[i] - chain.chords[i + 1];
    const auto row = [&](std::size_t i) {
        const auto before = chain.directions[i], after = chain.directions[i + 1];
        const auto here = chain.tangents[i + 1];
        return num::TridiagonalRow{i == 0 ? 0 : dot(before, chain.tangents[i]),
                                   -dot(before, here) - dot(after, here),
                                   i + 1 == inner ? 0 : dot(after, chain.tangents[i + 2])};
    };
    double* column = move.data();
    num::solve_tridiagonal(inner, row, {&column, 1}, work);
    return move;
}

/// Whether the arc lengths moved by a share of the step still rise.
bool moves(std::vector<double>& s, const std::vector<double>& step, double share) {
    std::vector<double> moved = s;
    for (std::size_t i = 0; i < step.size(); ++i) moved[i + 1] += share * step[i];
    for (std::size_t i = 1; i < moved.size(); ++i) {
        if (!(moved[i] > moved[i - 1])) return false;
    }
    s = std::move(moved);
    return true;
}

}  // namespace

EqualChords equal_chords(const Curve& curve, const ArcLengthMap& map, std::size_t count) {
    constexpr int most_steps = 50, most_halvings = 12;
    std::vector<double> s;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        s.push_back(map.length() * (static_cast<double>(i) / static_cast<double>(count - 1)));
    }
    s.push_back(map.length());
    Chain chain = chain_of(curve, map, s);
    for (int step = 0; step < most_steps && count > 2; ++step) {
        const double before = unevenness(chain.chords);
        const std::vector<double> move = newton_step(chain);
        bool is_better = false;
        double share = 1;
        for (int i = 0; i < most_halvings && !is_better; ++i, share /= 2) {
            std::vector<double> tried = s;
            if (!moves(tried, move, share)) continue;
            Chain next = chain_of(curve, map, tried);
            if (!(unevenness(next.chords) < before)) continue;
            s = std::move(tried);
            chain = std::move(next);
            is_better = true;
        }
        if (!is_better) break;
    }
    return {std::move(s), unevenness(chain.chords)};
}

}  // namespace batten::sampling
