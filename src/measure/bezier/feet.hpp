#pragma once

#include <span>

#include "batten/measure/nearest.hpp"
#include "measure/bezier/box_tree.hpp"
#include "measure/bezier/pieces.hpp"

namespace batten::bezier {

/// Where the perpendicular from a point meets the curve.
struct Foot {
    std::size_t piece = 0;
    double u = 0;
    double distance_sq = 0;  ///< in normal units
};

/// Finds nearest points on one curve.
class Feet {
public:
    explicit Feet(const Pieces& pieces);

    /// The nearest point to `point`, in normal units.
    Foot nearest(std::span<const double> point) const;
    /// The same in the words of the user, for a point of the data.
    Nearest told(std::span<const double> point) const;

private:
    int side(const Foot& foot, std::span<const double> point,
             std::span<const double> on_curve) const;

    double end_distance_sq(std::size_t piece, std::span<const double> point) const;
    double chord_distance(std::size_t piece, std::span<const double> point) const;

    const Pieces& pieces_;
    BoxTree tree_;
    std::vector<double> thickness_;  // how far each piece is from its chord, at most
};

}  // namespace batten::bezier
