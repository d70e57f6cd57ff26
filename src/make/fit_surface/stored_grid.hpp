#pragma once

#include <optional>

#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/grid_lines.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// What a reading of heights ends with that finds the first missing one.
struct HolesFound {};

/// The heights of a stream. The error, unless it is given, is estimated while they are first read.
class StoredGrid : public StoredHeights {
public:
    /// Throws what `fit_surface` throws of the lines and their errors. Borrows the stream.
    StoredGrid(const SurfaceStream& stream, std::optional<double> sigma, const Progress& progress);

    /// Throws `points.not-finite`, and HolesFound unless the holes have been counted.
    void read(const TakeRows& take) override;
    double unit() const override;
    Interval heights() const override { return heights_; }
    std::vector<double> used_x() const override { return used_x_; }
    std::vector<double> used_y() const override { return used_y_; }

    /// Reads the heights for how many are missing, and for the error.
    void count_holes();

    bool has_own_errors() const { return has_own_errors_; }
    bool is_estimated() const { return !has_own_errors_ && !sigma_; }
    /// The lines with their weights, to which these heights belong.
    Nodes nodes();
    /// Some of the rows, with their lines.
    SurfaceRows rows(std::size_t first, std::span<const double> z) const;

private:
    const SurfaceStream& stream_;
    bool has_own_errors_;
    std::optional<double> sigma_;
    Progress progress_;
    double done_ = 0;  ///< the share of the work, as far as it is told
    bool is_first_ = true;
    MixedNoiseOfRows noise_;
    bool expects_holes_ = false;
    std::size_t missing_ = 0;
    Interval heights_ = no_heights;
    std::vector<double> used_x_, used_y_;  ///< lines with any height, where some are missing
};

}  // namespace batten::surface_fitting
