#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/compressed.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/shape_of_surface.hpp"
#include "make/fit_surface/stored_grid.hpp"

namespace batten {
namespace {

using namespace surface_fitting;

/// Whether the knot lines need no heights.
bool has_fixed_lines(const FitSurfaceOptions& options) {
    if (options.knots == SurfaceKnots::free) return false;
    return options.knots == SurfaceKnots::given || !options.x_knots.empty() ||
           !options.y_knots.empty() ||
           (options.knots == SurfaceKnots::equal && !options.intervals.empty());
}

/// A search works on products with the splines over fine strips, which do not tell everything.
void require_streamed_search(const FitSurfaceOptions& options) {
    const auto refuse = [](const char* option, std::string value, const char* rule) {
        throw Error("fit-surface.streamed", option, std::move(value), rule);
    };
    if (options.knots != SurfaceKnots::automatic) {
        refuse("knots", std::string(name_of(options.knots)),
               "a grid read in blocks takes knots auto, given, or equal with intervals: let auto "
               "find the lines, or search on every tenth row and column and give the lines");
    }
    if (options.rule != StripRule::projected) {
        refuse("rule", std::string(name_of(options.rule)),
               "in a grid read in blocks knot lines are searched by the projected rule only");
    }
    if (options.stop == StopRule::distribution && options.intervals.empty() && !options.delta2) {
        refuse("stop", "distribution",
               "residuals of a grid read in blocks are counted at the end only: stop by a "
               "criterion, chi2 or delta2");
    }
    if (options.degree == 0) {
        refuse("degree", "0", "steps over a grid read in blocks need knots equal with intervals, "
                              "or given");
    }
}

/// A grid that is smaller than what a search would keep of it.
SurfaceFit held_fit(const SurfaceStream& stream, StoredGrid& grid,
                    const FitSurfaceOptions& options) {
    const std::size_t rows = stream.x.size(), columns = stream.y.size();
    std::vector<double> z(rows * columns);
    grid.read([&](std::size_t first, std::span<const double> block) {
        std::copy(block.begin(), block.end(),
                  z.begin() + static_cast<std::ptrdiff_t>(first * columns));
    });
    return fit_surface({stream.x, stream.y, GridView(z.data(), rows, columns, 1), stream.x_sigma,
                        stream.y_sigma},
                       options);
}

/// The fit of a search that knows its coefficients.
SurfaceFit known_fit(SurfaceChoice& choice) {
    SurfaceFit fit{SplineSurface(choice.x->basis(), choice.y->basis(),
                                 std::move(choice.solution->coefficients)),
                   {}};
    fill_lines(fit.report, fit.surface);
    fit.report.parameters_charged = fit.report.parameters;
    return fit;
}

SurfaceFit read_fit(const SurfaceChoice& choice, StoredGrid& grid, const SurfaceColumns& columns,
                    const FitSurfaceOptions& options) {
    SurfaceChunk chunk(BSplineBasis(choice.x_knots, options.degree),
                       BSplineBasis(choice.y_knots, options.degree), columns);
    // An error that is estimated is known only after this reading, and does not move the fit.
    const double sigma = grid.is_estimated() ? 1 : grid.unit();
    grid.read([&](std::size_t first, std::span<const double> z) {
        chunk.add(grid.rows(first, z), sigma);
    });
    return chunk.solve();
}

void measure(SurfaceFit& fit, StoredGrid& grid, const SurfaceColumns& columns) {
    if (!grid.has_own_errors()) {
        fit.report.sigma = grid.unit();
        fit.report.sigma_source =
            grid.is_estimated() ? SigmaSource::estimated : SigmaSource::number;
    } else {
        fit.report.sigma_source = SigmaSource::column;
    }
    const double sigma = grid.unit();
    SurfaceResiduals residuals(fit.surface, columns);
    grid.read([&](std::size_t first, std::span<const double> z) {
        residuals.add(grid.rows(first, z), sigma);
    });
    residuals.fill(fit.report);
}

}  // namespace

SurfaceFit fit_surface(const SurfaceStream& stream, const FitSurfaceOptions& options,
                       const Progress& progress) {
    StoredGrid grid(stream, options.sigma, progress);
    Nodes nodes = grid.nodes();
    const bool searches = !has_fixed_lines(options);
    if (searches && nodes.count < worth_compressing) return held_fit(stream, grid, options);
    if (searches) require_streamed_search(options);
    if (!grid.is_estimated()) {
        for (double& weight : nodes.x_weight) weight /= grid.unit();
    }
    SurfaceChoice choice = choose_lines(nodes, options);
    const SurfaceColumns columns{{stream.y.begin(), stream.y.end()},
                                 {stream.y_sigma.begin(), stream.y_sigma.end()}};
    SurfaceFit fit = choice.solution ? known_fit(choice) : read_fit(choice, grid, columns, options);
    measure(fit, grid, columns);
    fit.report.separability = separability(fit.surface, stream.x, stream.y);
    fit.report.oscillation = oscillation(fit.surface, stream.x, stream.y);
    fit.report.path = std::move(choice.path);
    fit.report.notes = std::move(choice.notes);
    if (fit.report.status == Status::met && !choice.is_met) fit.report.status = Status::not_met;
    progress.at(1, 1);
    return fit;
}

}  // namespace batten
