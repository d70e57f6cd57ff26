#pragma once

#include <vector>

#include "batten/shape/curved_knot_surface.hpp"
#include "make/fit_surface/nodes.hpp"

namespace batten::surface_fitting {

/// Which lines there are: bundles, one a front, from left to right, and in every space beside a
/// bundle one line or none.
///
/// Their parameters: for every bundle the coefficients of its phi and the logarithms of its gaps;
/// then for every line beside the logit of its share of the way between its neighbours.
struct FrontShape {
    Rectangle domain;
    int bundles = 1;
    int bundle = 5;           ///< lines along each front
    int beside = 1;           ///< lines in every space beside
    int front_intervals = 3;  ///< of each phi
    int y_strips = 3;
    std::vector<SplineFunction> given = {};  ///< lines that stand still, in place of bundles

    int front_values() const { return front_intervals + 3; }
    int bundle_parameters() const { return front_values() + bundle - 1; }
    int sides() const { return beside * (bundles + 1); }
    int parameters() const {
        return given.empty() ? bundles * bundle_parameters() + sides() : 0;
    }
    int lines() const {
        return given.empty() ? bundles * bundle + sides() : static_cast<int>(given.size());
    }
    int x_functions() const { return lines() + 4; }
    int y_functions() const { return y_strips + 3; }
    int coefficients() const { return x_functions() * y_functions(); }

    /// Where the parameters of a front start: phi, then its gaps.
    std::size_t phi_at(int front) const {
        return static_cast<std::size_t>(front) * static_cast<std::size_t>(bundle_parameters());
    }
    std::size_t gaps_at(int front) const {
        return phi_at(front) + static_cast<std::size_t>(front_values());
    }
    std::size_t sides_at() const { return phi_at(bundles); }
    /// The first line of a bundle.
    std::size_t line_at(int front) const {
        return static_cast<std::size_t>(front * bundle + beside * (front + 1));
    }
    /// Whether parameter k is a coefficient of a phi.
    bool is_place(int k) const {
        return k < bundles * bundle_parameters() && k % bundle_parameters() < front_values();
    }
};

/// The lines at one y and their derivatives by the parameters, lines() x parameters().
struct LinesAt {
    std::vector<double> x;
    std::vector<double> slopes;
    bool is_inside = true;  ///< in order, within the domain
};

LinesAt lines_at(const FrontShape& shape, const std::vector<double>& theta, double y);

CurvedKnotSurface front_surface(const FrontShape& shape, const std::vector<double>& theta,
                                const std::vector<double>& coefficients);

/// phi of one front.
SplineFunction front_curve(const FrontShape& shape, const std::vector<double>& theta, int front);

/// What is between the outer lines of a bundle.
double bundle_width(const FrontShape& shape, const std::vector<double>& theta, int front);

/// A bundle of this total width along x at every y-line.
struct FrontStart {
    std::vector<double> path;
    double width;
};

/// The parameters that put bundles along paths, from left to right.
std::vector<double> front_start(const FrontShape& shape, const Nodes& nodes,
                                const std::vector<FrontStart>& fronts);

}  // namespace batten::surface_fitting
