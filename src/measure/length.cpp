#include "batten/measure/length.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/measure/centroid.hpp"
#include "batten/shape/piecewise_cubic.hpp"
#include "measure/arc/cubic_lengths.hpp"
#include "measure/lengths.hpp"
#include "num/gauss.hpp"
#include "num/sum.hpp"

namespace batten {
namespace bezier {
namespace {

/// A stretch has fewer panels than this unless it nears a cusp, and then most of them have errors
/// far below what they may have.
constexpr double panels_expected = 64;

double sum_over(const Panel& panel, int nodes, const auto& factor) {
    const num::GaussRule rule = num::gauss_legendre(nodes);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double x = rule.nodes[i];
        sum += rule.weights[i] * panel.speed(x) * factor(x);
    }
    return panel.half * sum;
}

/// How much a followed piece's length may differ from the curve's, which to first order is
/// int n . (distance) kappa ds; the turning is bounded by the variation of the hodograph.
double following_error(const Motion& motion, const Stretch& stretch) {
    const double defect = motion.pieces.defect(stretch.piece);
    if (defect == 0) return 0;
    double variation = 0, mean = 0;
    for (int k = 0; k < stretch.dim; ++k) {
        double change = 0, sum = 0;
        const bernstein::View c = stretch.coordinate(k);
        for (std::size_t j = 0; j < c.size(); ++j) {
            sum += c[j] / static_cast<double>(c.size());
            if (j > 0) change += std::fabs(c[j] - c[j - 1]);
        }
        variation = std::hypot(variation, change);
        mean = std::hypot(mean, sum);
    }
    return defect * (variation < mean ? variation / mean : 4);
}

}  // namespace

std::vector<Measured> lengths(const Motion& motion, double tolerance) {
    std::vector<num::Sum> values(motion.pieces.curve().pieces()), errors(values.size());
    double polygon = 0;
    for (std::size_t i = 0; i < motion.pieces.size(); ++i) {
        polygon += polygon_length(motion.pieces, i);
    }
    for (const Stretch& stretch : motion.stretches) {
        const std::size_t source = motion.pieces.source(stretch.piece);
        const double share = polygon_length(motion.pieces, stretch.piece) / polygon;
        const double allowed = tolerance * share / panels_expected;
        for (const Panel& panel : motion.panels.for_length(stretch, allowed)) {
            values[source].add(sum_over(panel, panel.nodes, [](double) { return 1.0; }));
            errors[source].add(panel.error);
        }
        errors[source].add(following_error(motion, stretch));
    }
    std::vector<Measured> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i].value();
        const double rounding = value > 0 ? 0x1p-51 * value : 0;
        result.push_back({value, errors[i].value() + rounding});
    }
    return result;
}

Measured total(const std::vector<Measured>& parts) {
    num::Sum value, error;
    for (const Measured& part : parts) {
        value.add(part.value);
        error.add(part.error);
    }
    return {value.value(), error.value()};
}

std::vector<double> first_moment(const Motion& motion, double tolerance) {
    std::vector<num::Sum> sums(motion.pieces.dim());
    const double degrees = 0.5 * motion.pieces.degree();
    for (const Stretch& stretch : motion.stretches) {
        const double allowed =
            tolerance * polygon_length(motion.pieces, stretch.piece) / panels_expected;
        for (const Panel& panel : motion.panels.for_length(stretch, allowed)) {
            // r grows like rho^degree in the ellipse of the bound: that many nodes more.
            const int nodes = panel.nodes + static_cast<int>(std::ceil(degrees)) + 1;
            for (int k = 0; k < stretch.dim; ++k) {
                const bernstein::View r = motion.pieces.position(stretch.piece, k);
                sums[k].add(sum_over(panel, nodes, [&](double x) {
                    return bernstein::value(r, stretch.u_of(panel.w_of(x)));
                }));
            }
        }
    }
    std::vector<double> result;
    for (const num::Sum& sum : sums) result.push_back(sum.value());
    return result;
}

}  // namespace bezier

namespace {

std::vector<Measured> any_lengths(const Curve& curve, Tolerance tolerance) {
    const bezier::Motion motion(curve);
    std::vector<Measured> result = bezier::lengths(motion, motion.pieces.in_normal(tolerance));
    for (Measured& part : result) {
        part = {motion.pieces.in_data(part.value, 1), motion.pieces.in_data(part.error, 1)};
    }
    return result;
}

/// Some pieces of a curve, over 0, 1, 2, ..., whether or not they meet.
struct SomePieces {
    Curve whole;
    std::vector<std::size_t> which;
    std::vector<double> joints;

    int dim() const { return whole.dim(); }
    std::span<const double> breaks() const { return joints; }
    bool is_closed() const { return false; }
    std::optional<int> degree() const { return whole.degree(); }
    void jets_on(std::size_t piece, std::span<const double> u, int order,
                 std::span<double> out) const {
        const Interval part = whole.piece(which[piece]);
        const std::size_t dim = static_cast<std::size_t>(whole.dim());
        for (std::size_t i = 0; i < u.size(); ++i) {
            const double inside = u[i] - joints[piece];
            const double t = inside == 1 ? part.hi : part.lo + inside * part.length();
            const auto jet = out.subspan(i * dim * static_cast<std::size_t>(order + 1),
                                         dim * static_cast<std::size_t>(order + 1));
            whole.jets_on(which[piece], {&t, 1}, order, jet);
            double scale = 1;
            for (std::size_t k = 1; k <= static_cast<std::size_t>(order); ++k) {
                scale *= part.length();
                for (double& x : jet.subspan(k * dim, dim)) x *= scale;
            }
        }
    }
};

}  // namespace

std::vector<Measured> piece_lengths(const Curve& curve, Tolerance tolerance) {
    bezier::require_tolerance(tolerance);
    const auto* cubic = curve.shape<PiecewiseCubic>();
    if (!cubic) return any_lengths(curve, tolerance);
    const Tolerance half{0.5 * tolerance.value, tolerance.is_relative};
    arc::CubicLengths plain = arc::cubic_lengths(*cubic, half);
    if (plain.left_out.empty()) return std::move(plain.pieces);
    if (plain.left_out.size() == curve.pieces()) return any_lengths(curve, tolerance);
    std::vector<double> joints;
    for (std::size_t i = 0; i <= plain.left_out.size(); ++i) {
        joints.push_back(static_cast<double>(i));
    }
    const std::vector<Measured> rest = any_lengths(SomePieces{curve, plain.left_out, joints}, half);
    for (std::size_t i = 0; i < rest.size(); ++i) plain.pieces[plain.left_out[i]] = rest[i];
    return std::move(plain.pieces);
}

Measured length(const Curve& curve, Tolerance tolerance) {
    return bezier::total(piece_lengths(curve, tolerance));
}

Measured length(const Curve& curve, Interval part, Tolerance tolerance) {
    if (part.lo == part.hi && curve.domain().contains(part.lo)) return {};
    return length(trimmed(curve, part), tolerance);
}

std::vector<double> centroid(const Curve& curve, Tolerance tolerance) {
    bezier::require_tolerance(tolerance);
    const bezier::Motion motion(curve);
    const double allowed = motion.pieces.in_normal(tolerance);
    const double length = bezier::total(bezier::lengths(motion, allowed)).value;
    std::vector<double> moment = bezier::first_moment(motion, allowed);
    for (double& x : moment) x = length > 0 ? x / length : 0;
    return motion.pieces.to_data(moment);
}

}  // namespace batten
