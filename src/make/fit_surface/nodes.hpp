#pragma once

#include <functional>
#include <span>
#include <vector>

#include "batten/make/fit_surface.hpp"

namespace batten::surface_fitting {

/// Takes whole rows that follow each other, from row `first` on.
using TakeRows = std::function<void(std::size_t first, std::span<const double> z)>;

/// Whole rows of which nodes are missing or have errors of their own: the weight of a node is the
/// root of its factor times those of its row and column.
struct MaskedRows {
    std::size_t first = 0;
    std::span<const double> z;          ///< 0 where missing
    std::span<const double> factor_sq;  ///< 0 where missing
};
using TakeMaskedRows = std::function<void(const MaskedRows& rows)>;

/// Heights that are not held but read, as often as they are needed.
class StoredHeights {
public:
    virtual ~StoredHeights() = default;
    /// All rows, block after block.
    virtual void read(const TakeRows& take) = 0;
    /// What all errors are to be times, known once the rows have been read.
    virtual double unit() const = 0;
    /// The least and the largest height, where nodes are missing.
    virtual Interval heights() const = 0;
    /// The lines with any height, where nodes are missing.
    virtual std::vector<double> used_x() const = 0;
    virtual std::vector<double> used_y() const = 0;
};

/// What a surface fit works on: heights on a grid and their weights, 1 / sigma.
struct Nodes {
    std::span<const double> x, y;
    std::span<const double> z;                 ///< x slowest; missing ones are 0
    StoredHeights* stored = nullptr;           ///< where z does not hold them
    std::vector<double> x_weight, y_weight;    ///< the weight of node (r, s) is their product
    std::vector<double> cell_factor_sq;        ///< times the root of this; empty: 1 everywhere
    std::size_t count = 0;                     ///< nodes with a height and a weight
    std::size_t missing = 0;
    bool sigma_known = false;
    SigmaSource source = SigmaSource::estimated;
    std::optional<double> sigma;               ///< where it is one number
    double least_delta2 = 0;                   ///< what rounding leaves, where errors are estimated
    std::vector<double> filled;                ///< owns z where nodes are missing

    bool is_full() const { return cell_factor_sq.empty() && missing == 0; }
    /// Whether each node either is missing or has the errors of its row and column.
    bool is_mask_only() const;
    /// The least and the largest height of the nodes that count, which are not full.
    Interval heights() const;
    void for_rows(const TakeRows& take) const { stored ? stored->read(take) : take(0, z); }
    /// Of nodes that are not full.
    void for_masked_rows(const TakeMaskedRows& take) const;
    /// The lines with any node that counts.
    std::vector<double> used_x() const;
    std::vector<double> used_y() const;

    Nodes() = default;
    Nodes(Nodes&&) = default;
    Nodes& operator=(Nodes&&) = default;
};

/// Throws `points.not-finite` at the first height that is none. Asked only where a result is not
/// finite: one that is not spoils all sums.
void require_finite_heights(const Nodes& nodes);

/// Checks everything that `fit_surface` promises to check about the samples but their heights.
Nodes prepared_nodes(const SurfaceSamples& samples, const FitSurfaceOptions& options);

}  // namespace batten::surface_fitting
