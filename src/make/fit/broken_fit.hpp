#pragma once

#include <vector>

#include "make/fit/fixed_fit.hpp"
#include "make/fit/site_fit.hpp"
#include "make/fit/span_triangles.hpp"

/// Splines with knots, and with places where one derivative alone is broken.
namespace batten::fitting {

/// The same spline space as knots stacked at the sites, some of whose derivatives are held.
struct StackedKnots {
    std::vector<double> knots;  ///< the full vector
    std::vector<HeldDerivative> held;
};
StackedKnots stacked(const BrokenSites& sites, Interval domain, int order);

/// delta2 of the best spline over given sites. Open splines, one side.
///
/// A knot adds a B-spline; a break at t adds a column (x - t)_+^d to the border of the banded
/// system, d = 0 for a jump and 1 for a corner: one coefficient, where stacked knots take
/// order - d.
class BrokenFit final : public SiteFit {
public:
    BrokenFit(const Samples& samples, const LocalBasis& basis);

    Interval domain() const override { return samples_.range; }
    int order() const override { return basis_.order(); }
    int most_times() const override { return order(); }
    int parameters(const BrokenSites& sites) const override {
        return knots_in(sites) + alone_in(sites) + order();
    }

    /// Infinity where the samples do not determine the spline over the stacked knots. Cost: a
    /// triangle an interval from a cache, O(p (order + breaks)^2).
    double value(const BrokenSites& sites) override;

private:
    /// One interval between sites.
    struct Piece {
        Interval span;
        Rows rows;
        std::size_t knot;  ///< index of its left end in the vector without breaks
    };
    bool lay_out(const BrokenSites& sites);
    void absorb(const Piece& piece, std::size_t index);

    const Samples& samples_;
    const LocalBasis& basis_;
    SpanTriangles reduced_;
    KnotSystem system_;
    num::BandedQr qr_;
    std::vector<double> knots_, stacked_, map_, block_, rows_;
    std::vector<Piece> pieces_;
    std::vector<HeldDerivative> breaks_;
    std::vector<Cell> cells_;
    double rest_ = 0;
};

}  // namespace batten::fitting
