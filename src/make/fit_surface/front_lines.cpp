#include "make/fit_surface/front_lines.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "shape/surface/sides.hpp"

namespace batten::surface_fitting {
namespace {

constexpr std::size_t phi_order = 4;
constexpr double least_room = 1e-9;  // of the domain, between lines and to the border

double logistic(double u) { return 1 / (1 + std::exp(-u)); }

BSplineBasis phi_basis(const FrontShape& shape) {
    return BSplineBasis::over(
        even_places(shape.domain.y, static_cast<std::size_t>(shape.front_intervals) + 1), 3);
}

/// Offsets of a bundle's lines from phi.
std::vector<double> offsets_of(const FrontShape& shape, const std::vector<double>& theta,
                               int front) {
    std::vector<double> offsets(static_cast<std::size_t>(shape.bundle), 0.0);
    const std::size_t first = shape.gaps_at(front);
    for (std::size_t i = 1; i < offsets.size(); ++i) {
        offsets[i] = offsets[i - 1] + std::exp(theta[first + i - 1]);
    }
    const double half = 0.5 * offsets.back();
    for (double& offset : offsets) offset -= half;
    return offsets;
}

/// Given lines: in order, or on top of each other.
LinesAt standing_lines(const FrontShape& shape, double y) {
    LinesAt at;
    const Interval x = shape.domain.x;
    const double room = least_room * x.length();
    double before = x.lo + room;
    for (const SplineFunction& line : shape.given) {
        at.x.push_back(line(y));
        at.is_inside = at.is_inside && before <= at.x.back() && at.x.back() <= x.hi - room;
        before = at.x.back();
    }
    return at;
}

/// The lines of one bundle, and their derivatives.
void fill_bundle(LinesAt& at, const FrontShape& shape, const std::vector<double>& theta, int front,
                 double y) {
    const BSplineBasis basis = phi_basis(shape);
    double values[phi_order];
    basis.nonzero(y, 0, values);
    const std::size_t first = shape.phi_at(front) + basis.span_of(y) + 1 - phi_order;
    const std::size_t n = theta.size(), bundle = static_cast<std::size_t>(shape.bundle);
    const std::size_t line = shape.line_at(front);
    const std::size_t gaps = shape.gaps_at(front);
    const std::vector<double> offsets = offsets_of(shape, theta, front);
    double phi = 0;
    for (std::size_t j = 0; j < phi_order; ++j) phi += values[j] * theta[first + j];
    for (std::size_t i = 0; i < bundle; ++i) {
        double* const slope = at.slopes.data() + (line + i) * n;
        at.x[line + i] = phi + offsets[i];
        for (std::size_t j = 0; j < phi_order; ++j) slope[first + j] = values[j];
        for (std::size_t g = 0; g + 1 < bundle; ++g) {
            slope[gaps + g] = std::exp(theta[gaps + g]) * ((g < i ? 1 : 0) - 0.5);
        }
    }
}

/// The lines beside the bundles, each at its share of the way between its neighbours.
void fill_sides(LinesAt& at, const FrontShape& shape, const std::vector<double>& theta) {
    if (shape.beside == 0) return;
    const std::size_t n = theta.size(), step = static_cast<std::size_t>(shape.bundle) + 1;
    const std::size_t last = at.x.size() - 1;
    for (std::size_t line = 0, k = shape.sides_at(); line <= last; line += step, ++k) {
        const double share = logistic(theta[k]);
        const double lo = line > 0 ? at.x[line - 1] : shape.domain.x.lo;
        const double hi = line < last ? at.x[line + 1] : shape.domain.x.hi;
        at.x[line] = lo + share * (hi - lo);
        double* const slope = at.slopes.data() + line * n;
        for (std::size_t p = 0; p < n; ++p) {
            const double by_lo = line > 0 ? at.slopes[(line - 1) * n + p] : 0;
            const double by_hi = line < last ? at.slopes[(line + 1) * n + p] : 0;
            slope[p] = (1 - share) * by_lo + share * by_hi;
        }
        slope[k] = share * (1 - share) * (hi - lo);
    }
}

bool is_in_order(const LinesAt& at, const FrontShape& shape) {
    const Interval x = shape.domain.x;
    const double room = least_room * x.length();
    const std::size_t step = static_cast<std::size_t>(shape.bundle + shape.beside);
    double before = x.lo;
    for (std::size_t i = 0; i < at.x.size(); ++i) {
        // Only the lines of a bundle may touch.
        const bool is_beside = i % step <= static_cast<std::size_t>(shape.beside);
        if (!(at.x[i] >= before + (is_beside ? room : 0))) return false;
        before = at.x[i];
    }
    return before <= x.hi - room;
}

std::vector<double> phi_through(const FrontShape& shape, const Nodes& nodes,
                                const std::vector<double>& path) {
    const BSplineBasis basis = phi_basis(shape);
    const num::TensorSide side = surfaces::side_of(basis, nodes.y);
    const Eigen::Index rows = static_cast<Eigen::Index>(nodes.y.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(basis.size()));
    Eigen::VectorXd b(rows);
    for (Eigen::Index s = 0; s < rows; ++s) {
        const std::size_t at = static_cast<std::size_t>(s);
        for (std::size_t j = 0; j < phi_order; ++j) {
            a(s, static_cast<Eigen::Index>(side.first[at] + j)) = side.at(at)[j];
        }
        b[s] = path[at];
    }
    Eigen::MatrixXd normal = a.transpose() * a;
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::VectorXd phi = normal.ldlt().solve(a.transpose() * b);
    return {phi.data(), phi.data() + phi.size()};
}

}  // namespace

LinesAt lines_at(const FrontShape& shape, const std::vector<double>& theta, double y) {
    if (!shape.given.empty()) return standing_lines(shape, y);
    const std::size_t lines = static_cast<std::size_t>(shape.lines());
    LinesAt at{std::vector<double>(lines), std::vector<double>(lines * theta.size(), 0.0)};
    for (int front = 0; front < shape.bundles; ++front) fill_bundle(at, shape, theta, front, y);
    fill_sides(at, shape, theta);
    at.is_inside = is_in_order(at, shape);
    return at;
}

SplineFunction front_curve(const FrontShape& shape, const std::vector<double>& theta, int front) {
    const BSplineBasis basis = phi_basis(shape);
    const auto first = theta.begin() + static_cast<std::ptrdiff_t>(shape.phi_at(front));
    return {{basis.knots().begin(), basis.knots().end()},
            {first, first + shape.front_values()}, 3};
}

double bundle_width(const FrontShape& shape, const std::vector<double>& theta, int front) {
    const std::vector<double> offsets = offsets_of(shape, theta, front);
    return offsets.back() - offsets.front();
}

CurvedKnotSurface front_surface(const FrontShape& shape, const std::vector<double>& theta,
                                const std::vector<double>& coefficients) {
    std::vector<SplineFunction> y_lines;
    const std::vector<double> breaks =
        even_places(shape.domain.y, static_cast<std::size_t>(shape.y_strips) + 1);
    for (std::size_t j = 1; j + 1 < breaks.size(); ++j) {
        y_lines.emplace_back(std::vector<double>{shape.domain.x.lo, shape.domain.x.hi},
                             std::vector<double>{breaks[j]}, 0);
    }
    if (!shape.given.empty()) {
        return {3, shape.domain, shape.given, std::move(y_lines), coefficients};
    }
    const BSplineBasis basis = phi_basis(shape);
    const std::size_t values = basis.size();
    std::vector<std::vector<double>> lines{std::vector<double>(values, shape.domain.x.lo)};
    for (int front = 0; front < shape.bundles; ++front) {
        const std::size_t first = shape.phi_at(front);
        for (const double offset : offsets_of(shape, theta, front)) {
            lines.emplace_back(theta.begin() + static_cast<std::ptrdiff_t>(first),
                               theta.begin() + static_cast<std::ptrdiff_t>(first + values));
            for (double& c : lines.back()) c += offset;
        }
    }
    lines.emplace_back(values, shape.domain.x.hi);
    std::vector<SplineFunction> x_lines;
    const auto add = [&](std::vector<double> c) {
        x_lines.emplace_back(std::vector<double>(basis.knots().begin(), basis.knots().end()),
                             std::move(c), 3);
    };
    std::size_t side = shape.sides_at();
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        if (i > 0) add(lines[i]);
        const bool is_end = i % static_cast<std::size_t>(shape.bundle) == 0;
        if (shape.beside == 0 || !is_end) continue;
        const double share = logistic(theta[side++]);
        std::vector<double> c = lines[i];
        for (std::size_t k = 0; k < values; ++k) c[k] += share * (lines[i + 1][k] - lines[i][k]);
        add(std::move(c));
    }
    return {3, shape.domain, std::move(x_lines), std::move(y_lines), coefficients};
}

std::vector<double> front_start(const FrontShape& shape, const Nodes& nodes,
                                const std::vector<FrontStart>& fronts) {
    std::vector<double> theta;
    for (const FrontStart& front : fronts) {
        const std::vector<double> phi = phi_through(shape, nodes, front.path);
        theta.insert(theta.end(), phi.begin(), phi.end());
        theta.insert(theta.end(), static_cast<std::size_t>(shape.bundle) - 1,
                     std::log(front.width / (shape.bundle - 1)));
    }
    theta.insert(theta.end(), static_cast<std::size_t>(shape.sides()), 0.0);
    return theta;
}

}  // namespace batten::surface_fitting
