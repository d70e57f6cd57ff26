#pragma once

#include <array>
#include <vector>

#include "batten/make/fair_surface.hpp"
#include "batten/shape/coons.hpp"
#include "make/fair/surface/planes.hpp"

namespace batten::fairing {

/// Derivatives of the surface at an inner node by three-point differences.
SurfaceJet node_jet(const Planes& planes, const Differences& u, const Differences& v, std::size_t i,
                    std::size_t j);

/// A curvature at the inner nodes of a grid, and how it changes as nodes move along their normals.
class CurvatureField {
public:
    /// Directions that nodes move in: `normals`, 0 for those that stay.
    CurvatureField(const Knots& knots, SurfaceTarget target, Planes normals);

    /// Sets the values and their derivatives at these nodes. Where S_u and S_v are parallel both
    /// are 0.
    void linearise(const Planes& planes);
    /// Sets the values alone.
    void evaluate(const Planes& planes);

    const Plane& values() const { return values_; }
    const Planes& normals() const { return normals_; }
    /// The change of the values by displacements, and its transpose.
    Plane changed(const Plane& displacement) const;
    Plane transposed(const Plane& change) const;

    /// G' G of a field on inner nodes, G being its differences between neighbours over their
    /// distances; and |G field|^2.
    Plane roughened(const Plane& field) const;
    double roughness_sq(const Plane& field) const;

    /// Mean squares over the inner nodes of what multiplies -w_u^2, w_u w_v and -w_v^2 in the
    /// change by a wave of unit amplitude with frequencies w_u, w_v, and the mean product of the
    /// first and the last.
    struct Symbol {
        double uu_sq = 0, uv_sq = 0, vv_sq = 0, both = 0;
        /// Mean square of the change's differences for that wave.
        double operator()(double u, double v) const;
    };
    Symbol symbol(const Planes& planes) const;

private:
    Knots knots_;
    SurfaceTarget target_;
    std::vector<Differences> u_, v_;
    Planes normals_;
    Plane values_;
    std::vector<std::array<double, 9>> by_node_;  ///< u offset + 3 x v offset
};

/// Unit normals S_u x S_v at the nodes that are `held` or more lines inside, 0 elsewhere.
Planes normals_of(const Planes& planes, const Knots& knots, std::size_t held);

}  // namespace batten::fairing
