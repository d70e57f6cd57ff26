#include "make/fair/surface/bend.hpp"

#include <cmath>
#include <optional>
#include <utility>

namespace batten::fairing {
namespace {

using Eigen::Index;
using space::cross;
using space::dot;
using space::Vector;

Vector sum(double a, const Vector& x, double b, const Vector& y) {
    return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

/// A curvature and its derivatives by the five derivatives of the surface.
struct Gradient {
    double value = 0;
    Vector u{}, v{}, uu{}, uv{}, vv{};
};

/// What all curvatures are made of: the normal, not of unit length, and second derivatives along it.
struct Form {
    Vector normal;
    double size_sq, e, f, g;
};

std::optional<Form> form_of(const SurfaceJet& s) {
    const Vector n = cross(s.u, s.v);
    const double size_sq = dot(n, n);
    // Where its square is lost, so are curvatures.
    if (!(size_sq * size_sq > 0)) return std::nullopt;
    return Form{n, size_sq, dot(n, s.uu), dot(n, s.uv), dot(n, s.vv)};
}

/// K = (e g - f^2) / |n|^4.
Gradient gaussian(const SurfaceJet& s, const Form& m) {
    const double square = m.size_sq * m.size_sq;
    Gradient k;
    k.value = (m.e * m.g - m.f * m.f) / square;
    k.uu = sum(m.g / square, m.normal, 0, m.normal);
    k.vv = sum(m.e / square, m.normal, 0, m.normal);
    k.uv = sum(-2 * m.f / square, m.normal, 0, m.normal);
    const Vector ends = sum(m.g / square, s.uu, m.e / square, s.vv);
    const Vector by_normal =
        sum(1, sum(1, ends, -2 * m.f / square, s.uv), -4 * k.value / m.size_sq, m.normal);
    k.u = cross(s.v, by_normal);
    k.v = cross(by_normal, s.u);
    return k;
}

/// H = (e G - 2 f F + g E) / (2 |n|^3), E, F, G being the products of S_u and S_v.
Gradient mean(const SurfaceJet& s, const Form& m) {
    const double cube = m.size_sq * std::sqrt(m.size_sq);
    const double ee = dot(s.u, s.u), ff = dot(s.u, s.v), gg = dot(s.v, s.v);
    Gradient h;
    h.value = (m.e * gg - 2 * m.f * ff + m.g * ee) / (2 * cube);
    h.uu = sum(gg / (2 * cube), m.normal, 0, m.normal);
    h.vv = sum(ee / (2 * cube), m.normal, 0, m.normal);
    h.uv = sum(-ff / cube, m.normal, 0, m.normal);
    const Vector ends = sum(gg / (2 * cube), s.uu, ee / (2 * cube), s.vv);
    const Vector by_normal =
        sum(1, sum(1, ends, -ff / cube, s.uv), -3 * h.value / m.size_sq, m.normal);
    h.u = sum(1, cross(s.v, by_normal), 1, sum(m.g / cube, s.u, -m.f / cube, s.v));
    h.v = sum(1, cross(by_normal, s.u), 1, sum(m.e / cube, s.v, -m.f / cube, s.u));
    return h;
}

Gradient curvature_at(const SurfaceJet& jet, SurfaceTarget target) {
    const std::optional<Form> form = form_of(jet);
    if (!form) return {};
    const Gradient g = target == SurfaceTarget::gaussian ? gaussian(jet, *form) : mean(jet, *form);
    return std::isfinite(g.value) ? g : Gradient{};
}

/// The derivative by the node at offsets a, b (0, 1, 2) moved along `normal`.
double by_node(const Gradient& g, const Differences& u, const Differences& v, std::size_t a,
               std::size_t b, const Vector& normal) {
    double d = u.first[a] * v.first[b] * dot(g.uv, normal);
    if (b == 1) d += u.first[a] * dot(g.u, normal) + u.second[a] * dot(g.uu, normal);
    if (a == 1) d += v.first[b] * dot(g.v, normal) + v.second[b] * dot(g.vv, normal);
    return d;
}

}  // namespace

SurfaceJet node_jet(const Planes& planes, const Differences& u, const Differences& v, std::size_t i,
                    std::size_t j) {
    SurfaceJet jet;
    jet.point = planes(i, j);
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            const Vector p = planes(i + a - 1, j + b - 1);
            jet.uv = sum(1, jet.uv, u.first[a] * v.first[b], p);
            if (b == 1) {
                jet.u = sum(1, jet.u, u.first[a], p);
                jet.uu = sum(1, jet.uu, u.second[a], p);
            }
            if (a == 1) {
                jet.v = sum(1, jet.v, v.first[b], p);
                jet.vv = sum(1, jet.vv, v.second[b], p);
            }
        }
    }
    return jet;
}

Planes normals_of(const Planes& planes, const Knots& knots, std::size_t held) {
    const auto u = differences_of(knots.u), v = differences_of(knots.v);
    Planes normals = planes;
    for (Plane& plane : normals.at) plane.setZero();
    for (std::size_t j = held; j + held < planes.nv(); ++j) {
        for (std::size_t i = held; i + held < planes.nu(); ++i) {
            const SurfaceJet jet = node_jet(planes, u[i], v[j], i, j);
            const Vector n = cross(jet.u, jet.v);
            const double size = std::sqrt(dot(n, n));
            if (size > 0) normals.set(i, j, {n[0] / size, n[1] / size, n[2] / size});
        }
    }
    return normals;
}

CurvatureField::CurvatureField(const Knots& knots, SurfaceTarget target, Planes normals)
    : knots_(knots),
      target_(target),
      u_(differences_of(knots.u)),
      v_(differences_of(knots.v)),
      normals_(std::move(normals)),
      values_(Plane::Zero(normals_.at[0].rows(), normals_.at[0].cols())),
      by_node_(knots.u.size() * knots.v.size()) {}

void CurvatureField::evaluate(const Planes& planes) {
    for (std::size_t j = 1; j + 1 < knots_.v.size(); ++j) {
        for (std::size_t i = 1; i + 1 < knots_.u.size(); ++i) {
            const SurfaceJet jet = node_jet(planes, u_[i], v_[j], i, j);
            values_(static_cast<Index>(i), static_cast<Index>(j)) = curvature_at(jet, target_).value;
        }
    }
}

void CurvatureField::linearise(const Planes& planes) {
    for (std::size_t j = 1; j + 1 < knots_.v.size(); ++j) {
        for (std::size_t i = 1; i + 1 < knots_.u.size(); ++i) {
            const Gradient g = curvature_at(node_jet(planes, u_[i], v_[j], i, j), target_);
            values_(static_cast<Index>(i), static_cast<Index>(j)) = g.value;
            std::array<double, 9>& row = by_node_[i + knots_.u.size() * j];
            for (std::size_t b = 0; b < 3; ++b) {
                for (std::size_t a = 0; a < 3; ++a) {
                    row[a + 3 * b] =
                        by_node(g, u_[i], v_[j], a, b, normals_(i + a - 1, j + b - 1));
                }
            }
        }
    }
}

Plane CurvatureField::changed(const Plane& displacement) const {
    Plane change = Plane::Zero(displacement.rows(), displacement.cols());
    for (Index j = 1; j + 1 < change.cols(); ++j) {
        for (Index i = 1; i + 1 < change.rows(); ++i) {
            const auto& row = by_node_[static_cast<std::size_t>(i + change.rows() * j)];
            double c = 0;
            for (Index b = 0; b < 3; ++b) {
                for (Index a = 0; a < 3; ++a) {
                    c += row[static_cast<std::size_t>(a + 3 * b)] *
                         displacement(i + a - 1, j + b - 1);
                }
            }
            change(i, j) = c;
        }
    }
    return change;
}

Plane CurvatureField::transposed(const Plane& change) const {
    Plane result = Plane::Zero(change.rows(), change.cols());
    for (Index j = 1; j + 1 < change.cols(); ++j) {
        for (Index i = 1; i + 1 < change.rows(); ++i) {
            const auto& row = by_node_[static_cast<std::size_t>(i + change.rows() * j)];
            for (Index b = 0; b < 3; ++b) {
                for (Index a = 0; a < 3; ++a) {
                    result(i + a - 1, j + b - 1) +=
                        row[static_cast<std::size_t>(a + 3 * b)] * change(i, j);
                }
            }
        }
    }
    return result;
}

Plane CurvatureField::roughened(const Plane& field) const {
    Plane result = Plane::Zero(field.rows(), field.cols());
    for (Index j = 1; j + 1 < field.cols(); ++j) {
        for (Index i = 1; i + 1 < field.rows(); ++i) {
            if (i + 2 < field.rows()) {
                const double h = knots_.u[static_cast<std::size_t>(i) + 1] -
                                 knots_.u[static_cast<std::size_t>(i)];
                const double d = (field(i + 1, j) - field(i, j)) / (h * h);
                result(i + 1, j) += d;
                result(i, j) -= d;
            }
            if (j + 2 < field.cols()) {
                const double h = knots_.v[static_cast<std::size_t>(j) + 1] -
                                 knots_.v[static_cast<std::size_t>(j)];
                const double d = (field(i, j + 1) - field(i, j)) / (h * h);
                result(i, j + 1) += d;
                result(i, j) -= d;
            }
        }
    }
    return result;
}

double CurvatureField::roughness_sq(const Plane& field) const {
    return roughened(field).cwiseProduct(field).sum();
}

double CurvatureField::Symbol::operator()(double u, double v) const {
    const double u_sq = u * u, v_sq = v * v;
    return (u_sq + v_sq) * (uu_sq * u_sq * u_sq + (uv_sq + 2 * both) * u_sq * v_sq +
                            vv_sq * v_sq * v_sq);
}

CurvatureField::Symbol CurvatureField::symbol(const Planes& planes) const {
    Symbol s;
    double count = 0;
    for (std::size_t j = 1; j + 1 < knots_.v.size(); ++j) {
        for (std::size_t i = 1; i + 1 < knots_.u.size(); ++i) {
            const Gradient g = curvature_at(node_jet(planes, u_[i], v_[j], i, j), target_);
            const Vector n = normals_(i, j);
            const double uu = dot(g.uu, n), uv = dot(g.uv, n), vv = dot(g.vv, n);
            s.uu_sq += uu * uu, s.uv_sq += uv * uv, s.vv_sq += vv * vv, s.both += uu * vv;
            count += 1;
        }
    }
    s.uu_sq /= count, s.uv_sq /= count, s.vv_sq /= count, s.both /= count;
    return s;
}

}  // namespace batten::fairing
