#include "share_builder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "batten/base/interval.hpp"
#include "chebyshev_fit.hpp"
#include "make/pseudo/tables/end_slopes.hpp"
#include "make/pseudo/three_point.hpp"
#include "num/patch_kernel.hpp"

namespace batten::pseudo {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t equal_turn_parts = 8;
constexpr int kink_gradings = 3;  // J beyond the second kink all but has a fold there
constexpr int cells = 256;  // the unit of the cuts

using Function = std::function<double(double, double)>;

Share share_of(Interval xs, Interval ys, const Function& f) {
    Share values{}, c{};  // values[i][j] for x i, y j
    for (std::size_t i = 0; i < share_size; ++i) {
        const double x = xs.middle() + 0.5 * xs.length() * node<share_size>(i);
        for (std::size_t j = 0; j < share_size; ++j) {
            values[i][j] = f(x, ys.middle() + 0.5 * ys.length() * node<share_size>(j));
        }
        values[i] = fitted(values[i]);
    }
    for (std::size_t j = 0; j < share_size; ++j) {
        for (std::size_t i = 0; i < share_size; ++i) c[j][i] = values[i][j];
        c[j] = fitted(c[j]);
    }
    return c;
}

Interval part_of(Interval whole, std::size_t k, std::size_t count) {
    const double step = whole.length() / static_cast<double>(count);
    const double lo = whole.lo + static_cast<double>(k) * step;
    return {lo, lo + step};
}

double share_from(double u, double turn, double weight) {
    return u * (1 + weight) / (weight * turn);
}

double exact_share(double turn, double weight) {
    return share_from(three_point_angle({turn, 1, weight}, 1).angle, turn, weight);
}

/// u below the first kink, turn - u in a band.
class Bands {
public:
    Bands(std::span<const double> kinks, std::span<const EndPiece> pieces)
        : kinks_(kinks), pieces_(pieces) {
        fill_turns();
        for (std::size_t band = 0; band < bands; ++band) {
            cuts_[band] = {0};
            cut(band, {0, cells});
        }
    }
    const std::vector<TurnPart>& turns() const { return turns_; }
    const std::array<std::vector<int>, bands>& cuts() const { return cuts_; }
    void add_shares(const TurnPart& turn, std::vector<Share>& shares) const;

private:
    struct Cells {
        int lo, hi;
    };
    struct Least {
        double u, energy;
    };
    double lowest(std::size_t band) const { return band == 0 ? 0 : kinks_[band - 1]; }
    double highest(std::size_t band) const { return band < kinks_.size() ? kinks_[band] : pi; }
    Slopes slopes(std::size_t band, double theta) const;
    Least least(std::size_t band, double turn, double weight) const;
    double tie(std::size_t k, double turn) const;
    void fill_turns();
    double weight(const TurnPart& part, std::size_t band, double turn, double y) const;
    Share share_of_cells(const TurnPart& part, std::size_t band, Cells y) const;
    double error(const TurnPart& part, std::size_t band, Cells y) const;
    bool is_good(std::size_t band, Cells y) const;
    void cut(std::size_t band, Cells y);

    std::span<const double> kinks_;
    std::span<const EndPiece> pieces_;
    std::vector<TurnPart> turns_;
    std::array<std::vector<int>, bands> cuts_;
};

/// Of the band's own J, carried on a little beyond its ends.
Slopes Bands::slopes(std::size_t band, double theta) const {
    const EndPiece* found = nullptr;
    for (const EndPiece& piece : pieces_) {
        if (piece.lo < lowest(band) || piece.hi > highest(band)) continue;
        if (!found || theta >= piece.lo) found = &piece;
    }
    return slopes_on(*found, theta);
}

Bands::Least Bands::least(std::size_t band, double turn, double weight) const {
    constexpr double beyond = 1e-3;
    const double lo = std::max(0.0, turn - highest(band)) - beyond;
    const double hi = std::min(kinks_[0], turn - lowest(band)) + beyond;
    double u = 0.5 * (lo + hi);
    for (int i = 0; i < 60; ++i) {
        const Slopes heavy = slopes(0, u), light = slopes(band, turn - u);
        const double step = -(heavy.first - weight * light.first) /
                            (heavy.second + weight * light.second);
        u = std::clamp(u + step, lo, hi);
    }
    return {u, slopes(0, u).value + weight * slopes(band, turn - u).value};
}

/// The weight at which bands k and k + 1 are equally good.
double Bands::tie(std::size_t k, double turn) const {
    Interval weight{0, 1.5};
    for (int i = 0; i < 60; ++i) {
        const double middle = weight.middle();
        const bool is_further = least(k + 1, turn, middle).energy < least(k, turn, middle).energy;
        (is_further ? weight.lo : weight.hi) = middle;
    }
    return weight.middle();
}

void Bands::fill_turns() {
    Interval last{1.6, 1.9};
    for (int i = 0; i < 60; ++i) (tie(0, last.middle()) < 1 ? last.lo : last.hi) = last.middle();
    std::vector<double> ends{kinks_[0], kinks_[1]};
    for (int i = kink_gradings; i >= 0; --i) {
        ends.push_back(kinks_[1] + std::ldexp(kinks_[2] - kinks_[1], -i));
    }
    for (std::size_t i = 1; i <= equal_turn_parts; ++i) {
        const double at = static_cast<double>(i) / equal_turn_parts;
        ends.push_back(kinks_[2] + (last.lo - kinks_[2]) * at);
    }
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        TurnPart part{ends[i], ends[i + 1], {}};
        for (std::size_t k = 0; k < part.ties.size() && kinks_[k] <= part.lo; ++k) {
            std::array<double, share_size> values{};
            for (std::size_t n = 0; n < share_size; ++n) {
                values[n] = tie(k, 0.5 * (part.lo + part.hi) +
                                       0.5 * (part.hi - part.lo) * node<share_size>(n));
            }
            part.ties[k] = fitted(values);
        }
        turns_.push_back(part);
    }
}

/// Between the ties as they are tabulated.
double Bands::weight(const TurnPart& part, std::size_t band, double turn, double y) const {
    const double x = (2 * turn - (part.lo + part.hi)) / (part.hi - part.lo);
    const auto tied = [&](std::size_t k) { return patches::polynomial_8(part.ties[k].data(), x); };
    const double upper = band == 0 ? 1 : tied(band - 1);
    const double lower = band + 1 == bands ? 0 : tied(band);
    return lower + y * (upper - lower);
}

Share Bands::share_of_cells(const TurnPart& part, std::size_t band, Cells y) const {
    return share_of({part.lo, part.hi}, {y.lo / double{cells}, y.hi / double{cells}},
                    [&](double turn, double at) {
                        const double w = weight(part, band, turn, at);
                        return share_from(least(band, turn, w).u, turn, w);
                    });
}

/// The largest error of u against the turn, by 35 tests between the nodes.
double Bands::error(const TurnPart& part, std::size_t band, Cells y) const {
    const Share c = share_of_cells(part, band, y);
    double worst = 0;
    for (const double s : {-0.95, -0.4, 0.1, 0.6, 0.95}) {
        for (const double t : {-0.99, -0.9, -0.4, 0.1, 0.6, 0.9, 0.99}) {
            const double turn = 0.5 * (part.lo + part.hi) + 0.5 * (part.hi - part.lo) * s;
            const double at = (0.5 * (y.lo + y.hi) + 0.5 * (y.hi - y.lo) * t) / cells;
            const double w = weight(part, band, turn, at);
            const double u = patches::polynomial_8x8(c[0].data(), s, t) * turn * w / (1 + w);
            worst = std::max(worst, std::fabs(u - least(band, turn, w).u) / turn);
        }
    }
    return worst;
}

/// Whether no part of the turn is further off than half of what is promised.
bool Bands::is_good(std::size_t band, Cells y) const {
    return std::all_of(turns_.begin(), turns_.end(), [&](const TurnPart& part) {
        return part.lo < lowest(band) || error(part, band, y) < 5e-11;
    });
}

/// Halves until all is good.
void Bands::cut(std::size_t band, Cells y) {
    if (y.hi - y.lo > 1 && !is_good(band, y)) {
        const int middle = (y.lo + y.hi) / 2;
        cut(band, {y.lo, middle});
        return cut(band, {middle, y.hi});
    }
    cuts_[band].push_back(y.hi);
}

void Bands::add_shares(const TurnPart& turn, std::vector<Share>& shares) const {
    for (std::size_t band = 0; band < bands; ++band) {
        const std::vector<int>& cuts = cuts_[band];
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const bool is_there = turn.lo >= lowest(band);
            shares.push_back(is_there ? share_of_cells(turn, band, {cuts[i], cuts[i + 1]})
                                      : Share{});
        }
    }
}

}  // namespace

ShareTables share_tables(std::span<const double> kinks, std::span<const EndPiece> pieces) {
    const Bands banded(kinks, pieces);
    ShareTables tables{banded.turns(), banded.cuts(), {}};
    for (std::size_t i = 0; i < smooth_parts; ++i) {
        for (std::size_t j = 0; j < weight_parts; ++j) {
            tables.shares.push_back(share_of(part_of({0, kinks.front()}, i, smooth_parts),
                                             part_of({0, 1}, j, weight_parts), exact_share));
        }
    }
    for (const TurnPart& turn : tables.turns) banded.add_shares(turn, tables.shares);
    for (std::size_t i = 0; i < far_parts; ++i) {
        tables.shares.push_back(share_of(part_of({tables.turns.back().hi, pi}, i, far_parts),
                                         {0, 1}, exact_share));
    }
    return tables;
}

}  // namespace batten::pseudo
