#include "make/fit_surface/front_path.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::surface_fitting {
namespace {

/// Nearer to a known front than this share of the domain, and than this many cells, its own slope
/// is what one sees.
constexpr double hidden_share = 0.05;
constexpr double hidden_cells = 5;

double hidden_beside(const Nodes& nodes) {
    const double width = nodes.x.back() - nodes.x.front();
    return std::max(hidden_share * width,
                    hidden_cells * width / static_cast<double>(nodes.x.size() - 1));
}

}  // namespace

std::vector<double> steepest_path(const Nodes& nodes,
                                  const std::vector<std::vector<double>>& known) {
    const std::size_t m = nodes.x.size(), n = nodes.y.size();
    const Interval domain{nodes.x.front(), nodes.x.back()};
    const double height = nodes.y.back() - nodes.y.front();
    constexpr double free_slope = 2.5;  // domain widths a height, not charged
    Eigen::MatrixXd steep = Eigen::MatrixXd::Zero(static_cast<int>(n), static_cast<int>(m));
    for (std::size_t s = 0; s < n; ++s) {
        for (std::size_t r = 2; r + 2 < m; ++r) {
            const auto z = [&](std::size_t i) { return nodes.z[i * n + s]; };
            steep(static_cast<int>(s), static_cast<int>(r)) =
                std::fabs(2 * (z(r + 2) - z(r - 2)) + z(r + 1) - z(r - 1)) /
                (nodes.x[r + 2] - nodes.x[r - 2]);
        }
    }
    for (const std::vector<double>& front : known) {
        for (std::size_t s = 0; s < n; ++s) {
            for (std::size_t r = 0; r < m; ++r) {
                if (std::fabs(nodes.x[r] - front[s]) > hidden_beside(nodes)) continue;
                steep(static_cast<int>(s), static_cast<int>(r)) = 0;
            }
        }
    }
    const double charge = steep.maxCoeff();
    Eigen::MatrixXd best = steep;
    std::vector<std::size_t> from(n * m, 0);
    for (std::size_t s = 1; s < n; ++s) {
        const double reach =
            free_slope * (nodes.y[s] - nodes.y[s - 1]) / height * domain.length();
        for (std::size_t r = 0; r < m; ++r) {
            double most = -std::numeric_limits<double>::infinity();
            for (std::size_t q = 0; q < m; ++q) {
                const double step = std::fabs(nodes.x[r] - nodes.x[q]);
                const double beyond = std::max(0.0, step - reach) / reach;
                const double value = best(static_cast<int>(s) - 1, static_cast<int>(q)) -
                                     charge * beyond * beyond - 1e-3 * charge * step / reach;
                if (value <= most) continue;
                most = value;
                from[s * m + r] = q;
            }
            best(static_cast<int>(s), static_cast<int>(r)) += most;
        }
    }
    int last = 0;
    best.row(static_cast<int>(n) - 1).maxCoeff(&last);
    std::vector<double> path(n);
    std::size_t at = static_cast<std::size_t>(last);
    for (std::size_t s = n; s-- > 0;) {
        // The centre of the steepness around the place is finer than a cell.
        double sum = 0, moment = 0;
        for (std::size_t r = at >= 3 ? at - 3 : 0; r <= std::min(m - 1, at + 3); ++r) {
            const double value = steep(static_cast<int>(s), static_cast<int>(r));
            sum += value * value;
            moment += value * value * nodes.x[r];
        }
        path[s] = sum > 0 ? moment / sum : nodes.x[at];
        at = from[s * m + at];
    }
    return path;
}

}  // namespace batten::surface_fitting
