#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/make/fit_surface_chunks.hpp"
#include "make/fit_surface/choice.hpp"
#include "make/fit_surface/compressed.hpp"
#include "make/fit_surface/filled_report.hpp"
#include "make/fit_surface/masked_normals.hpp"
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
    Grid z(rows, columns);
    grid.read([&](std::size_t first, std::span<const double> block) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            const std::size_t r = first + k / columns, s = k % columns;
            if (std::isnan(block[k])) z.drop(r, s);
            else z(r, s) = block[k];
        }
    });
    return fit_surface({stream.x, stream.y, z, stream.x_sigma, stream.y_sigma}, options);
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

/// The same where nodes are missing.
SurfaceFit masked_fit(const SurfaceChoice& choice, const Nodes& nodes,
                      const FitSurfaceOptions& options) {
    const Axis x(BSplineBasis(choice.x_knots, options.degree), nodes.x, nodes.x_weight,
                 nodes.used_x());
    const Axis y(BSplineBasis(choice.y_knots, options.degree), nodes.y, nodes.y_weight,
                 nodes.used_y());
    require_enough_nodes(nodes.count, x.functions() * y.functions());
    MaskedNormals normals(x, y);
    nodes.for_masked_rows([&](const MaskedRows& rows) { normals.add(rows); });
    Solution solution = normals.solution();
    SurfaceFit fit{SplineSurface(x.basis(), y.basis(), std::move(solution.coefficients)), {}};
    FitSurfaceReport& report = fit.report;
    fill_lines(report, fit.surface);
    report.parameters_charged = report.parameters;
    report.iterations = solution.iterations;
    report.undetermined = open_coefficients(normals.diagonal(), x, y);
    if (!solution.is_converged) report.status = Status::not_converged;
    if (!report.undetermined.empty()) report.status = Status::rank_deficient;
    return fit;
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

SurfaceFit fit_stored(const SurfaceStream& stream, StoredGrid& grid,
                      const FitSurfaceOptions& options) {
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
    SurfaceFit fit = !nodes.is_full()  ? masked_fit(choice, nodes, options)
                     : choice.solution ? known_fit(choice)
                                       : read_fit(choice, grid, columns, options);
    measure(fit, grid, columns);
    fit.report.separability = separability(fit.surface, stream.x, stream.y);
    fit.report.oscillation = oscillation(fit.surface, stream.x, stream.y);
    fit.report.path = std::move(choice.path);
    fit.report.notes = std::move(choice.notes);
    if (fit.report.status == Status::met && !choice.is_met) fit.report.status = Status::not_met;
    if (!fit.report.undetermined.empty()) fit.report.notes.push_back(note_of_holes);
    if (nodes.missing > 0) note_what_lies_beyond(fit.report, fit.surface, nodes.heights());
    note_what_is_badly_fitted(fit.report);
    return fit;
}

}  // namespace

SurfaceFit fit_surface(const SurfaceStream& stream, const FitSurfaceOptions& options,
                       const Progress& progress) {
    StoredGrid grid(stream, options.sigma, progress);
    const auto fit = [&] {
        SurfaceFit made = fit_stored(stream, grid, options);
        progress.at(1, 1);
        return made;
    };
    try {
        return fit();
    } catch (const HolesFound&) {
        grid.count_holes();
        return fit();
    }
}

}  // namespace batten
