#include "end_builder.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "batten/base/interval.hpp"
#include "batten/base/text.hpp"
#include "chebyshev_fit.hpp"
#include "make/pseudo/free_end.hpp"
#include "make/pseudo/tables/tabulated.hpp"
#include "share_builder.hpp"

using namespace batten;
using namespace batten::pseudo;

namespace {

constexpr double pi = std::numbers::pi;

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
    const EndPiece piece{part.lo, part.hi, fitted(energy),
                         fitted(ratio)};
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

template <class Numbers>
std::string listed(const Numbers& numbers) {
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "" : ", ") + format_number(x);
    return "{" + text + "}";
}

std::string shares_text(const ShareTables& tables) {
    std::string text = "const std::array<TurnPart, " + std::to_string(tables.turns.size()) +
                       "> turns{{\n";
    for (const TurnPart& t : tables.turns) {
        text += "{" + format_number(t.lo) + ", " + format_number(t.hi) + ", {{";
        for (const auto& tie : t.ties) text += listed(tie) + ", ";
        text += "}}},\n";
    }
    text += "}};\n\n";
    for (std::size_t band = 0; band < bands; ++band) {
        text += "constexpr int cuts" + std::to_string(band) + "[]" + listed(tables.cuts[band]) + ";\n";
    }
    text += "\nconst std::array<Share, " + std::to_string(tables.shares.size()) + "> shares{{\n";
    for (const Share& share : tables.shares) {
        text += "{{";
        for (const auto& row : share) text += "{" + listed(row) + "}, ";
        text += "}},\n";
    }
    return text + "}};\n";
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
    text += "}};\n\n";
    return text + shares_text(share_tables(kinks, pieces));
}
