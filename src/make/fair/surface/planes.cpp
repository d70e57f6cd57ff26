#include "make/fair/surface/planes.hpp"

#include <cmath>

namespace batten::fairing {
namespace {

double apart(const space::Vector& a, const space::Vector& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

Planes planes_of(const GridView& grid, double unit) {
    Planes planes;
    const auto rows = static_cast<Eigen::Index>(grid.nu());
    const auto columns = static_cast<Eigen::Index>(grid.nv());
    for (Plane& plane : planes.at) plane.resize(rows, columns);
    for (std::size_t i = 0; i < grid.nu(); ++i) {
        for (std::size_t j = 0; j < grid.nv(); ++j) {
            planes.set(i, j, {(grid(i, j, 0) - grid(0, 0, 0)) / unit,
                              (grid(i, j, 1) - grid(0, 0, 1)) / unit,
                              (grid(i, j, 2) - grid(0, 0, 2)) / unit});
        }
    }
    return planes;
}

Knots knots_of(const Planes& p) {
    Knots knots{{0}, {0}};
    for (std::size_t i = 1; i < p.nu(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < p.nv(); ++j) sum += apart(p(i, j), p(i - 1, j));
        knots.u.push_back(knots.u.back() + sum / static_cast<double>(p.nv()));
    }
    for (std::size_t j = 1; j < p.nv(); ++j) {
        double sum = 0;
        for (std::size_t i = 0; i < p.nu(); ++i) sum += apart(p(i, j), p(i, j - 1));
        knots.v.push_back(knots.v.back() + sum / static_cast<double>(p.nu()));
    }
    return knots;
}

Differences differences(double before, double after) {
    const double both = before + after;
    return {{-after / (before * both), (after - before) / (before * after), before / (after * both)},
            {2 / (before * both), -2 / (before * after), 2 / (after * both)}};
}

std::vector<Differences> differences_of(const std::vector<double>& knots) {
    std::vector<Differences> result(knots.size());
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
        result[i] = differences(knots[i] - knots[i - 1], knots[i + 1] - knots[i]);
    }
    return result;
}

}  // namespace batten::fairing
