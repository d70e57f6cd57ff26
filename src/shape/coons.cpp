#include "batten/shape/coons.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "shape/space.hpp"

namespace batten {
namespace {

constexpr double largest_gap = 1e-6;  ///< of the extent

/// Value and two derivatives over [0, 1].
struct EdgeJet {
    space::Vector point{}, slope{}, bow{};
};

EdgeJet edge_jet(const Curve& curve, double x) {
    const Interval domain = curve.domain();
    const double scale = domain.length();
    const Jet jet = curve.jet(x == 1 ? domain.hi : domain.lo + scale * x, 2);
    EdgeJet result;
    for (std::size_t k = 0; k < static_cast<std::size_t>(curve.dim()); ++k) {
        result.point[k] = jet[0][k];
        result.slope[k] = scale * jet[1][k];
        result.bow[k] = scale * scale * jet[2][k];
    }
    return result;
}

/// The corner where end `a` of one edge meets end `b` of another.
space::Vector corner(const Curve& first, double a, const Curve& second, double b, const char* name) {
    const space::Vector p = edge_jet(first, a).point, q = edge_jet(second, b).point;
    const double gap = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    if (!(gap <= largest_gap * std::fmax(extent(first), extent(second)))) {
        throw Error("coons.corners", name, "a gap of " + format_number(gap),
                    "edges must meet: c0 and c1 along u, d0 and d1 along v, each from 0 to 1");
    }
    return p;
}

}  // namespace

CoonsPatch::CoonsPatch(Curve c0, Curve c1, Curve d0, Curve d1)
    : edges_{std::move(c0), std::move(c1), std::move(d0), std::move(d1)}, corners_{} {
    for (const Curve& edge : edges_) {
        if (edge.dim() == 2 || edge.dim() == 3) continue;
        throw Error("curve.dimension", "edge", std::to_string(edge.dim()) + " coordinates",
                    "edges lie in the plane or in space");
    }
    corners_ = {corner(edges_[0], 0, edges_[2], 0, "corner u = 0, v = 0"),
                corner(edges_[0], 1, edges_[3], 0, "corner u = 1, v = 0"),
                corner(edges_[1], 0, edges_[2], 1, "corner u = 0, v = 1"),
                corner(edges_[1], 1, edges_[3], 1, "corner u = 1, v = 1")};
}

SurfaceJet CoonsPatch::jet(double u, double v) const {
    const EdgeJet c0 = edge_jet(edges_[0], u), c1 = edge_jet(edges_[1], u);
    const EdgeJet d0 = edge_jet(edges_[2], v), d1 = edge_jet(edges_[3], v);
    const auto& [p00, p10, p01, p11] = corners_;
    SurfaceJet s;
    for (std::size_t k = 0; k < 3; ++k) {
        const double twist = p00[k] - p10[k] - p01[k] + p11[k];
        const double flat_u = (1 - v) * (p10[k] - p00[k]) + v * (p11[k] - p01[k]);
        const double flat_v = (1 - u) * (p01[k] - p00[k]) + u * (p11[k] - p10[k]);
        const double flat = (1 - u) * ((1 - v) * p00[k] + v * p01[k]) +
                            u * ((1 - v) * p10[k] + v * p11[k]);
        s.point[k] = (1 - v) * c0.point[k] + v * c1.point[k] + (1 - u) * d0.point[k] +
                     u * d1.point[k] - flat;
        s.u[k] = (1 - v) * c0.slope[k] + v * c1.slope[k] + (d1.point[k] - d0.point[k]) - flat_u;
        s.v[k] = (c1.point[k] - c0.point[k]) + (1 - u) * d0.slope[k] + u * d1.slope[k] - flat_v;
        s.uu[k] = (1 - v) * c0.bow[k] + v * c1.bow[k];
        s.vv[k] = (1 - u) * d0.bow[k] + u * d1.bow[k];
        s.uv[k] = c1.slope[k] - c0.slope[k] + d1.slope[k] - d0.slope[k] - twist;
    }
    return s;
}

}  // namespace batten
