#include "make/fit_surface/solve.hpp"

#include <algorithm>
#include <cmath>

#include "make/fit_surface/masked_normals.hpp"
#include "make/fit_surface/mixed_noise.hpp"
#include "num/rows.hpp"
#include "num/tensor.hpp"

namespace batten::surface_fitting {
namespace {

/// Rows of nodes held at a time: a few hundred kilobytes for wide grids.
constexpr std::size_t rows_at_once = 16;
/// Where conjugate gradients stop, of the energy norm at their start.
constexpr double small_enough = iterated_accuracy;
/// Of the triangles' diagonals: below, seminormal equations lose 4 digits of 16 at most.
constexpr double harmless_spread = 100;

/// Both passes over the nodes that every solver needs.
class Passes {
public:
    Passes(const Nodes& nodes, const Axis& x, const Axis& y)
        : nodes_(nodes), plain_(x.plain(), y.plain()),
          normal_(x.normal(), y.normal(), num::Tensor::Use::products) {}

    std::size_t unknowns() const {
        return plain_.x().functions * plain_.y().functions;
    }
    /// A^T W (z - A c); without c A^T W z.
    std::vector<double> gradient(const std::vector<double>* c) const {
        return gathered([&](num::PlaceRange rows, std::span<double> out) {
            const std::size_t width = plain_.y().places();
            const double* const z = nodes_.z.data() + rows.first * width;
            if (!c) {
                std::copy_n(z, out.size(), out.begin());
                return;
            }
            plain_.expand(*c, rows, out);
            for (std::size_t k = 0; k < out.size(); ++k) out[k] = z[k] - out[k];
        });
    }
    /// A^T W A c.
    std::vector<double> normal_times(const std::vector<double>& c) const {
        return gathered([&](num::PlaceRange rows, std::span<double> out) {
            plain_.expand(c, rows, out);
        });
    }

private:
    template <class Fill>
    std::vector<double> gathered(Fill fill) const {
        std::vector<double> g(unknowns(), 0.0);
        const std::size_t lines = plain_.x().places(), width = plain_.y().places();
        std::vector<double> buffer(std::min(rows_at_once, lines) * width);
        for (std::size_t r = 0; r < lines; r += rows_at_once) {
            const num::PlaceRange rows{r, std::min(lines, r + rows_at_once)};
            const std::span<double> part(buffer.data(), rows.count() * width);
            fill(rows, part);
            if (!nodes_.is_full()) {
                const double* const factor = nodes_.cell_factor_sq.data() + r * width;
                for (std::size_t k = 0; k < part.size(); ++k) part[k] *= factor[k];
            }
            normal_.contract(part, rows, g);
        }
        return g;
    }

    const Nodes& nodes_;
    num::Tensor plain_, normal_;
};

/// What makes the preconditioner regular is part of the matrix, lest steps drift where lines see
/// nothing: faint differences in either direction, times a usual square sum of the other.
void add_faint_part(const Axis& x, const Axis& y, const std::vector<double>& c,
                    std::vector<double>& image) {
    const std::size_t p = x.functions(), q = y.functions();
    if (!x.is_regular()) num::add_times(y.mean_sq(), x.faint_part(c, q), image);
    if (!y.is_regular()) {
        const std::vector<double> turned = y.faint_part(num::transposed(c, p), p);
        num::add_times(x.mean_sq(), num::transposed(turned, q), image);
    }
}

Solution orthogonal_solution(const Nodes& nodes, const Axis& x, const Axis& y) {
    const std::vector<double> in_x = x.fitted(nodes.z, nodes.y.size());
    const std::vector<double> both = y.fitted(num::transposed(in_x, x.functions()), x.functions());
    return {num::transposed(both, y.functions())};
}

/// Where the matrix is smaller than the grid, steps need not see the nodes.
bool is_worth_a_matrix(const Nodes& nodes, const Axis& x, const Axis& y) {
    const std::size_t entries = static_cast<std::size_t>(x.plain().order * y.plain().order);
    return x.functions() * y.functions() * entries <= nodes.z.size();
}

Solution solve_masked(const Nodes& nodes, const Axis& x, const Axis& y) {
    if (is_worth_a_matrix(nodes, x, y)) {
        MaskedNormals normals(x, y);
        normals.add({0, nodes.z, nodes.cell_factor_sq});
        return normals.solution();
    }
    const Passes passes(nodes, x, y);
    return conjugate_gradients(
        passes.gradient(nullptr),
        [&](const std::vector<double>& c) { return passes.normal_times(c); }, x, y);
}

}  // namespace

std::vector<double> inverted(std::vector<double> g, const Axis& x, const Axis& y) {
    x.invert_rows(g, y.functions());
    y.invert_columns(g);
    return g;
}

Solution conjugate_gradients(std::vector<double> rest, const NormalMatrix& matrix, const Axis& x,
                             const Axis& y, int steps) {
    Solution result;
    std::vector<double>& c = result.coefficients;
    std::vector<double> direction = inverted(rest, x, y);
    c.assign(rest.size(), 0.0);
    double energy = num::dot(rest, direction);
    const double target = small_enough * small_enough * energy;
    const int most = steps > 0 ? steps : 100 + 10 * static_cast<int>(c.size());
    while (energy > target && result.iterations < most) {
        std::vector<double> image = matrix(direction);
        add_faint_part(x, y, direction, image);
        const double curvature = num::dot(direction, image);
        if (!(curvature > 0)) break;
        const double step = energy / curvature;
        num::add_times(step, direction, c);
        num::add_times(-step, image, rest);
        ++result.iterations;
        std::vector<double> fresh = inverted(rest, x, y);
        const double next = num::dot(rest, fresh);
        num::add_times(next / energy, direction, fresh);
        direction = std::move(fresh);
        energy = next;
    }
    result.is_converged = energy <= target;
    return result;
}

bool is_harmless(const Axis& x, const Axis& y) {
    return x.spread() * y.spread() <= harmless_spread;
}

Solution solve(const Nodes& nodes, const Axis& x, const Axis& y, Corrected corrected) {
    if (!nodes.is_full()) return solve_masked(nodes, x, y);
    if (x.is_delicate() || y.is_delicate()) return orthogonal_solution(nodes, x, y);
    std::vector<double> products(x.functions() * y.functions(), 0.0);
    num::Tensor(x.normal(), y.normal(), num::Tensor::Use::products)
        .contract(nodes.z, {0, nodes.x.size()}, products);
    Solution result{inverted(std::move(products), x, y)};
    if (corrected == Corrected::where_needed && !is_harmless(x, y)) {
        num::add_times(1, inverted(Passes(nodes, x, y).gradient(&result.coefficients), x, y),
                       result.coefficients);
    }
    return result;
}

std::vector<double> residuals(const Nodes& nodes, const Axis& x, const Axis& y,
                              const std::vector<double>& c) {
    std::vector<double> e(nodes.z.size());
    num::Tensor(x.plain(), y.plain()).expand(c, {0, nodes.x.size()}, e);
    for (std::size_t k = 0; k < e.size(); ++k) {
        const bool counts = nodes.is_full() || nodes.cell_factor_sq[k] > 0;
        e[k] = counts ? nodes.z[k] - e[k] : 0;
    }
    return e;
}

std::vector<std::array<int, 2>> open_coefficients(const Nodes& nodes, const Axis& x,
                                                  const Axis& y) {
    if (nodes.is_full() && x.open().empty() && y.open().empty()) return {};
    std::vector<double> present(x.functions() * y.functions(), 1.0);
    if (!nodes.is_full()) {
        // The columns' square sums, found like a right-hand side from the squares of the splines.
        num::TensorSide a = x.weighted(), b = y.weighted();
        for (double& value : a.values) value *= value;
        for (double& value : b.values) value *= value;
        std::fill(present.begin(), present.end(), 0.0);
        num::Tensor(a, b).contract(nodes.cell_factor_sq, {0, nodes.x.size()}, present);
    }
    return open_coefficients(present, x, y);
}

std::vector<std::array<int, 2>> open_coefficients(const std::vector<double>& present, const Axis& x,
                                                  const Axis& y) {
    std::vector<std::array<int, 2>> open;
    const double largest = *std::max_element(present.begin(), present.end());
    constexpr double nothing = 1e-20;  // a column norm of 1e-10 of the largest
    const auto is_in = [](const std::vector<int>& list, std::size_t i) {
        return std::binary_search(list.begin(), list.end(), static_cast<int>(i));
    };
    for (std::size_t i = 0; i < x.functions(); ++i) {
        for (std::size_t j = 0; j < y.functions(); ++j) {
            const bool is_empty = present[i * y.functions() + j] <= nothing * largest;
            if (is_empty || is_in(x.open(), i) || is_in(y.open(), j)) {
                open.push_back({static_cast<int>(i), static_cast<int>(j)});
            }
        }
    }
    return open;
}

}  // namespace batten::surface_fitting
