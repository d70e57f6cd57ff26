#include "make/fit/fixed_fit.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/first_look.hpp"
#include "make/fit/interval_rows.hpp"

namespace batten::fitting {
namespace {

/// Weight of the differences against the data's largest column: their square is at rounding, so
/// what the data determine stays as it is.
constexpr double lightly = 1e-8;
/// Scaled pivots below are taken as rank deficiency where counting does not decide (closed).
constexpr double least_pivot = 1e-13;

double largest_entry(std::span<const double> blocks, const TriangleShape& shape) {
    double largest = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const bool is_side = static_cast<int>(i) % shape.width() >= shape.order;
        if (!is_side) largest = std::max(largest, std::fabs(blocks[i]));
    }
    return largest;
}

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

void solve_closed(FixedFit& fit, const Reduced& all) {
    fit.system.solve(fit.functions, all.firsts, all.blocks);
    fit.rank = fit.functions;
    for (int j = 0; j < fit.functions; ++j) {
        if (fit.system.qr().scaled_pivot(fit.system.unknown(j)) > least_pivot) continue;
        fit.undetermined.push_back(j);
        --fit.rank;
    }
}

void solve(FixedFit& fit, const TriangleShape& shape, const Reduced& all,
           std::span<const Cell> cells) {
    const int stored = static_cast<int>(fit.knots.size()) - shape.order;
    const bool is_closed = fit.system.ends() == Ends::closed;
    fit.functions = is_closed ? stored - (shape.order - 1) : stored;
    if (is_closed) return solve_closed(fit, all);
    fit.rank = rank_of(cells, fit.functions);
    fit.undetermined = undetermined_coefficients(cells, fit.functions);
    if (fit.undetermined.empty()) {
        fit.system.solve(fit.functions, all.firsts, all.blocks);
    } else {
        fit.system.solve_smoothly(fit.functions, all.firsts, all.blocks,
                                  lightly * largest_entry(all.blocks, shape));
    }
}

}  // namespace

FixedFit solve_from(std::vector<double> knots, const LocalBasis& basis, const TriangleShape& shape,
                    Ends ends, std::span<const double> triangles, std::span<const Cell> cells) {
    FixedFit fit = unsolved(std::move(knots), basis, shape, ends);
    Reduced all;
    for (const std::size_t span : spans_of(fit.knots, shape.order)) {
        add_block(fit, span, triangles.data() + all.firsts.size() * shape.size(), all);
    }
    solve(fit, shape, all, cells);
    return fit;
}

FixedFit solve_fixed(const Samples& samples, std::vector<double> knots, const LocalBasis& basis,
                     Ends ends) {
    const Reducer reducer(samples, basis);
    FixedFit fit = unsolved(std::move(knots), basis, reducer.shape(), ends);
    const Reduced all = reduced(reducer, fit, nullptr);
    solve(fit, reducer.shape(), all, all.cells);
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
    solve(fit, reducer.shape(), all, all.cells);
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
