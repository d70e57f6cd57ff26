#include "make/fit/fixed_fit.hpp"

#include <algorithm>
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "make/fit/first_look.hpp"

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

/// The triangles of all spans, and what counting needs (open splines).
struct Reduced {
    std::vector<double> triangles;
    std::vector<Cell> cells;
};

Reduced reduced(const Reducer& reducer, std::span<const double> knots, Ends ends,
                FirstLook* look) {
    const Samples& samples = reducer.samples();
    const int order = reducer.shape().order;
    const std::vector<std::size_t> spans = spans_of(knots, order);
    Reduced all;
    all.triangles.resize(spans.size() * reducer.shape().size());
    Rows rest{0, samples.size()};
    for (std::size_t i = 0; i < spans.size(); ++i) {
        const Interval span{knots[spans[i]], knots[spans[i] + 1]};
        const RightEnd end = i + 1 == spans.size() ? RightEnd::closed : RightEnd::open;
        const Rows rows = rows_in(samples, rest, span, end);
        rest.first = rows.last;
        if (look) look_at(samples, rows, *look);
        double* const out = all.triangles.data() + i * reducer.shape().size();
        reducer.reduce(rows, span, Rest::unwanted, out);
        if (ends == Ends::open) add_cells(knots, order, spans[i], samples, rows, all.cells);
    }
    return all;
}

}  // namespace

FixedFit solve_from(std::vector<double> knots, const LocalBasis& basis, const TriangleShape& shape,
                    Ends ends, std::span<const double> triangles, std::span<const Cell> cells) {
    FixedFit fit{std::move(knots), KnotSystem(basis, shape, ends), 0, 0, {}, {}, {}, 0};
    const int order = shape.order;
    const std::vector<std::size_t> spans = spans_of(fit.knots, order);
    const std::size_t block = fit.system.block_size();
    std::vector<double> blocks(spans.size() * block);
    std::vector<int> firsts(spans.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        firsts[i] = static_cast<int>(spans[i]) - order + 1;
        fit.system.make_block(fit.knots, spans[i], triangles.data() + i * shape.size(),
                              blocks.data() + i * block);
    }
    const int stored = static_cast<int>(fit.knots.size()) - order;
    fit.functions = ends == Ends::closed ? stored - (order - 1) : stored;
    if (ends == Ends::closed) {
        fit.system.solve(fit.functions, firsts, blocks);
        fit.rank = fit.functions;
        for (int j = 0; j < fit.functions; ++j) {
            if (fit.system.qr().scaled_pivot(fit.system.unknown(j)) > least_pivot) continue;
            fit.undetermined.push_back(j);
            --fit.rank;
        }
        return fit;
    }
    fit.rank = rank_of(cells, fit.functions);
    fit.undetermined = undetermined_coefficients(cells, fit.functions);
    if (fit.undetermined.empty()) {
        fit.system.solve(fit.functions, firsts, blocks);
    } else {
        fit.system.solve_smoothly(fit.functions, firsts, blocks,
                                  lightly * largest_entry(blocks, shape));
    }
    return fit;
}

FixedFit solve_fixed(const Samples& samples, std::vector<double> knots, const LocalBasis& basis,
                     Ends ends) {
    const Reducer reducer(samples, basis);
    const Reduced all = reduced(reducer, knots, ends, nullptr);
    return solve_from(std::move(knots), basis, reducer.shape(), ends, all.triangles, all.cells);
}

std::optional<FixedFit> solve_looking(const Samples& samples, std::vector<double> knots,
                                      const LocalBasis& basis, Ends ends) {
    const Reducer reducer(samples, basis);
    FirstLook look;
    const Reduced all = reduced(reducer, knots, ends, &look);
    if (!look.is_clean(samples) || !has_usable_units(samples, look, basis.order() - 1)) {
        return std::nullopt;
    }
    return solve_from(std::move(knots), basis, reducer.shape(), ends, all.triangles, all.cells);
}

SplineFunction spline_of(const FixedFit& fixed, int side) {
    const std::span<const double> c = fixed.system.coefficients(side);
    std::vector<double> values(c.begin(), c.end());
    if (!fixed.limited.empty()) values = fixed.limited;
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
