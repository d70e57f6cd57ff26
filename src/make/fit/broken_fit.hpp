#pragma once

#include <vector>

#include "make/fit/fixed_fit.hpp"
#include "make/fit/span_triangles.hpp"

/// Splines with knots, and with places where one derivative alone is broken.
namespace batten::fitting {

/// A place where a spline is not smooth: `times` knots, and beside them a jump of the value or of
/// the slope that leaves all other derivatives as smooth as the knots do.
struct BrokenSite {
    double at = 0;
    int times = 0;
    bool jump = false;    ///< of the value
    bool corner = false;  ///< of the slope

    int alone() const { return int(jump) + int(corner); }
};

/// Sites rising; every one has a knot or is broken.
using BrokenSites = std::vector<BrokenSite>;

int knots_in(const BrokenSites& sites);
int alone_in(const BrokenSites& sites);

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
class BrokenFit {
public:
    BrokenFit(const Samples& samples, const LocalBasis& basis);

    Interval domain() const { return samples_.range; }
    int order() const { return basis_.order(); }

    /// Infinity where the samples do not determine the spline over the stacked knots. Cost: a
    /// triangle an interval from a cache, O(p (order + breaks)^2).
    double value(const BrokenSites& sites);

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
