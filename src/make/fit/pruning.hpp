#pragma once

#include <span>
#include <vector>

#include "make/fit/samples.hpp"
#include "make/fit/site_fit.hpp"

namespace batten::fitting {

/// A set of sites that is changed one site at a time, as long as a criterion falls: delta2, or
/// N ln delta2 where sigma is not known, and ln N for every parameter, places counted by how exactly
/// the data know them.
///
/// A coefficient counts as one, each coordinate's by itself. The place of a jump is known to one gap
/// of N and counts as two [ZhangSiegmund2007]; that of a corner, known to the root of that, as one
/// and a half, at which smooth data get one in 1 of 20 sets (as one: in 5); that of a knot as a half:
/// as nothing, a tenth more knots are left at N = 201 for the same error, as one, narrow peaks have
/// an error a fifth larger.
class Pruning {
public:
    Pruning(SiteFit& fit, const Samples& samples, BrokenSites start);

    const BrokenSites& sites() const { return sites_; }
    double cost() const { return cost_; }

    /// Takes out, moves, stacks and puts in knots. Whether anything was gained.
    bool sweep();
    /// Puts in breaks: in place of the knots around, and at `places`. Whether anything was gained.
    bool put_in_breaks(std::span<const double> places);
    /// One break or knot after the other, each the best there is. False as soon as the set will
    /// hardly become cheaper than `other`: not if all it may still add gained as much as the last.
    bool grow(std::span<const double> places, const Pruning& other);

private:
    using Kind = bool BrokenSite::*;
    /// Something that may be added.
    struct Candidate {
        double place;
        Kind kind;  ///< null: a knot
    };

    double unit() const;
    double charge_of(const BrokenSites& sites) const;
    double cost_of(const BrokenSites& sites);
    bool is_ordered(const BrokenSites& sites) const;
    bool take(BrokenSites next);
    bool take_at(BrokenSites next, double cost);
    double before(std::size_t j) const;
    double after(std::size_t j) const;

    void take_out();
    void move();
    void move_to(std::size_t j, double place);
    void stack();
    void put_in();

    void break_beside(double place);
    void break_at(double place, Kind kind);
    bool add_best(std::span<const double> places);
    std::vector<Candidate> candidates(std::span<const double> places) const;
    BrokenSites with(const Candidate& candidate) const;
    void refine(double place);

    std::span<const Kind> kinds() const;
    bool has_room(const BrokenSite& site) const;
    bool can_say(const BrokenSites& sites, double place) const;
    double gap_beside(double place, int step) const;

    SiteFit* fit_;
    const Samples* samples_;
    BrokenSites sites_;
    double cost_;
};

}  // namespace batten::fitting
