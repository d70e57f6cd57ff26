#include "num/nonnegative.hpp"

#include <algorithm>
#include <cmath>

#include "num/householder.hpp"

namespace batten::num {
namespace {

constexpr double gradient_at_rest = 1e-12;  // relative to |column| |residual| and |right|

/// Least squares over some of the columns.
std::vector<double> solve_columns(const DenseMatrix& matrix, std::span<const double> right,
                                  const std::vector<std::size_t>& columns) {
    const std::size_t q = columns.size(), width = q + 1;
    std::vector<double> triangle(q * width, 0.0), rows(matrix.rows * width);
    for (std::size_t i = 0; i < matrix.rows; ++i) {
        for (std::size_t j = 0; j < q; ++j) rows[i * width + j] = matrix(i, columns[j]);
        rows[i * width + q] = right[i];
    }
    absorb({triangle.data(), width, static_cast<int>(q), static_cast<int>(width)},
           {rows.data(), static_cast<int>(matrix.rows), width});
    std::vector<double> x(q, 0.0);
    for (std::size_t i = q; i-- > 0;) {
        double sum = triangle[i * width + q];
        for (std::size_t j = i + 1; j < q; ++j) sum -= triangle[i * width + j] * x[j];
        const double pivot = triangle[i * width + i];
        x[i] = pivot == 0 ? 0 : sum / pivot;
    }
    return x;
}

std::vector<double> residual_of(const DenseMatrix& matrix, std::span<const double> right,
                                const std::vector<double>& x) {
    std::vector<double> r(right.begin(), right.end());
    for (std::size_t i = 0; i < matrix.rows; ++i) {
        for (std::size_t j = 0; j < matrix.columns; ++j) r[i] -= matrix(i, j) * x[j];
    }
    return r;
}

double norm(std::span<const double> v) {
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

/// The column outside `passive` whose growth lowers the residual most; `columns` if none does.
std::size_t steepest(const DenseMatrix& matrix, std::span<const double> residual,
                     const std::vector<char>& is_passive, double rest) {
    std::size_t best = matrix.columns;
    double most = 0;
    for (std::size_t j = 0; j < matrix.columns; ++j) {
        if (is_passive[j]) continue;
        double slope = 0, length_sq = 0;
        for (std::size_t i = 0; i < matrix.rows; ++i) {
            slope += matrix(i, j) * residual[i];
            length_sq += matrix(i, j) * matrix(i, j);
        }
        if (slope > gradient_at_rest * rest * std::sqrt(length_sq) && slope > most) {
            most = slope;
            best = j;
        }
    }
    return best;
}

/// How far towards the solution the unknowns can go, and the first to meet 0 (or none).
struct Advance {
    double share = 1;
    std::size_t leaves = 0;
};

Advance advance_towards(const std::vector<double>& goal, const std::vector<std::size_t>& columns,
                        std::vector<double>& x) {
    Advance advance{1, columns.size()};
    for (std::size_t j = 0; j < columns.size(); ++j) {
        if (goal[j] > 0) continue;
        const double here = x[columns[j]], share = here > 0 ? here / (here - goal[j]) : 0;
        if (advance.leaves < columns.size() && share >= advance.share) continue;
        advance = {share, j};
    }
    const bool is_whole = advance.leaves == columns.size();
    for (std::size_t j = 0; j < columns.size(); ++j) {
        double& here = x[columns[j]];
        here = is_whole ? goal[j] : std::max(here + advance.share * (goal[j] - here), 0.0);
    }
    return advance;
}

std::vector<std::size_t> listed(const std::vector<char>& is_passive) {
    std::vector<std::size_t> columns;
    for (std::size_t j = 0; j < is_passive.size(); ++j) {
        if (is_passive[j]) columns.push_back(j);
    }
    return columns;
}

/// The shortest u that fulfils some rows, of length 1, with equality; nothing where rows depend on
/// each other. `dual` holds the rows as columns.
std::optional<std::vector<double>> shortest_on(const DenseMatrix& dual,
                                               std::span<const double> heights,
                                               const std::vector<std::size_t>& active) {
    constexpr double least_pivot = 1e-12;
    const std::size_t a = active.size(), q = dual.rows - 1;
    if (a > q) return std::nullopt;
    std::vector<double> triangle(a * a, 0.0), columns(q * a);
    for (std::size_t i = 0; i < q; ++i) {
        for (std::size_t j = 0; j < a; ++j) columns[i * a + j] = dual(i, active[j]);
    }
    absorb({triangle.data(), a, static_cast<int>(a), static_cast<int>(a)},
           {columns.data(), static_cast<int>(q), a});
    for (std::size_t j = 0; j < a; ++j) {
        if (!(std::fabs(triangle[j * a + j]) > least_pivot)) return std::nullopt;
    }
    std::vector<double> u(q, 0.0), w(a);
    // u = G^T (R^T R)^-1 h; the second round takes away what rounding did in the first
    // [Bjorck1987].
    for (int round = 0; round < 2; ++round) {
        for (std::size_t j = 0; j < a; ++j) {
            w[j] = heights[active[j]];
            for (std::size_t i = 0; i < q; ++i) w[j] -= dual(i, active[j]) * u[i];
        }
        for (std::size_t j = 0; j < a; ++j) {
            for (std::size_t i = 0; i < j; ++i) w[j] -= triangle[i * a + j] * w[i];
            w[j] /= triangle[j * a + j];
        }
        for (std::size_t j = a; j-- > 0;) {
            for (std::size_t i = j + 1; i < a; ++i) w[j] -= triangle[j * a + i] * w[i];
            w[j] /= triangle[j * a + j];
        }
        for (std::size_t i = 0; i < q; ++i) {
            for (std::size_t j = 0; j < a; ++j) u[i] += dual(i, active[j]) * w[j];
        }
    }
    return u;
}

/// Whether u fulfils all rows, but for rounding.
bool fulfils(const DenseMatrix& dual, std::span<const double> heights,
             const std::vector<double>& u) {
    constexpr double tolerance = 1e-9;
    const double length = norm(u);
    for (std::size_t j = 0; j < dual.columns; ++j) {
        double rest = heights[j];
        for (std::size_t i = 0; i + 1 < dual.rows; ++i) rest -= dual(i, j) * u[i];
        if (rest > tolerance * (std::fabs(heights[j]) + length)) return false;
    }
    return true;
}

}  // namespace

std::vector<double> nonnegative_least_squares(const DenseMatrix& matrix,
                                              std::span<const double> right) {
    std::vector<double> x(matrix.columns, 0.0);
    std::vector<char> is_passive(matrix.columns, 0);
    const double whole = norm(right);
    for (std::size_t turn = 0; turn < 3 * matrix.columns + 3; ++turn) {
        const std::vector<double> r = residual_of(matrix, right, x);
        const std::size_t entering = steepest(matrix, r, is_passive, whole);
        if (entering == matrix.columns) break;
        is_passive[entering] = 1;
        for (;;) {
            const std::vector<std::size_t> columns = listed(is_passive);
            const std::vector<double> s = solve_columns(matrix, right, columns);
            const Advance advance = advance_towards(s, columns, x);
            if (advance.leaves == columns.size()) break;
            x[columns[advance.leaves]] = 0;
            for (const std::size_t j : columns) is_passive[j] = x[j] > 0 || j == entering;
            is_passive[columns[advance.leaves]] = 0;
        }
    }
    return x;
}

std::optional<LeastDistance> least_distance(const DenseMatrix& matrix,
                                            std::span<const double> right) {
    const std::size_t q = matrix.columns, m = matrix.rows;
    double scale = 0;
    std::vector<double> lengths(m), heights(m);
    for (std::size_t i = 0; i < m; ++i) {
        lengths[i] = norm({matrix.entries.data() + i * q, q});
        heights[i] = lengths[i] > 0 ? right[i] / lengths[i] : right[i];
        if (lengths[i] == 0 && right[i] > 0) return std::nullopt;
        scale = std::max(scale, std::fabs(heights[i]));
    }
    LeastDistance result{std::vector<double>(q, 0.0), {}};
    if (std::none_of(heights.begin(), heights.end(), [](double h) { return h > 0; })) return result;
    DenseMatrix dual(q + 1, m);
    for (std::size_t i = 0; i < m; ++i) {
        if (lengths[i] == 0) continue;
        for (std::size_t j = 0; j < q; ++j) dual(j, i) = matrix(i, j) / lengths[i];
        dual(q, i) = heights[i] / scale;
    }
    std::vector<double> unit(q + 1, 0.0);
    unit[q] = 1;
    const std::vector<double> w = nonnegative_least_squares(dual, unit);
    for (std::size_t i = 0; i < m; ++i) {
        if (w[i] > 0) result.active.push_back(i);
    }
    // Where rows contradict each other, nothing but rounding is left to tell u from: the rows that
    // push depend on each other then, or leave another one unfulfilled.
    std::optional<std::vector<double>> point = shortest_on(dual, heights, result.active);
    if (!point || !fulfils(dual, heights, *point)) return std::nullopt;
    result.point = *std::move(point);
    return result;
}

}  // namespace batten::num
