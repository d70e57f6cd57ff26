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
    const std::vector<double> r = residual_of(dual, unit, w);
    if (!(r[q] > 1e-14)) return std::nullopt;
    for (std::size_t j = 0; j < q; ++j) result.point[j] = -r[j] / r[q] * scale;
    for (std::size_t i = 0; i < m; ++i) {
        if (w[i] > 0) result.active.push_back(i);
    }
    return result;
}

}  // namespace batten::num
