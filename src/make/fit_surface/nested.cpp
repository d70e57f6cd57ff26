#include "make/fit_surface/nested.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit_surface/residual_totals.hpp"
#include "num/clones.hpp"
#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

/// What must be left of a function when those before it are taken off: else rounding shows.
constexpr double distinct_enough = 1e-7;
/// Functions in a direction; more only cost the time to copy them.
constexpr std::size_t expected = 24;

/// Rows less factors[i] times `line` each; sq becomes the sums of their squares.
BATTEN_CLONES void take_off_line(std::span<const double> line, std::span<const double> factors,
                                 std::vector<double>& rows, std::vector<double>& sq) {
    const std::size_t count = line.size();
    double* __restrict const sums = sq.data();
    std::fill(sq.begin(), sq.end(), 0.0);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        double* __restrict const row = rows.data() + i * count;
        const double factor = factors[i];
        const double* const from = line.data();
        for (std::size_t s = 0; s < count; ++s) {
            const double e = row[s] - factor * from[s];
            row[s] = e;
            sums[s] += e * e;
        }
    }
}

/// matrix less the product of a column and a row.
BATTEN_CLONES void take_off_product(std::span<const double> column, std::span<const double> row,
                                    double* __restrict matrix) {
    const std::size_t count = row.size();
    const double* const from = row.data();
    for (std::size_t r = 0; r < column.size(); ++r) {
        double* __restrict const to = matrix + r * count;
        const double factor = column[r];
        for (std::size_t s = 0; s < count; ++s) to[s] -= factor * from[s];
    }
}

}  // namespace

Nested::Nested(const SearchSpace& space, int degree, StripRule rule)
    : space_(space), degree_(degree), rule_(rule), residuals_(space.heights()) {
    for (const Way way : {Way::x, Way::y}) {
        const std::span<const double> lines = space.lines(way);
        side(way).breaks = {lines.front(), lines.back()};
        side(way).rest_sq.assign(lines.size(), 0.0);
        side(way).coordinates.reserve(expected * space.size(way));
        side(way).rest.reserve(expected * lines.size());
    }
}

std::unique_ptr<Nested> Nested::over(const SearchSpace& space, int degree, StripRule rule) {
    std::unique_ptr<Nested> made(new Nested(space, degree, rule));
    for (const Way way : {Way::x, Way::y}) {
        const BSplineBasis basis = basis_over(made->side(way).breaks, degree);
        for (std::size_t i = 0; i < basis.size(); ++i) {
            if (!made->add_function(way, basis, i)) return nullptr;
        }
    }
    return made;
}

bool Nested::go_to(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks) {
    for (const Way way : {Way::x, Way::y}) {
        const std::vector<double>& wanted = way == Way::x ? x_breaks : y_breaks;
        const std::vector<double>& present = side(way).breaks;
        if (!std::includes(wanted.begin(), wanted.end(), present.begin(), present.end())) {
            return false;
        }
        std::vector<double> more;
        std::set_difference(wanted.begin(), wanted.end(), present.begin(), present.end(),
                            std::back_inserter(more));
        for (const double t : more) {
            if (!space_.has_break(way, t) || !add_break(way, t)) return false;
        }
    }
    return true;
}

bool Nested::add_break(Way way, double t) {
    std::vector<double>& breaks = side(way).breaks;
    const auto place = std::upper_bound(breaks.begin(), breaks.end(), t);
    const std::size_t knot = static_cast<std::size_t>(place - breaks.begin() + degree_);
    breaks.insert(place, t);
    // Of the splines with this knot the one around it.
    const std::size_t half = (static_cast<std::size_t>(degree_) + 1) / 2;
    return add_function(way, basis_over(breaks, degree_), knot - half);
}

bool Nested::add_function(Way way, const BSplineBasis& basis, std::size_t function) {
    const std::optional<std::vector<double>> fresh =
        made_orthonormal(way, space_.coordinates(way, basis, function));
    if (!fresh) return false;
    take_off(way, *fresh);
    Side& here = side(way);
    here.coordinates.insert(here.coordinates.end(), fresh->begin(), fresh->end());
    ++here.functions;
    return true;
}

std::optional<std::vector<double>> Nested::made_orthonormal(Way way,
                                                            std::vector<double> function) const {
    const Side& here = side(way);
    const double whole = num::sum_of_squares(function);
    for (int round = 0; round < 2; ++round) {
        std::vector<double> shares(here.functions, 0.0);
        num::add_dots(here.coordinates, function, shares);
        for (double& share : shares) share = -share;
        num::add_combination(shares, here.coordinates, function);
        const double rest = num::sum_of_squares(function);
        if (!(rest > distinct_enough * distinct_enough * whole)) return std::nullopt;
    }
    const double scale = 1 / std::sqrt(num::sum_of_squares(function));
    for (double& value : function) value *= scale;
    return function;
}

void Nested::take_off(Way way, std::span<const double> function) {
    Side& here = side(way);
    Side& there = side(across(way));
    const SearchSpace::Image image = space_.image(way, function);
    std::vector<double> shares(there.functions, 0.0);
    num::add_dots(there.coordinates, image.coordinates, shares);

    std::vector<double> fitted(image.coordinates.size(), 0.0);
    num::add_combination(shares, there.coordinates, fitted);
    if (way == Way::x) take_off_product(function, fitted, residuals_.data());
    else take_off_product(fitted, function, residuals_.data());

    take_off_line(space_.at_lines(way, function), shares, here.rest, here.rest_sq);
    there.rest.insert(there.rest.end(), image.lines.begin(), image.lines.end());
    const std::span<double> fresh =
        std::span(there.rest).last(image.lines.size());
    num::add_times(-1, space_.at_lines(across(way), fitted), fresh);
    for (std::size_t s = 0; s < fresh.size(); ++s) there.rest_sq[s] += fresh[s] * fresh[s];
}

std::vector<double> Nested::marginal_sums_sq(Way way) const {
    const std::size_t m = space_.size(Way::x), n = space_.size(Way::y);
    std::vector<double> sums(way == Way::x ? m : n, 0.0);
    if (way == Way::x) {
        num::add_dots(residuals_, std::vector<double>(n, 1.0), sums);
    } else {
        num::add_combination(std::vector<double>(m, 1.0), residuals_, sums);
    }
    for (double& sum : sums) sum *= sum;
    return sums;
}

std::vector<double> Nested::strips(Way way) const {
    const bool is_projected = rule_ == StripRule::projected;
    const std::vector<double> sums = is_projected ? side(way).rest_sq : marginal_sums_sq(way);
    const std::size_t share = is_projected ? side(across(way)).functions : space_.size(across(way));
    const std::vector<double>& breaks = side(way).breaks;
    const std::span<const double> lines = space_.lines(way);
    std::vector<double> result(breaks.size() - 1, 0.0);
    std::size_t strip = 0;
    for (std::size_t r = 0; r < lines.size(); ++r) {
        while (strip + 2 < breaks.size() && lines[r] >= breaks[strip + 1]) ++strip;
        result[strip] += sums[r];
    }
    for (double& measure : result) measure /= static_cast<double>(share);
    return result;
}

Misfit Nested::misfit() {
    Misfit result;
    if (space_.is_of_nodes()) {
        ResidualTotals totals;
        totals.add(residuals_);
        totals.finish(result, residuals_.size());
    } else {
        result.psi_is_missing = true;
        result.delta2 = space_.least_delta2() + num::sum_of_squares(residuals_);
    }
    result.x_strips = strips(Way::x);
    result.y_strips = strips(Way::y);
    return result;
}

}  // namespace batten::surface_fitting
