#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/grid_lines.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "make/fit_surface/shape_of_surface.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

constexpr std::size_t numbers_at_once = std::size_t{1} << 20;

/// Only what needs no heights.
void require_fixed_lines(const FitSurfaceOptions& options) {
    const bool is_given = options.knots == SurfaceKnots::given || !options.x_knots.empty() ||
                          !options.y_knots.empty();
    const bool is_equal = options.knots == SurfaceKnots::equal && !options.intervals.empty();
    if (options.knots != SurfaceKnots::free && (is_given || is_equal)) return;
    throw Error("fit-surface.streamed", "knots", std::string(name_of(options.knots)),
                "a grid read in blocks takes given knot lines, or equal ones with intervals: "
                "search for them on a part of it, or on every tenth row and column");
}

/// The lines without their heights: enough for knots that do not depend on these.
Nodes lines_of(const SurfaceStream& stream) {
    require_lines(stream.x, "x");
    require_lines(stream.y, "y");
    require_errors(stream.x_sigma, stream.x.size(), "x_sigma");
    require_errors(stream.y_sigma, stream.y.size(), "y_sigma");
    Nodes lines;
    lines.x = stream.x;
    lines.y = stream.y;
    lines.x_weight = weights_of(stream.x_sigma, stream.x.size());
    lines.y_weight = weights_of(stream.y_sigma, stream.y.size());
    lines.count = stream.x.size() * stream.y.size();
    return lines;
}

/// Blocks of rows one after the other.
template <class Take>
void for_blocks(const SurfaceStream& stream, const Progress& progress, Take take) {
    const std::size_t rows = stream.x.size(), columns = stream.y.size();
    const std::size_t at_once = std::clamp<std::size_t>(numbers_at_once / columns, 1, rows);
    std::vector<double> z(at_once * columns);
    for (std::size_t first = 0; first < rows; first += at_once) {
        const std::size_t count = std::min(at_once, rows - first);
        const std::span<double> block(z.data(), count * columns);
        stream.read(first, block);
        take(SurfaceRows{stream.x.subspan(first, count), block,
                         stream.x_sigma.empty() ? stream.x_sigma
                                                : stream.x_sigma.subspan(first, count)});
        progress.at(first + count, rows);
    }
}

}  // namespace

SurfaceFit fit_surface(const SurfaceStream& stream, const FitSurfaceOptions& options,
                       const Progress& progress) {
    require_fixed_lines(options);
    const Nodes lines = lines_of(stream);
    const SurfaceChoice choice = choose_lines(lines, options);
    const SurfaceColumns columns{{stream.y.begin(), stream.y.end()},
                                 {stream.y_sigma.begin(), stream.y_sigma.end()}};
    const bool has_column = !stream.x_sigma.empty() || !stream.y_sigma.empty();
    const bool is_estimated = !has_column && !options.sigma;
    double sigma = has_column ? 1 : options.sigma.value_or(1);
    SurfaceChunk chunk(BSplineBasis(choice.x_knots, options.degree),
                       BSplineBasis(choice.y_knots, options.degree), columns);
    MixedNoiseOfRows noise(columns.y);
    for_blocks(stream, progress.stage(0, 0.6), [&](const SurfaceRows& rows) {
        chunk.add(rows, sigma);
        if (!is_estimated) return;
        for (std::size_t r = 0; r < rows.x.size(); ++r) {
            noise.add(rows.x[r], rows.z.subspan(r * columns.y.size(), columns.y.size()));
        }
    });
    SurfaceFit fit = chunk.solve();
    if (is_estimated && noise.sigma() > 0) sigma = noise.sigma();
    if (!has_column) {
        fit.report.sigma = sigma;
        fit.report.sigma_source = is_estimated ? SigmaSource::estimated : SigmaSource::number;
    }
    SurfaceResiduals residuals(fit.surface, columns);
    for_blocks(stream, progress.stage(0.6, 1),
               [&](const SurfaceRows& rows) { residuals.add(rows, sigma); });
    residuals.fill(fit.report);
    fit.report.separability = separability(fit.surface, stream.x, stream.y);
    fit.report.oscillation = oscillation(fit.surface, stream.x, stream.y);
    return fit;
}

}  // namespace batten
