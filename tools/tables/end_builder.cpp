#include "end_builder.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/base/text.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/tables/tabulated.hpp"
#include "make/pseudo/three_point.hpp"
#include "patch_builder.hpp"

using namespace batten;
using namespace batten::pseudo;

namespace {

constexpr double pi = std::numbers::pi;

template <std::size_t N>
std::array<double, N> chebyshev_coefficients(const std::array<double, N>& values) {
    std::array<double, N> c{};
    for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t i = 0; i < N; ++i) {
            c[k] += values[i] * std::cos(pi * static_cast<double>(k * (2 * i + 1)) / (2.0 * N)) *
                    (k == 0 ? 1.0 : 2.0) / N;
        }
    }
    return c;
}

template <std::size_t N>
double node(std::size_t i) {
    return std::cos(pi * static_cast<double>(2 * i + 1) / (2.0 * N));
}

template <std::size_t N>
std::array<double, N> powers(const std::array<double, N>& chebyshev) {
    const auto rows = patches::chebyshev_powers(static_cast<int>(N));
    std::array<double, N> c{};
    for (std::size_t k = 0; k < N; ++k) {
        for (std::size_t i = 0; i <= k; ++i) c[i] += chebyshev[k] * rows[k][i];
    }
    return c;
}

double value(const std::array<double, end_size>& c, double x) {
    double sum = c[end_size - 1];
    for (std::size_t k = end_size - 1; k-- > 0;) sum = sum * x + c[k];
    return sum;
}

/// Where r0 of the least free end jumps. Steps of 0.02 degrees pass over no jump: within one, r0
/// changes by less than 2 percent.
std::vector<double> find_kinks() {
    constexpr int steps = 9000;
    const auto magnitude = [](double theta) { return std::log(free_end(theta).segment.r0); };
    std::vector<double> kinks;
    double before = magnitude(pi / steps);
    for (int i = 2; i <= steps; ++i) {
        Interval at{pi * (i - 1) / steps, pi * i / steps};
        const double now = magnitude(at.hi);
        if (std::fabs(now - before) > 0.02) {
            double lower = before;
            for (int k = 0; k < 46; ++k) {
                const double middle = magnitude(at.middle());
                const bool is_lower = std::fabs(middle - lower) < std::fabs(middle - now);
                (is_lower ? at.lo : at.hi) = at.middle();
                if (is_lower) lower = middle;
            }
            kinks.push_back(at.hi);
        }
        before = now;
    }
    return kinks;
}

/// Halves until three tests between the nodes agree to 2e-13 in J and 3e-11 in theta1.
void add_pieces(Interval part, int level, std::vector<EndPiece>& pieces) {
    constexpr int most_halvings = 24;
    std::array<double, end_size> energy{}, ratio{};
    const auto at = [&](double x) { return part.middle() + 0.5 * part.length() * x; };
    for (std::size_t i = 0; i < end_size; ++i) {
        const double theta = at(node<end_size>(i));
        const FreeEnd end = free_end(theta);
        energy[i] = end.pseudo_energy / (theta * theta);
        ratio[i] = end.segment.theta1 / theta;
    }
    const EndPiece piece{part.lo, part.hi, powers(chebyshev_coefficients(energy)),
                         powers(chebyshev_coefficients(ratio))};
    bool is_good = true;
    for (const double x : {-0.997, -0.9, -0.43, 0.02, 0.51, 0.93, 0.997}) {
        const double theta = at(x);
        const FreeEnd end = free_end(theta);
        const double j = theta * theta * value(piece.energy, x);
        is_good = is_good && std::fabs(j / end.pseudo_energy - 1) < 2e-13 &&
                  std::fabs(theta * value(piece.ratio, x) - end.segment.theta1) < 3e-11;
    }
    if (is_good || level == most_halvings) return pieces.push_back(piece);
    add_pieces({part.lo, part.middle()}, level + 1, pieces);
    add_pieces({part.middle(), part.hi}, level + 1, pieces);
}

Share share_for(Interval turns, Interval weights) {
    Share values{}, c{};  // values[i][j] for turn i, weight j
    for (std::size_t i = 0; i < share_size; ++i) {
        const double turn = turns.middle() + 0.5 * turns.length() * node<share_size>(i);
        for (std::size_t j = 0; j < share_size; ++j) {
            const double weight = weights.middle() + 0.5 * weights.length() * node<share_size>(j);
            const double u = three_point_angle({turn, 1, weight}, 1).angle;
            values[i][j] = u * (1 + weight) / (weight * turn);
        }
        values[i] = powers(chebyshev_coefficients(values[i]));
    }
    for (std::size_t j = 0; j < share_size; ++j) {
        for (std::size_t i = 0; i < share_size; ++i) c[j][i] = values[i][j];
        c[j] = powers(chebyshev_coefficients(c[j]));
    }
    return c;
}

std::vector<Share> shares(double first_kink) {
    std::vector<Share> result;
    const auto part = [](Interval whole, std::size_t k, std::size_t count) {
        const double step = whole.length() / static_cast<double>(count);
        const double lo = whole.lo + static_cast<double>(k) * step;
        return Interval{lo, lo + step};
    };
    for (std::size_t i = 0; i < smooth_parts; ++i) {
        for (std::size_t j = 0; j < weight_parts; ++j) {
            result.push_back(share_for(part({0, first_kink}, i, smooth_parts),
                                       part({0, 1}, j, weight_parts)));
        }
    }
    for (std::size_t i = 0; i < rough_parts; ++i) {
        result.push_back(share_for(part({first_kink, pi}, i, rough_parts), {0, 1}));
    }
    return result;
}

template <class Numbers>
std::string listed(const Numbers& numbers) {
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "" : ", ") + format_number(x);
    return "{" + text + "}";
}

}  // namespace

std::string end_tables() {
    const std::vector<double> kinks = find_kinks();
    std::vector<EndPiece> pieces;
    double from = 0;
    for (std::size_t i = 0; i <= kinks.size(); ++i) {
        const double to = i < kinks.size() ? kinks[i] : pi;
        add_pieces({from, to}, 0, pieces);
        from = to;
    }
    std::string text = "const std::array<double, " + std::to_string(kinks.size()) + "> kinks" +
                       listed(kinks) + ";\n\nconst std::array<EndPiece, " +
                       std::to_string(pieces.size()) + "> pieces{{\n";
    for (const EndPiece& p : pieces) {
        text += "{" + format_number(p.lo) + ", " + format_number(p.hi) + ", {" + listed(p.energy) +
                "}, {" + listed(p.ratio) + "}},\n";
    }
    text += "}};\n\nconst std::array<Share, smooth_parts * weight_parts + rough_parts> shares{{\n";
    for (const Share& share : shares(kinks.front())) {
        text += "{{";
        for (const auto& row : share) text += "{" + listed(row) + "}, ";
        text += "}},\n";
    }
    return text + "}};\n";
}
