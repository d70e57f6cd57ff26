#pragma once

#include <memory>
#include <vector>

#include "make/fit_surface/inclusion.hpp"
#include "make/fit_surface/masked_normals.hpp"
#include "make/fit_surface/search_space.hpp"

namespace batten::surface_fitting {

/// A large grid of which nodes are missing, read once: what fits over halved strips need of it.
///
/// Splines over strips made by halving lie in the space over the finest strips of that kind. Kept
/// are its normal equations, and of every line of the grid those of its nodes with the splines
/// across, which tell how badly it is fitted.
///
/// delta2 is that of a good surface found there, which a second reading measures, and what others
/// differ from it, so that little cancels.
/// Memory: of every line order + 1 numbers a spline across.
/// Cost:   two passes over the nodes; a fit none. Borrows the nodes.
class MaskedSpace {
public:
    /// Nothing where the lines do not determine the splines over these breaks. Errors of nodes are
    /// products of those of rows and columns.
    static std::unique_ptr<MaskedSpace> over(const Nodes& nodes, int degree,
                                             const std::vector<double>& x_breaks,
                                             const std::vector<double>& y_breaks);

    bool has_breaks(const std::vector<double>& x_breaks, const std::vector<double>& y_breaks) const;
    bool has_break(Way way, double t) const;

    /// The fit over breaks that it has, and its delta2 and measures of strips by the projected rule.
    Solution solution(const Axis& x, const Axis& y) const;
    Misfit misfit(const Axis& x, const Axis& y, const std::vector<double>& c) const;

private:
    MaskedSpace(const Nodes& nodes, Axis x, Axis y);
    void read();
    void add_row(std::size_t r, const MaskedRow& row);
    void add_columns(const MaskedRows& rows);

    /// The lines of one direction by the splines across, those slowest.
    struct Lines {
        std::vector<double> products;
        std::vector<double> gram;  ///< bands, the diagonal first
    };
    /// `c`: coefficients over the finest strips, splines across slowest.
    std::vector<double> strips(Way way, const Axis& along, const Axis& across,
                               const std::vector<double>& c) const;
    const Axis& fine(Way way) const { return way == Way::x ? x_ : y_; }

    const Nodes& nodes_;
    Axis x_, y_;
    MaskedNormals normals_;
    Lines x_lines_, y_lines_;
    std::vector<double> good_;    ///< the coefficients of a fit over the finest strips,
    double good_delta2_ = 0;      ///< what it leaves of the nodes,
    std::vector<double> unused_;  ///< and of their products
};

}  // namespace batten::surface_fitting
