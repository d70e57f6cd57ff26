#include "batten/make/thin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/densify/thinning.hpp"

namespace batten {
namespace {

using namespace lagrange;

void require_finite_error(double error, const std::string& place) {
    if (std::isfinite(error)) return;
    throw Error("number.overflow", place, "beyond a double",
                "scale the points down or spread them out");
}

/// Runs of cells whose curve still moves by more than the tolerance with the next higher degree.
std::vector<ShortageRecord> shortages(const Thinning& thinning) {
    std::vector<ShortageRecord> runs;
    const std::vector<double> errors = thinning.own_errors();
    const double order = thinning.degree() + 1;
    for (std::size_t cell = 0; cell < errors.size(); ++cell) {
        if (errors[cell] <= thinning.tolerance()) continue;
        if (runs.empty() || runs.back().to != cell) runs.push_back({cell, cell, 0, 1});
        ShortageRecord& run = runs.back();
        run.to = cell + 1;
        run.error = std::max(run.error, errors[cell]);
        require_finite_error(run.error, "cell " + std::to_string(cell));
        run.times = std::ceil(std::pow(run.error / thinning.tolerance(), 1 / order));
    }
    return runs;
}

}  // namespace

Thinned thin(PointsView points, const ThinOptions& options) {
    if (!(options.tolerance.value > 0 && std::isfinite(options.tolerance.value))) {
        throw Error("option.range", "tolerance", format_number(options.tolerance.value),
                    "must be above 0 and finite");
    }
    const Thinning thinning(points, options);
    std::vector<std::size_t> kept = thinning.found(Care::quick);
    double error = thinning.error(kept);
    if (error > thinning.tolerance()) {
        kept = thinning.found(Care::full);
        error = thinning.error(kept);
    }
    require_finite_error(error, "max_error");
    Thinned result{thinning.rows(kept), std::move(kept), {}};
    result.report.points_in = points.size();
    result.report.points_out = result.points.size();
    result.report.max_error = error;
    result.report.shorter_cells = shortages(thinning);
    if (!result.report.shorter_cells.empty()) {
        result.report.notes.push_back("curvature wants shorter cells than were given in " +
                                      std::to_string(result.report.shorter_cells.size()) +
                                      " places");
    }
    if (thinning.points().size() < points.size()) {
        result.report.notes.push_back("the last point repeats the first and was left out");
    }
    return result;
}

}  // namespace batten
