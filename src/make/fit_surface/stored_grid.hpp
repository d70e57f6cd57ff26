#pragma once

#include <optional>

#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// The heights of a stream. The error, unless it is given, is estimated while they are first read.
class StoredGrid : public StoredHeights {
public:
    /// Throws what `fit_surface` throws of the lines and their errors. Borrows the stream.
    StoredGrid(const SurfaceStream& stream, std::optional<double> sigma, const Progress& progress);

    /// Throws `points.not-finite`.
    void read(const TakeRows& take) override;
    double unit() const override;

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
};

}  // namespace batten::surface_fitting
