#include "make/fit/fixed_fit.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/first_look.hpp"
#include "make/fit/interval_rows.hpp"
#include "make/fit/ring_rank.hpp"

namespace batten::fitting {
namespace {

/// A pivot of a closed spline's triangle above this share of the largest column is none of rounding;
/// below, the abscissae decide.
constexpr double safe_pivot = 1e-5;

/// The rows of all spans, ready to be solved, and what counting needs (open splines).
struct Reduced {
    std::vector<double> blocks;
    std::vector<int> firsts;
    std::vector<Cell> cells;
};

FixedFit unsolved(std::vector<double> knots, const LocalBasis& basis, const TriangleShape& shape,
                  Ends ends) {
    return {std::move(knots), KnotSystem(basis, shape, ends), 0, 0, {}, {}, {}, 0};
}

void add_block(const FixedFit& fit, std::size_t span, const double* triangle, Reduced& all) {
    const std::size_t size = fit.system.block_size(), at = all.blocks.size();
    all.blocks.resize(at + size);
    all.firsts.push_back(static_cast<int>(span) - fit.system.order() + 1);
    fit.system.make_block(fit.knots, span, triangle, all.blocks.data() + at);
}

Reduced reduced(const Reducer& reducer, const FixedFit& fit, FirstLook* look) {
    const Samples& samples = reducer.samples();
    const int order = reducer.shape().order;
    const std::vector<std::size_t> spans = spans_of(fit.knots, order);
    Reduced all;
    all.blocks.reserve(spans.size() * fit.system.block_size());
    all.firsts.reserve(spans.size());
    std::vector<double> triangle(reducer.shape().size());
    Rows rest{0, samples.size()};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Interval span{fit.knots[spans[i]], fit.knots[spans[i] + 1]};
        const RightEnd end = i + 1 == spans.size() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples, rest, span, end);
        rest.first = rows.last;
        if (look) look_at(samples, rows, *look);
        reducer.reduce(rows, span, Rest::unwanted, triangle.data());
        add_block(fit, spans[i], triangle.data(), all);
        if (fit.system.ends() == Ends::open) {
            add_cells(fit.knots, order, spans[i], samples, rows, all.cells);
        }
    }
    return all;
}

bool has_safe_pivots(const FixedFit& fit) {
    const num::BandedQr& qr = fit.system.qr();
    double largest_sq = 0;
    for (int j = 0; j < fit.functions; ++j) largest_sq = std::max(largest_sq, qr.column_sq(j));
    const double least = safe_pivot * std::sqrt(largest_sq);
    for (int j = 0; j < fit.functions; ++j) {
        if (!(qr.scaled_pivot(j) * std::sqrt(qr.column_sq(j)) > least)) return false;
    }
    return true;
}

/// `samples`: of splines that close; the cells tell of others.
void solve(FixedFit& fit, const LocalBasis& basis, const Reduced& all,
           std::span<const Cell> cells, const Samples* samples) {
    const int order = basis.order();
    const int stored = static_cast<int>(fit.knots.size()) - order;
    const bool is_closed = fit.system.ends() == Ends::closed;
    fit.functions = fit.rank = is_closed ? stored - (order - 1) : stored;
    std::vector<char> is_dependent;
    if (is_closed) {
        fit.system.solve(fit.functions, all.firsts, all.blocks);
        if (has_safe_pivots(fit)) return;
        RingRank ring = ring_rank(fit.knots, basis, *samples);
        fit.rank = ring.rank;
        fit.undetermined = std::move(ring.undetermined);
        is_dependent = std::move(ring.is_dependent);
        if (fit.rank == fit.functions) return;
    } else {
        fit.rank = rank_of(cells, fit.functions);
        if (fit.rank == fit.functions) {
            return fit.system.solve(fit.functions, all.firsts, all.blocks);
        }
        fit.undetermined = undetermined_coefficients(cells, fit.functions);
        is_dependent = dependent_functions(cells, fit.functions);
    }
    fit.system.solve_smoothly(fit.functions, all.firsts, all.blocks, is_dependent);
}

}  // namespace

FixedFit solve_from(std::vector<double> knots, const LocalBasis& basis, const TriangleShape& shape,
                    Ends ends, std::span<const double> triangles, std::span<const Cell> cells) {
    FixedFit fit = unsolved(std::move(knots), basis, shape, ends);
    Reduced all;
    for (const std::size_t span : spans_of(fit.knots, shape.order)) {
        add_block(fit, span, triangles.data() + all.firsts.size() * shape.size(), all);
    }
    solve(fit, basis, all, cells, nullptr);
    return fit;
}

FixedFit solve_fixed(const Samples& samples, std::vector<double> knots, const LocalBasis& basis,
                     Ends ends) {
    const Reducer reducer(samples, basis);
    FixedFit fit = unsolved(std::move(knots), basis, reducer.shape(), ends);
    const Reduced all = reduced(reducer, fit, nullptr);
    solve(fit, basis, all, all.cells, &samples);
    return fit;
}

std::optional<FixedFit> solve_looking(const Samples& samples, std::vector<double> knots,
                                      const LocalBasis& basis, Ends ends) {
    const Reducer reducer(samples, basis);
    FixedFit fit = unsolved(std::move(knots), basis, reducer.shape(), ends);
    FirstLook look;
    const Reduced all = reduced(reducer, fit, &look);
    if (!look.is_clean(samples) || !has_usable_units(samples, look, basis.order() - 1)) {
        return std::nullopt;
    }
    solve(fit, basis, all, all.cells, &samples);
    return fit;
}

SplineFunction spline_of(const FixedFit& fixed, int side) {
    const std::span<const double> c = fixed.system.coefficients(side);
    std::vector<double> values(c.begin(), c.end());
    if (!fixed.limited.empty()) values = fixed.limited[static_cast<std::size_t>(side)];
    for (std::size_t j = 0; j < values.size(); ++j) {
        if (std::isfinite(values[j])) continue;
        throw Error("number.overflow", "coefficient " + std::to_string(j),
                    format_number(values[j]), "is beyond the range of a double");
    }
    const int degree = fixed.system.order() - 1;
    return fixed.system.ends() == Ends::closed
               ? SplineFunction::periodic(fixed.knots, std::move(values), degree)
               : SplineFunction(fixed.knots, std::move(values), degree);
}

}  // namespace batten::fitting
