#include "elastica.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "batten/measure/length.hpp"

namespace batten::papers {
namespace {

using Row = std::vector<double>;

/// Gaussian elimination with pivots; the right-hand side is the last column.
std::vector<double> solved(std::vector<Row> m) {
    const std::size_t n = m.size();
    for (std::size_t k = 0; k < n; ++k) {
        const auto by_size = [&](const Row& a, const Row& b) {
            return std::fabs(a[k]) < std::fabs(b[k]);
        };
        const auto here = m.begin() + static_cast<std::ptrdiff_t>(k);
        std::iter_swap(here, std::max_element(here, m.end(), by_size));
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; factor != 0 && j <= n; ++j) m[i][j] -= factor * m[k][j];
        }
    }
    std::vector<double> x(n);
    for (std::size_t i = n; i-- > 0;) {
        x[i] = m[i][n];
        for (std::size_t j = i + 1; j < n; ++j) x[i] -= m[i][j] * x[j];
        x[i] /= m[i][i];
    }
    return x;
}

/// Directions of equal steps between two that are held, and the pull of the far end.
struct Chain {
    std::vector<double> angle;
    double pull_x = 0, pull_y = 0;
};

/// The Newton system of sum (turn)^2 / 2 + pull . (steps - reach), steps of length 1.
std::vector<Row> newton_rows(const Chain& c, double reach_x, double reach_y) {
    const std::size_t free = c.angle.size() - 2;
    std::vector<Row> rows(free + 2, Row(free + 3, 0.0));
    double x = -reach_x, y = -reach_y;
    for (const double a : c.angle) x += std::cos(a), y += std::sin(a);
    for (std::size_t i = 0; i < free; ++i) {
        const double a = c.angle[i + 1];
        const double sine = std::sin(a), cosine = std::cos(a);
        rows[i][i] = 2 - c.pull_x * cosine - c.pull_y * sine;
        if (i > 0) rows[i][i - 1] = -1;
        if (i + 1 < free) rows[i][i + 1] = -1;
        rows[i][free] = rows[free][i] = -sine;
        rows[i][free + 1] = rows[free + 1][i] = cosine;
        rows[i][free + 2] = -(2 * a - c.angle[i] - c.angle[i + 2] - c.pull_x * sine +
                              c.pull_y * cosine);
    }
    rows[free][free + 2] = -x;
    rows[free + 1][free + 2] = -y;
    return rows;
}

}  // namespace

Points elastica(const Curve& curve, std::size_t count) {
    const Interval domain = curve.domain();
    const double step = length(curve).value / static_cast<double>(count - 1);
    Chain chain;
    double before = 0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count - 2);
        const Jet jet = curve.jet(domain.lo + domain.length() * share, 1);
        double angle = std::atan2(jet[1][1], jet[1][0]);
        if (i > 0) angle = before + std::remainder(angle - before, 2 * 3.141592653589793);
        chain.angle.push_back(before = angle);
    }
    const auto start = curve(domain.lo), end = curve(domain.hi);
    constexpr int most_steps = 100;
    constexpr double longest_turn = 0.2;
    for (int k = 0; k < most_steps; ++k) {
        const std::vector<double> by = solved(
            newton_rows(chain, (end[0] - start[0]) / step, (end[1] - start[1]) / step));
        double most = 0;
        for (std::size_t i = 0; i + 2 < by.size(); ++i) most = std::fmax(most, std::fabs(by[i]));
        const double share = std::fmin(1, longest_turn / most);
        for (std::size_t i = 0; i + 2 < by.size(); ++i) chain.angle[i + 1] += share * by[i];
        chain.pull_x += share * by[by.size() - 2];
        chain.pull_y += share * by[by.size() - 1];
        if (most < 1e-12) break;
    }
    Points points(0, 2);
    std::vector<double> at = start;
    points.push_back(at);
    for (const double a : chain.angle) {
        at[0] += step * std::cos(a);
        at[1] += step * std::sin(a);
        points.push_back(at);
    }
    return points;
}

}  // namespace batten::papers
