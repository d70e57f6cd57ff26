#include "make/pseudo/segment/kernel.hpp"

#include <cmath>
#include <limits>

#include "make/pseudo/segment/lanes.hpp"
#include "make/pseudo/segment/pieces.hpp"
#include "num/roots.hpp"

namespace batten::pseudo {
namespace {

/// The numbers of a segment all nodes share: w = T0 p0 + 2 D p1 + T1 p2 and
/// N / 2 = A0 p0 + A1 p2 + q (p1 - p0 - p2), p0 = (1-t)^2, p1 = t (1-t), p2 = t^2.
struct Cubic {
    explicit Cubic(const PseudoSegment& s);

    double x0, y0, x1, y1;  // end tangents T0, T1
    double dx, dy;          // D = (3, 0) - T0 - T1
    double dot, cross;      // T0 . T1 and q = T0 x T1
    std::array<std::complex<double>, 2> roots{};
    int root_count = 0;
};

Cubic::Cubic(const PseudoSegment& s)
    : x0(s.r0 * std::cos(s.theta0)),
      y0(s.r0 * std::sin(s.theta0)),
      x1(s.r1 * std::cos(s.theta1)),
      y1(s.r1 * std::sin(s.theta1)),
      dx(3 - (x0 + x1)),
      dy(-(y0 + y1)),
      dot(s.r0 * s.r1 * std::cos(s.theta1 - s.theta0)),
      cross(s.r0 * s.r1 * std::sin(s.theta1 - s.theta0)) {
    const std::complex<double> c0(x0, y0);
    const std::complex<double> c1(2 * (dx - x0), 2 * (dy - y0));
    const std::complex<double> c2((x0 + x1) - 2 * dx, (y0 + y1) - 2 * dy);
    const num::ComplexRoots found = num::complex_roots({c0, c1, c2});
    roots = found.values;
    root_count = found.count;
}

/// The functions of four nodes: the Bernstein basis, w, N and |w|.
struct Node {
    Node(const Cubic& c, Lanes t)
        : p0((1.0 - t) * (1.0 - t)),
          p1(t * (1.0 - t)),
          p2(t * t),
          mid(p1 - (p0 + p2)),
          wx(p0 * c.x0 + p2 * c.x1 + p1 * (2 * c.dx)),
          wy(p0 * c.y0 + p2 * c.y1 + p1 * (2 * c.dy)),
          half_n(p2 * (3 * c.y1) - p0 * (3 * c.y0) + mid * c.cross),
          speed_sq(wx * wx + wy * wy),
          speed(square_root(speed_sq)) {}

    Lanes p0, p1, p2, mid;
    Lanes wx, wy;
    Lanes half_n;
    Lanes speed_sq, speed;
};

/// Derivatives of N / 2 and s = |w|^2 in the first V variables.
template <int V>
struct NodeDerivatives {
    NodeDerivatives(const Cubic& c, const Node& node);

    std::array<Lanes, V> n, s;
    std::array<std::array<Lanes, V>, V> nn, ss;  // upper triangles
};

template <int V>
NodeDerivatives<V>::NodeDerivatives(const Cubic& c, const Node& node) {
    const Lanes alpha = node.p0 - 2.0 * node.p1;  // dw / dT0
    const Lanes beta = node.p2 - 2.0 * node.p1;   // dw / dT1
    const Lanes alpha2 = 2.0 * alpha;
    const Lanes beta2 = 2.0 * beta;
    const Lanes ab = alpha2 * beta;
    const Lanes aa = alpha2 * alpha * (c.x0 * c.x0 + c.y0 * c.y0);
    const Lanes bb = beta2 * beta * (c.x1 * c.x1 + c.y1 * c.y1);
    const Lanes q = node.mid * c.cross;
    n[ln_r0] = q - node.p0 * (3 * c.y0);
    n[ln_r1] = q + node.p2 * (3 * c.y1);
    s[ln_r0] = alpha2 * (node.wx * c.x0 + node.wy * c.y0);
    s[ln_r1] = beta2 * (node.wx * c.x1 + node.wy * c.y1);
    nn[ln_r0][ln_r0] = n[ln_r0];
    nn[ln_r0][ln_r1] = q;
    nn[ln_r1][ln_r1] = n[ln_r1];
    ss[ln_r0][ln_r0] = aa + s[ln_r0];
    ss[ln_r0][ln_r1] = ab * c.dot;
    ss[ln_r1][ln_r1] = bb + s[ln_r1];
    if constexpr (V == 4) {
        const Lanes k = node.mid * c.dot;
        n[angle0] = 0.0 - (node.p0 * (3 * c.x0) + k);
        n[angle1] = node.p2 * (3 * c.x1) + k;
        s[angle0] = alpha2 * (node.wy * c.x0 - node.wx * c.y0);
        s[angle1] = beta2 * (node.wy * c.x1 - node.wx * c.y1);
        nn[ln_r0][angle0] = n[angle0];
        nn[ln_r0][angle1] = k;
        nn[ln_r1][angle0] = 0.0 - k;
        nn[ln_r1][angle1] = n[angle1];
        nn[angle0][angle0] = 0.0 - n[ln_r0];
        nn[angle0][angle1] = q;
        nn[angle1][angle1] = 0.0 - n[ln_r1];
        ss[ln_r0][angle0] = s[angle0];
        ss[ln_r0][angle1] = 0.0 - ab * c.cross;
        ss[ln_r1][angle0] = ab * c.cross;
        ss[ln_r1][angle1] = s[angle1];
        ss[angle0][angle0] = aa - s[ln_r0];
        ss[angle0][angle1] = ab * c.dot;
        ss[angle1][angle1] = bb - s[ln_r1];
    }
}

/// Integrals of E / 4 and L with their derivatives.
template <int V>
struct Sums {
    void add(const Cubic& c, const Lanes& t, const Lanes& weight);
    Expansion<V> product() const;

    Lanes e, l;
    std::array<Lanes, V> e1, l1;
    std::array<std::array<Lanes, V>, V> e2, l2;  // upper triangles
};

template <int V>
void Sums<V>::add(const Cubic& c, const Lanes& t, const Lanes& weight) {
    const Node node(c, t);
    const Lanes over_s = 1.0 / node.speed_sq;
    const Lanes n_weight = weight * over_s * over_s * over_s * node.speed;  // |w|^-5
    const Lanes density = n_weight * node.half_n * node.half_n;
    const Lanes length = weight * node.speed;
    e += density;
    l += length;
    if constexpr (V > 0) {
        const NodeDerivatives<V> d(c, node);
        // with f = n^2 s^(-5/2) and g = s^(1/2):
        const Lanes fn = 2.0 * n_weight * node.half_n;
        const Lanes fs = -2.5 * density * over_s;
        const Lanes fnn = 2.0 * n_weight;
        const Lanes fns = -2.5 * fn * over_s;
        const Lanes fss = -3.5 * fs * over_s;
        const Lanes gs = 0.5 * length * over_s;
        const Lanes gss = -0.5 * gs * over_s;
        for (std::size_t i = 0; i < V; ++i) {
            e1[i] += fn * d.n[i] + fs * d.s[i];
            l1[i] += gs * d.s[i];
            const Lanes by_n = fnn * d.n[i] + fns * d.s[i];
            const Lanes by_s = fns * d.n[i] + fss * d.s[i];
            const Lanes by_g = gss * d.s[i];
            for (std::size_t j = i; j < V; ++j) {
                e2[i][j] += by_n * d.n[j] + by_s * d.s[j] + fn * d.nn[i][j] + fs * d.ss[i][j];
                l2[i][j] += by_g * d.s[j] + gs * d.ss[i][j];
            }
        }
    }
}

template <int V>
Expansion<V> Sums<V>::product() const {
    Expansion<V> j;
    const double energy = e.sum();
    const double length = l.sum();
    j.energy = 4 * energy;
    j.length = length;
    j.value = j.energy * length * length;
    for (std::size_t a = 0; a < V; ++a) {
        const double ea = e1[a].sum();
        const double la = l1[a].sum();
        j.gradient[a] = 4 * length * (ea * length + 2 * energy * la);
        for (std::size_t b = a; b < V; ++b) {
            const double mixed = ea * l1[b].sum() + e1[b].sum() * la + energy * l2[a][b].sum();
            j.hessian[a][b] = j.hessian[b][a] =
                4 * (e2[a][b].sum() * length * length + 2 * length * mixed +
                     2 * energy * la * l1[b].sum());
        }
    }
    return j;
}

template <int V>
Expansion<V> expand(const PseudoSegment& segment) {
    const Cubic cubic(segment);
    Pieces pieces(cubic.roots.data(), cubic.root_count);
    Sums<V> sums;
    Piece piece;
    while (pieces.next(piece)) {
        const double half = 0.5 * piece.part.length();
        const double middle = piece.part.middle();
        for (std::size_t i = 0; i < piece.rule.nodes.size(); i += Lanes::count) {
            const Lanes node(piece.rule.nodes[i], piece.rule.nodes[i + 1]);
            const Lanes weight(piece.rule.weights[i], piece.rule.weights[i + 1]);
            sums.add(cubic, middle + half * node, half * weight);
        }
    }
    if (!pieces.is_singular()) return sums.product();
    Expansion<V> result;
    result.length = sums.l.sum();
    result.energy = result.value = std::numeric_limits<double>::infinity();
    return result;
}

}  // namespace

Expansion<0> expand_value(const PseudoSegment& segment) { return expand<0>(segment); }
Expansion<2> expand_magnitudes(const PseudoSegment& segment) { return expand<2>(segment); }
Expansion<4> expand_all(const PseudoSegment& segment) { return expand<4>(segment); }

}  // namespace batten::pseudo
