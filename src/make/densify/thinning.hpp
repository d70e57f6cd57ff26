#pragma once

#include <cstddef>
#include <vector>

#include "batten/base/points.hpp"
#include "batten/make/thin.hpp"
#include "make/densify/cell_curve.hpp"
#include "make/densify/curve_gap.hpp"

namespace batten::lagrange {

/// The choice of points to keep. A choice is a list of rising rows, with both ends of an open row
/// and point 0 of a ring among them.
class Thinning {
public:
    using Choice = std::vector<std::size_t>;

    /// Throws what `densify` throws.
    Thinning(PointsView points, const ThinOptions& options);
    /// The smallest choice found for which the two curves are within the tolerance, measured so.
    Choice found(Care care) const;

    const Points& points() const { return points_; }
    double tolerance() const { return tolerance_; }
    int degree() const { return options_.degree; }

    Points rows(const Choice& choice) const;
    /// The largest distance between the curve of all points and that of the chosen ones.
    double error(const Choice& choice) const;
    /// For each given cell, how far its curve moves with the next higher degree.
    std::vector<double> own_errors() const;

private:
    std::size_t fewest() const;
    std::ptrdiff_t reach() const;
    Choice all() const;
    /// The first choice that meets the tolerance, by rising count, in steps of 1/32 and wherever
    /// all gaps can be equal; elsewhere they change once, by one.
    Choice strided(Care care) const;
    /// The smallest choice found whose gaps follow one density, errors evened out in rounds.
    Choice evenly(Care care) const;
    /// `choice` with points taken out one by one, where the error is smallest first; the points
    /// beside the gap, none to 8 on each side, move to fill it.
    Choice reduced(Choice choice, Care care) const;
    Match match(const CellCurve& kept, std::size_t cell, const Choice& choice) const;
    bool meets(const Choice& choice, Care care) const;
    std::vector<double> errors(const Choice& choice, double enough, Care care) const;
    bool meets_between(const Choice& choice, std::ptrdiff_t lo, std::ptrdiff_t hi,
                       Care care) const;
    Choice without(const Choice& choice, std::size_t place, std::size_t spread) const;
    Choice spaced(const std::vector<double>& density, std::size_t count) const;
    std::vector<double> evened(const std::vector<double>& density, const Choice& choice,
                               const std::vector<double>& errors) const;
    Choice met_with(std::size_t count, Care care) const;

    DensifyOptions options_;
    Points points_;
    CellCurve curve_;
    double tolerance_;
};

}  // namespace batten::lagrange
