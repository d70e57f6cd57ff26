#include "make/fair/surface/filter.hpp"

#include <cmath>
#include <optional>

#include "batten/measure/surface.hpp"
#include "make/fair/surface/bend.hpp"

namespace batten::fairing {
namespace {

using Eigen::Index;
using space::dot;
using space::Vector;

constexpr double damping = 0.3;

/// The curvature of every inner node, as (i, j).
Plane curvatures(const Planes& p, SurfaceTarget target) {
    const Differences one = differences(1, 1);
    Plane result = Plane::Zero(p.at[0].rows(), p.at[0].cols());
    for (std::size_t j = 1; j + 1 < p.nv(); ++j) {
        for (std::size_t i = 1; i + 1 < p.nu(); ++i) {
            const auto bend = surface_bend(node_jet(p, one, one, i, j));
            if (!bend) continue;
            result(static_cast<Index>(i), static_cast<Index>(j)) =
                target == SurfaceTarget::gaussian ? bend->gaussian : bend->mean;
        }
    }
    return result;
}

/// The mean over the inner nodes of the three by three around a node.
double mean_around(const Plane& field, Index i, Index j) {
    double sum = 0, count = 0;
    for (Index a = i - 1; a <= i + 1; ++a) {
        for (Index b = j - 1; b <= j + 1; ++b) {
            if (a < 1 || b < 1 || a + 1 >= field.rows() || b + 1 >= field.cols()) continue;
            sum += field(a, b);
            count += 1;
        }
    }
    return sum / count;
}

/// From where the node is displaced.
Vector base_of(const Planes& p, FilterRoot root, std::size_t i, std::size_t j) {
    if (root == FilterRoot::nearest) return p(i, j);
    Vector mean{};
    for (std::size_t a = i - 1; a <= i + 1; ++a) {
        for (std::size_t b = j - 1; b <= j + 1; ++b) {
            if (a == i && b == j) continue;
            const Vector q = p(a, b);
            for (std::size_t k = 0; k < 3; ++k) mean[k] += q[k] / 8;
        }
    }
    return mean;
}

/// The solution of 4 x^2 - 2 s x + c = 0 nearest to 0, if there is one.
std::optional<double> smaller_root(double s, double c) {
    const double square = s * s - 4 * c;
    if (square < 0) return std::nullopt;
    const double larger = s + std::copysign(std::sqrt(square), s);
    return larger == 0 ? 0 : c / larger;
}

/// The displacement along the unit normal after which the curvature is `wanted`.
std::optional<double> displacement(const SurfaceJet& s, const Vector& normal, double wanted,
                                   SurfaceTarget target) {
    const double e = dot(normal, s.uu), f = dot(normal, s.uv), g = dot(normal, s.vv);
    const double ee = dot(s.u, s.u), ff = dot(s.u, s.v), gg = dot(s.v, s.v);
    const double size_sq = ee * gg - ff * ff;
    if (target == SurfaceTarget::mean) {
        const double now = e * gg - 2 * f * ff + g * ee;
        return (now - 2 * wanted * size_sq) / (2 * (ee + gg));
    }
    return smaller_root(e + g, e * g - f * f - wanted * size_sq);
}

/// Where node i, j goes, or nothing.
std::optional<Vector> place(const Planes& p, const SurfaceFilterPlan& plan, double wanted,
                            std::size_t i, std::size_t j) {
    const Differences one = differences(1, 1);
    SurfaceJet jet = node_jet(p, one, one, i, j);
    const auto bend = surface_bend(jet);
    if (!bend) return std::nullopt;
    const Vector here = p(i, j), base = base_of(p, plan.root, i, j);
    for (std::size_t k = 0; k < 3; ++k) {
        jet.uu[k] += 2 * (here[k] - base[k]);
        jet.vv[k] += 2 * (here[k] - base[k]);
    }
    const auto phi = displacement(jet, bend->normal, wanted, plan.target);
    if (!phi) return std::nullopt;
    Vector next;
    for (std::size_t k = 0; k < 3; ++k) {
        next[k] = here[k] + damping * (base[k] + *phi * bend->normal[k] - here[k]);
        if (!std::isfinite(next[k])) return std::nullopt;
    }
    return next;
}

double extent_of(const Planes& p) {
    double extent = 0;
    for (const Plane& plane : p.at) extent = std::fmax(extent, plane.maxCoeff() - plane.minCoeff());
    return extent;
}

}  // namespace

SurfaceFiltered filtered(const Planes& data, const SurfaceFilterPlan& plan) {
    SurfaceFiltered result{data, 0, 0, 0, false};
    const double extent = extent_of(data);
    while (result.sweeps < plan.sweeps) {
        const Planes before = result.planes;
        const Plane field = curvatures(before, plan.target);
        ++result.sweeps;
        result.rootless = 0;
        result.last_move = 0;
        for (std::size_t j = plan.held; j + plan.held < before.nv(); ++j) {
            for (std::size_t i = plan.held; i + plan.held < before.nu(); ++i) {
                const double wanted =
                    mean_around(field, static_cast<Index>(i), static_cast<Index>(j));
                const auto next = place(before, plan, wanted, i, j);
                if (!next) {
                    ++result.rootless;
                    continue;
                }
                const Vector here = before(i, j);
                result.last_move = std::fmax(
                    result.last_move, std::hypot((*next)[0] - here[0], (*next)[1] - here[1],
                                                 (*next)[2] - here[2]));
                result.planes.set(i, j, *next);
            }
        }
        if (result.last_move > extent) {
            result.planes = before;
            result.burst = true;
            break;
        }
    }
    return result;
}

}  // namespace batten::fairing
