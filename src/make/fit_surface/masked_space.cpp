#include "make/fit_surface/masked_space.hpp"

#include <algorithm>

#include "make/fit_surface/residual_totals.hpp"
#include "num/rows.hpp"

namespace batten::surface_fitting {
namespace {

/// Added to the sums of columns at a time.
constexpr std::size_t rows_summed = 16;
/// Of the reference that others are measured against: it need not be the best.
constexpr int steps_to_a_good_fit = 30;

/// A function of each of the splines across, given by its coefficients, at the lines: splines
/// across slowest.
std::vector<double> at_lines(const num::TensorSide& lines, const std::vector<double>& c,
                             std::size_t across) {
    const std::size_t count = lines.places(), order = static_cast<std::size_t>(lines.order);
    std::vector<double> values(across * count);
    for (std::size_t a = 0; a < across; ++a) {
        const double* const row = c.data() + a * lines.functions;
        for (std::size_t l = 0; l < count; ++l) {
            double sum = 0;
            for (std::size_t k = 0; k < order; ++k) sum += lines.at(l)[k] * row[lines.first[l] + k];
            values[a * count + l] = sum;
        }
    }
    return values;
}

/// to[l] -= factors[l] values[l].
void take_products(const double* factors, const double* values, std::span<double> to) {
    for (std::size_t l = 0; l < to.size(); ++l) to[l] -= factors[l] * values[l];
}

double delta2_of(const Nodes& nodes, const Axis& x, const Axis& y, const std::vector<double>& c) {
    const num::Tensor tensor(x.plain(), y.plain());
    ResidualTotals totals;
    std::vector<double> heights(nodes.y.size()), weights(nodes.y.size());
    nodes.for_masked_rows([&](const MaskedRows& rows) {
        for (std::size_t at = 0; at < rows.z.size(); at += heights.size()) {
            const std::size_t r = rows.first + at / heights.size();
            tensor.expand(c, {r, r + 1}, heights);
            for (std::size_t s = 0; s < weights.size(); ++s) {
                weights[s] = nodes.y_weight[s] * rows.factor_sq[at + s];
            }
            totals.add({rows.z.data() + at, heights.data(), nodes.x_weight[r], weights.data(),
                        heights.size()},
                       heights.data());
        }
    });
    Misfit result;
    totals.finish(result, nodes.count);
    return result.delta2;
}

}  // namespace

std::unique_ptr<MaskedSpace> MaskedSpace::over(const Nodes& nodes, int degree,
                                               const std::vector<double>& x_breaks,
                                               const std::vector<double>& y_breaks) {
    const BSplineBasis x = basis_over(x_breaks, degree), y = basis_over(y_breaks, degree);
    const std::vector<double> used_x = nodes.used_x(), used_y = nodes.used_y();
    if (!is_determined(x, used_x) || !is_determined(y, used_y)) return nullptr;
    std::unique_ptr<MaskedSpace> space(new MaskedSpace(nodes, Axis(x, nodes.x, nodes.x_weight, used_x),
                                                       Axis(y, nodes.y, nodes.y_weight, used_y)));
    space->read();
    return space;
}

MaskedSpace::MaskedSpace(const Nodes& nodes, Axis x, Axis y)
    : nodes_(nodes), x_(std::move(x)), y_(std::move(y)), normals_(x_, y_) {
    const std::size_t order = static_cast<std::size_t>(x_.plain().order);
    const auto resize = [&](Lines& lines, std::size_t size) {
        lines.products.assign(size, 0.0);
        lines.gram.assign(size * order, 0.0);
    };
    resize(x_lines_, y_.functions() * nodes.x.size());
    resize(y_lines_, x_.functions() * nodes.y.size());
}

void MaskedSpace::read() {
    nodes_.for_masked_rows([&](const MaskedRows& rows) {
        normals_.add(rows, [&](std::size_t r, const MaskedRow& row) { add_row(r, row); });
        add_columns(rows);
    });
    good_ = normals_.solution(steps_to_a_good_fit).coefficients;
    good_delta2_ = delta2_of(nodes_, x_, y_, good_);
    unused_ = normals_.products();
    num::add_times(-1, normals_.times(good_), unused_);
}

void MaskedSpace::add_row(std::size_t r, const MaskedRow& row) {
    const std::size_t lines = nodes_.x.size();
    for (std::size_t k = 0; k < row.products.size(); ++k) {
        x_lines_.products[k * lines + r] = row.products[k];
    }
    for (std::size_t k = 0; k < row.gram.size(); ++k) x_lines_.gram[k * lines + r] = row.gram[k];
}

void MaskedSpace::add_columns(const MaskedRows& rows) {
    const num::TensorSide &weighted = x_.weighted(), &normal = x_.normal();
    const std::size_t lines = nodes_.y.size(), functions = x_.functions();
    const std::size_t order = static_cast<std::size_t>(normal.order);
    const std::size_t end = rows.first + rows.z.size() / lines;
    std::vector<double> factors;
    for (std::size_t r = rows.first, last = r; r < end; r = last) {
        const std::size_t first = normal.first[r];
        while (last < end && normal.first[last] == first && last - r < rows_summed) ++last;
        const auto block = [&](std::span<const double> of) {
            return of.subspan((r - rows.first) * lines, (last - r) * lines);
        };
        const auto to = [&](std::vector<double>& rest, std::size_t function) {
            return std::span(rest).subspan(function * lines, lines);
        };
        for (std::size_t i = 0; i < order; ++i) {
            factors.clear();
            for (std::size_t k = r; k < last; ++k) factors.push_back(normal.at(k)[i]);
            num::add_combination(factors, block(rows.z), to(y_lines_.products, first + i));
            for (std::size_t b = 0; i + b < order; ++b) {
                factors.clear();
                for (std::size_t k = r; k < last; ++k) {
                    factors.push_back(weighted.at(k)[i] * weighted.at(k)[i + b]);
                }
                num::add_combination(factors, block(rows.factor_sq),
                                     to(y_lines_.gram, b * functions + first + i));
            }
        }
    }
}

bool MaskedSpace::has_break(Way way, double t) const {
    const std::span<const double> breaks = fine(way).basis().breaks();
    return std::binary_search(breaks.begin(), breaks.end(), t);
}

bool MaskedSpace::has_breaks(const std::vector<double>& x_breaks,
                             const std::vector<double>& y_breaks) const {
    const auto has = [&](Way way) { return [&, way](double t) { return has_break(way, t); }; };
    return std::all_of(x_breaks.begin(), x_breaks.end(), has(Way::x)) &&
           std::all_of(y_breaks.begin(), y_breaks.end(), has(Way::y));
}

Solution MaskedSpace::solution(const Axis& x, const Axis& y) const {
    const InclusionPair coarse{{x.basis(), x_.basis()}, {y.basis(), y_.basis()}};
    return conjugate_gradients(
        coarse.reduced(normals_.products()),
        [&](const std::vector<double>& c) {
            return coarse.reduced(normals_.times(coarse.refined(c)));
        },
        x, y);
}

Misfit MaskedSpace::misfit(const Axis& x, const Axis& y, const std::vector<double>& c) const {
    const InclusionPair coarse{{x.basis(), x_.basis()}, {y.basis(), y_.basis()}};
    std::vector<double> refined = coarse.refined(c);
    Misfit result;
    result.psi_is_missing = true;
    result.x_strips = strips(Way::x, x, y, num::transposed(refined, x_.functions()));
    result.y_strips = strips(Way::y, y, x, refined);
    num::add_times(-1, good_, refined);
    result.delta2 = good_delta2_ - 2 * num::dot(refined, unused_) +
                    num::dot(refined, normals_.times(refined));
    return result;
}

std::vector<double> MaskedSpace::strips(Way way, const Axis& along, const Axis& across,
                                        const std::vector<double>& c) const {
    const Lines& own = way == Way::x ? x_lines_ : y_lines_;
    const std::span<const double> places = way == Way::x ? nodes_.x : nodes_.y;
    const std::vector<double>& weight = way == Way::x ? nodes_.x_weight : nodes_.y_weight;
    const Axis& fine_across = fine(batten::surface_fitting::across(way));
    const std::size_t functions = fine_across.functions(), lines = weight.size();
    const std::vector<double> fitted = at_lines(fine(way).plain(), c, functions);
    std::vector<double> rest = own.products;
    const std::size_t order = static_cast<std::size_t>(fine_across.plain().order);
    for (std::size_t b = 0; b < order; ++b) {
        for (std::size_t a = 0; a + b < functions; ++a) {
            const double* const gram = own.gram.data() + (b * functions + a) * lines;
            const double *const low = fitted.data() + a * lines, *const high = low + b * lines;
            take_products(gram, high, std::span(rest).subspan(a * lines, lines));
            if (b > 0) take_products(gram, low, std::span(rest).subspan((a + b) * lines, lines));
        }
    }
    std::vector<double> coarse =
        Inclusion(across.basis(), fine_across.basis()).reduced(rest, lines);
    across.forward_rows(coarse, lines);
    std::vector<double> result(along.basis().breaks().size() - 1, 0.0);
    for (std::size_t l = 0; l < lines; ++l) {
        double sum = 0;
        for (std::size_t k = l; k < coarse.size(); k += lines) sum += coarse[k] * coarse[k];
        result[strip_of(along.basis(), places[l])] +=
            weight[l] * weight[l] * sum / static_cast<double>(across.functions());
    }
    return result;
}

}  // namespace batten::surface_fitting
