#include "batten/shape/transform.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/spline_graph.hpp"

namespace batten {
namespace {

struct ReversedCurve {
    explicit ReversedCurve(Curve c) : original(std::move(c)) {
        const Interval domain = original.domain();
        const std::span<const double> forward = original.breaks();
        joints.push_back(domain.lo);
        for (std::size_t i = forward.size() - 1; i-- > 1;) joints.push_back(mirrored(forward[i]));
        joints.push_back(domain.hi);
    }

    double mirrored(double t) const {
        const Interval domain = original.domain();
        return domain.lo + (domain.hi - t);
    }
    int dim() const { return original.dim(); }
    std::span<const double> breaks() const { return joints; }
    bool is_closed() const { return original.is_closed(); }
    std::optional<int> degree() const { return original.degree(); }

    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        const std::size_t source = original.pieces() - 1 - piece;
        const Interval span = original.piece(source);
        const std::size_t dim_size = static_cast<std::size_t>(dim());
        const std::size_t width = dim_size * static_cast<std::size_t>(order + 1);
        for (std::size_t i = 0; i < t.size(); ++i) {
            // The mirrored break can miss the original one by a rounding: ends stay ends.
            double u = mirrored(t[i]);
            if (t[i] == joints[piece]) u = span.hi;
            if (t[i] == joints[piece + 1]) u = span.lo;
            const std::span<double> row = out.subspan(i * width, width);
            original.jets_on(source, {&u, 1}, order, row);
            for (std::size_t j = 0; j < width; ++j) {
                if (j / dim_size % 2 == 1) row[j] = -row[j];
            }
        }
    }

    Curve original;
    std::vector<double> joints;
};

struct ScaledCurve {
    Curve original;
    double factor;

    int dim() const { return original.dim(); }
    std::span<const double> breaks() const { return original.breaks(); }
    bool is_closed() const { return original.is_closed(); }
    std::optional<int> degree() const { return original.degree(); }
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const {
        original.jets_on(piece, t, order, out);
        const std::size_t count = t.size() * static_cast<std::size_t>((order + 1) * dim());
        for (double& x : out.first(count)) x *= factor;
    }
};

}  // namespace

Curve reversed(const Curve& curve) { return ReversedCurve(curve); }

Curve scaled(const Curve& curve, double factor) {
    if (!std::isfinite(factor) || factor == 0) {
        throw Error("curve.scale", "scale", format_number(factor), "must be finite and not 0");
    }
    return ScaledCurve{curve, factor};
}

std::optional<PiecewiseCubic> exact_cubic(const Curve& curve) {
    if (const PiecewiseCubic* same = curve.shape<PiecewiseCubic>()) return *same;
    if (!curve.degree() || *curve.degree() > 3 || has_jumps(curve)) return std::nullopt;
    const std::span<const double> breaks = curve.breaks();
    const std::size_t joints = breaks.size();
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    constexpr double factorial[] = {1, 1, 2, 6};
    std::vector<double> block(4 * dim * joints, 0.0);
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        const Jet start = curve.jet_on(i, breaks[i], 3);
        for (std::size_t j = 0; j < 4 * dim; ++j) {
            block[j * joints + i] = start.values()[j] / factorial[j / dim];
        }
    }
    const Jet last = curve.jet_on(curve.pieces() - 1, breaks.back(), 0);
    for (std::size_t k = 0; k < dim; ++k) block[k * joints + joints - 1] = last[0][k];
    return PiecewiseCubic::power(std::move(block), curve.dim(), {breaks.begin(), breaks.end()},
                                 curve.is_closed());
}

std::optional<Points> exact_polyline(const Curve& curve) {
    if (const PiecewiseCubic* cubic = curve.shape<PiecewiseCubic>()) {
        for (int power = 2; power <= 3; ++power) {
            for (int k = 0; k < cubic->dim(); ++k) {
                const std::span<const double> c = cubic->coefficients(power, k);
                if (std::any_of(c.begin(), c.end(), [](double x) { return x != 0; })) {
                    return std::nullopt;
                }
            }
        }
        return Points(cubic->joints());
    }
    if (curve.degree() != 1) return std::nullopt;
    Points joints(0, curve.dim());
    for (std::size_t i = 0; i < curve.pieces(); ++i) {
        joints.push_back(curve.jet_on(i, curve.piece(i).lo, 0)[0]);
    }
    joints.push_back(curve.jet_on(curve.pieces() - 1, curve.domain().hi, 0)[0]);
    return joints;
}

}  // namespace batten
