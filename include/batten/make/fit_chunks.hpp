#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "batten/make/fit.hpp"

namespace batten {

/// Data reduced to what a spline over given knots needs to know of them: a small triangle per
/// interval. Chunks of data too large for the memory, or on many machines, are reduced one by one
/// and merged; memory: (degree + 1) (degree + 3) + 1 numbers an interval, whatever the data.
///
/// Laws: (1) merging in any order and grouping gives the same fit to rounding
///       (2) one chunk gives the fit of `fit` with these knots, to rounding
class FitChunk {
public:
    /// `domain` and the interior knots, rising, repeated for multiplicity. Throws `fit.knots`,
    /// `option.range` for a degree that is not 0 to 9.
    FitChunk(Interval domain, std::vector<double> interior_knots, int degree);

    /// Takes in measurements with known errors: samples.sigma, or `sigma` for all.
    /// Any number of them, of any abscissae. Throws as `fit` does else, and `fit.outside` where an
    /// abscissa is not in the domain.
    void add(const FitSamples& samples, double sigma = 1);
    /// Takes in what another chunk over the same knots and degree has seen; throws
    /// `fit.chunks-differ` where they are not the same.
    void merge(const FitChunk& other);

    std::size_t samples() const { return samples_; }
    std::span<const double> knots() const { return knots_; }
    int degree() const { return degree_; }

    /// The fit. The report's psi, runs and largest residual stay empty: they need the samples.
    /// Throws `fit.too-few` for fewer samples than coefficients.
    Fit solve() const;

private:
    std::vector<double> knots_;
    int degree_;
    std::vector<double> triangles_;
    std::vector<std::vector<double>> places_;  ///< up to degree + 3 distinct abscissae an interval
    std::size_t samples_ = 0;
};

/// Samples that come in blocks, as often as they are needed.
struct FitStream {
    using Take = std::function<void(const FitSamples&)>;
    /// Hands over block after block, from the first sample on.
    std::function<void(const Progress&, const Take&)> read;
};

/// `fit` of samples that memory does not hold: they are read three times. Knots are given, or equal
/// with `intervals`; errors are `options.sigma` or the samples' own. The report has no `runs_p`.
///
/// Law:    blocks of any size give the fit of `fit` with these knots, to rounding
/// Throws: what `fit` throws about samples and knots; `fit.streamed` for knots that need a search and
///         errors that are not known. Other options are not looked at.
Fit fit(const FitStream& stream, const FitOptions& options);

}  // namespace batten
