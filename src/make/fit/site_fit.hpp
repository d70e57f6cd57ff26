#pragma once

#include <vector>

#include "batten/base/interval.hpp"

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

/// delta2 of the best spline over given sites.
class SiteFit {
public:
    virtual ~SiteFit() = default;
    virtual Interval domain() const = 0;
    virtual int order() const = 0;
    /// How often a knot may stand.
    virtual int most_times() const = 0;
    /// Coefficients of all sides.
    virtual int parameters(const BrokenSites& sites) const = 0;
    /// Infinity where the samples do not determine the spline.
    virtual double value(const BrokenSites& sites) = 0;
};

}  // namespace batten::fitting
