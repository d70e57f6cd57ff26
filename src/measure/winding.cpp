#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/areas.hpp"
#include "num/bernstein.hpp"
#include "num/gauss.hpp"
#include "num/roots.hpp"
#include "num/sum.hpp"

namespace batten::bezier {
namespace {

using bernstein::Coefficients;
using bernstein::View;

/// Two arcs this close to straight lines are crossed like straight lines. A crossing is then
/// misplaced, or a lens between two arcs missed, by an area of at most (8 x 2^-26)^1.5 / 8.
constexpr double flatness = 0x1p-26;
/// Heights closer than this are one.
constexpr double same_height = 0x1p-45;
/// A second's work: pairs of a band and a chain, of which only some meet; branches in all bands.
constexpr std::size_t most_pairs = 30000000, most_branches = 1000000;

/// A part of the curve that rises or falls all along.
struct Arc {
    Coefficients x, y;
    int sign = 1;  ///< of dy

    double low() const { return std::fmin(y[0], y[y.size() - 1]); }
    double high() const { return std::fmax(y[0], y[y.size() - 1]); }
    double u_at(double height) const {
        const double start = y[0], end = y[y.size() - 1];
        if ((height - start) * sign <= 0) return 0;
        if ((height - end) * sign >= 0) return 1;
        const View c = y;
        return num::find_root([&](double u) { return bernstein::value(c, u) - height; }, {0, 1})
            .at;
    }
    /// int x dy from u = 0: the integrand has degree 2 n - 1.
    double moment(double u) const {
        const Coefficients slope = bernstein::derivative(y);
        const auto integrand = [&](double v) {
            return bernstein::value(x, v) * bernstein::value(slope, v);
        };
        const int nodes = std::min(static_cast<int>(x.size()), num::most_gauss_nodes);
        return num::integrate(integrand, {0, u}, num::gauss_legendre(nodes));
    }
};

/// Arcs that follow each other, all rising or all falling: x is a function of y.
struct Chain {
    std::size_t first = 0, last = 0;  ///< arcs [first, last)
    double low = 0, high = 0;
};

struct Branches {
    std::vector<Arc> arcs;
    std::vector<double> moments;  ///< int x dy over the arcs before, from the start of the chain
    std::vector<Chain> chains;

    explicit Branches(const Pieces& pieces);
    const Arc& arc_at(const Chain& chain, double height) const;
    double x_at(const Chain& chain, double height) const;
    double moment_at(const Chain& chain, double height) const;
    std::vector<std::size_t> chain_of_arc() const;

private:
    void add_piece(View x, View y, View dx, View dy);
    bool continues_ = false;
};

void Branches::add_piece(View x, View y, View dx, View dy) {
    const double noise = 0x1p-50 * std::fmax(bernstein::bound(dx), bernstein::bound(dy));
    double end = 0;
    for (const bernstein::SignRun& run : bernstein::sign_runs(dy, noise)) {
        const bool follows = continues_ && run.where.lo == end && run.sign == arcs.back().sign;
        if (!follows) chains.push_back({arcs.size(), arcs.size(), 0, 0});
        arcs.push_back({bernstein::restricted(x, run.where), bernstein::restricted(y, run.where),
                        run.sign});
        ++chains.back().last;
        end = run.where.hi;
        continues_ = true;
    }
    continues_ = continues_ && end == 1;
}

Branches::Branches(const Pieces& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        add_piece(pieces.position(i, 0), pieces.position(i, 1), pieces.hodograph(i, 0),
                  pieces.hodograph(i, 1));
    }
    const auto end = [&](int k) { return pieces.position(pieces.size() - 1, k).back(); };
    const std::array<double, 2> x{end(0), 0}, y{end(1), 0};
    const std::array<double, 1> dx{-end(0)}, dy{-end(1)};
    add_piece(x, y, dx, dy);
    for (Chain& chain : chains) {
        double moment = 0;
        chain.low = arcs[chain.first].low();
        chain.high = arcs[chain.first].high();
        for (std::size_t i = chain.first; i < chain.last; ++i) {
            moments.push_back(moment);
            moment += arcs[i].moment(1);
            chain.low = std::fmin(chain.low, arcs[i].low());
            chain.high = std::fmax(chain.high, arcs[i].high());
        }
    }
}

const Arc& Branches::arc_at(const Chain& chain, double height) const {
    const int sign = arcs[chain.first].sign;
    const auto begins_after = [sign](double h, const Arc& arc) {
        return (arc.y[0] - h) * sign > 0;
    };
    const auto first = arcs.begin() + static_cast<std::ptrdiff_t>(chain.first);
    const auto last = arcs.begin() + static_cast<std::ptrdiff_t>(chain.last);
    return *(std::upper_bound(first + 1, last, height, begins_after) - 1);
}

double Branches::x_at(const Chain& chain, double height) const {
    const Arc& arc = arc_at(chain, height);
    return bernstein::value(arc.x, arc.u_at(height));
}

double Branches::moment_at(const Chain& chain, double height) const {
    const Arc& arc = arc_at(chain, height);
    return moments[static_cast<std::size_t>(&arc - arcs.data())] + arc.moment(arc.u_at(height));
}

std::vector<std::size_t> Branches::chain_of_arc() const {
    std::vector<std::size_t> result;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        result.resize(chains[c].last, c);
    }
    return result;
}

bool overlap(View a, View b) {
    const auto [a_lo, a_hi] = std::minmax_element(a.begin(), a.end());
    const auto [b_lo, b_hi] = std::minmax_element(b.begin(), b.end());
    return *a_lo <= *b_hi && *b_lo <= *a_hi;
}

/// Whether all control points are near to where they are on the chord.
bool is_flat(View x, View y) {
    const double n = static_cast<double>(x.size() - 1);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
        const double u = static_cast<double>(i) / n;
        if (std::fabs(x[i] - (1 - u) * x.front() - u * x.back()) > flatness) return false;
        if (std::fabs(y[i] - (1 - u) * y.front() - u * y.back()) > flatness) return false;
    }
    return true;
}

/// Collects the heights at which two arcs cross.
struct Crossings {
    std::size_t most_heights;
    std::vector<double> heights{};

    void search(View ax, View ay, View bx, View by) {
        if (!overlap(ax, bx) || !overlap(ay, by) || heights.size() > most_heights) return;
        const bool a_flat = is_flat(ax, ay), b_flat = is_flat(bx, by);
        if (a_flat && b_flat) {
            cross_lines(ax, ay, bx, by);
            return;
        }
        const double a_size = std::fabs(ax.back() - ax.front()) + std::fabs(ay.back() - ay.front());
        const double b_size = std::fabs(bx.back() - bx.front()) + std::fabs(by.back() - by.front());
        if (b_flat || (!a_flat && a_size >= b_size)) {
            const bernstein::Halves x = bernstein::split(ax, 0.5), y = bernstein::split(ay, 0.5);
            search(x.left, y.left, bx, by);
            search(x.right, y.right, bx, by);
        } else {
            const bernstein::Halves x = bernstein::split(bx, 0.5), y = bernstein::split(by, 0.5);
            search(ax, ay, x.left, y.left);
            search(ax, ay, x.right, y.right);
        }
    }

    void cross_lines(View ax, View ay, View bx, View by) {
        const double px = ax.back() - ax.front(), py = ay.back() - ay.front();
        const double qx = bx.back() - bx.front(), qy = by.back() - by.front();
        const double dx = bx.front() - ax.front(), dy = by.front() - ay.front();
        const double area = px * qy - py * qx;
        const double s = dx * qy - dy * qx, t = dx * py - dy * px;
        const auto inside = [area](double x) {
            return area > 0 ? x >= -0.01 * area && x <= 1.01 * area
                            : x <= -0.01 * area && x >= 1.01 * area;
        };
        if (area != 0 && inside(s) && inside(t)) heights.push_back(ay.front() + s / area * py);
    }
};

std::vector<double> crossing_heights(const Branches& branches) {
    const std::vector<std::size_t> chain = branches.chain_of_arc();
    std::vector<std::size_t> order(branches.arcs.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const double low_a = branches.arcs[a].low(), low_b = branches.arcs[b].low();
        return low_a != low_b ? low_a < low_b : a < b;
    });
    Crossings crossings{most_pairs / branches.chains.size()};
    std::vector<std::size_t> open;
    for (const std::size_t i : order) {
        const Arc& arc = branches.arcs[i];
        std::erase_if(open,
                      [&](std::size_t j) { return branches.arcs[j].high() < arc.low(); });
        for (const std::size_t j : open) {
            const Arc& other = branches.arcs[j];
            if (chain[i] != chain[j]) crossings.search(other.x, other.y, arc.x, arc.y);
        }
        open.push_back(i);
    }
    return crossings.heights;
}

/// The heights between which no two branches change places, rising.
std::vector<double> levels(const Branches& branches) {
    std::vector<double> heights = crossing_heights(branches);
    for (const Chain& chain : branches.chains) {
        heights.push_back(chain.low);
        heights.push_back(chain.high);
    }
    std::sort(heights.begin(), heights.end());
    const auto is_same = [](double a, double b) { return b - a <= same_height; };
    heights.erase(std::unique(heights.begin(), heights.end(), is_same), heights.end());
    return heights;
}

struct Branch {
    double x;       ///< halfway up
    double moment;  ///< int x dy from low to high, whichever way it is passed
    int sign;
};

std::vector<Branch> branches_between(const Branches& branches, double low, double high) {
    std::vector<Branch> result;
    for (const Chain& chain : branches.chains) {
        const double middle = low + 0.5 * (high - low);
        if (middle <= chain.low || middle >= chain.high) continue;
        result.push_back({branches.x_at(chain, middle),
                          branches.moment_at(chain, high) - branches.moment_at(chain, low),
                          branches.arcs[chain.first].sign});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Branch& a, const Branch& b) { return a.x < b.x; });
    return result;
}

}  // namespace

/// Cuts the plane into horizontal bands in which the branches keep their order: there the winding
/// number between two neighbours is constant and the area between them a difference of moments.
std::optional<AreasByWinding> areas_by_winding(const Pieces& pieces, double signed_area) {
    const Branches branches(pieces);
    if (branches.chains.empty()) return AreasByWinding{};
    const std::vector<double> heights = levels(branches);
    if (heights.size() > most_pairs / branches.chains.size()) return std::nullopt;
    num::Sum positive, negative;
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        int winding = 0;
        const std::vector<Branch> band = branches_between(branches, heights[i], heights[i + 1]);
        looked_at += band.size();
        if (looked_at > most_branches) return std::nullopt;
        for (std::size_t j = 0; j + 1 < band.size(); ++j) {
            winding -= band[j].sign;
            const double between = band[j + 1].moment - band[j].moment;
            if (winding > 0) positive.add(winding * between);
            if (winding < 0) negative.add(-winding * between);
        }
    }
    AreasByWinding areas{std::fmax(positive.value(), 0.0), std::fmax(negative.value(), 0.0)};
    const double least = 0x1p-44 * (areas.positive + areas.negative);
    if (areas.negative <= least) return AreasByWinding{std::fmax(signed_area, 0.0), 0};
    if (areas.positive <= least) return AreasByWinding{0, std::fmax(-signed_area, 0.0)};
    const double excess = signed_area - (areas.positive - areas.negative);
    return AreasByWinding{areas.positive + 0.5 * excess, areas.negative - 0.5 * excess};
}

}  // namespace batten::bezier
