#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/shape/bspline.hpp"
#include "shape/knots.hpp"

namespace batten {
namespace {

/// Control points with their weight as one coordinate more where the curve is rational.
Points homogeneous(const BSplineCurve& curve) {
    if (!curve.is_rational()) return Points(curve.control_points());
    Points result(curve.control_points().size(), curve.dim() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double weight = curve.weights()[i];
        for (int k = 0; k < curve.dim(); ++k) {
            result(i, k) = weight * curve.control_points()(i, k);
        }
        result(i, curve.dim()) = weight;
    }
    return result;
}

BSplineCurve from_homogeneous(BSplineBasis basis, const Points& rows, const BSplineCurve& like) {
    if (!like.is_rational()) return {std::move(basis), rows};
    Points points(rows.size(), like.dim());
    std::vector<double> weights(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        weights[i] = rows(i, like.dim());
        for (int k = 0; k < like.dim(); ++k) points(i, k) = rows(i, k) / weights[i];
    }
    return {std::move(basis), std::move(points), std::move(weights)};
}

/// `curve` with every control point of `old` that function j keeps: kept[j], or none.
BSplineCurve with_kept(const BSplineCurve& curve, const BSplineCurve& old,
                       std::span<const std::optional<std::size_t>> kept) {
    Points points(curve.control_points());
    std::vector<double> weights(curve.weights().begin(), curve.weights().end());
    for (std::size_t j = 0; j < kept.size(); ++j) {
        if (!kept[j]) continue;
        const std::span<const double> point = old.control_points()[*kept[j]];
        std::copy(point.begin(), point.end(), points[j].begin());
        if (old.is_rational()) weights[j] = old.weights()[*kept[j]];
    }
    return {curve.basis(), std::move(points), std::move(weights)};
}

/// The polynomial pieces of a curve as symmetric functions of `degree` parameters each, affine in
/// every one of them [Ramshaw1989].
class Blossom {
public:
    explicit Blossom(const BSplineCurve& curve)
        : basis_(curve.basis()), rows_(homogeneous(curve)), work_(functions() * width()) {}

    const Points& rows() const { return rows_; }

    /// The value of the piece on `span` at `arguments`; valid until the next call.
    std::span<const double> operator()(std::size_t span, std::span<const double> arguments) {
        const std::size_t degree = functions() - 1;
        const double* const u = basis_.knots().data() + (span - degree);
        for (std::size_t j = 0; j <= degree; ++j) {
            const auto row = rows_[basis_.control(span, static_cast<int>(j))];
            std::copy(row.begin(), row.end(), work_.begin() + j * width());
        }
        for (std::size_t r = 1; r <= degree; ++r) {
            for (std::size_t j = degree; j >= r; --j) {
                const double lo = u[j], hi = u[j + degree - r + 1];
                const double left = (hi - arguments[r - 1]) / (hi - lo);
                const double right = (arguments[r - 1] - lo) / (hi - lo);
                for (std::size_t k = 0; k < width(); ++k) {
                    double& value = work_[j * width() + k];
                    value = left * work_[(j - 1) * width() + k] + right * value;
                }
            }
        }
        return std::span<const double>(work_).subspan(degree * width());
    }

private:
    std::size_t functions() const { return static_cast<std::size_t>(basis_.degree()) + 1; }
    std::size_t width() const { return static_cast<std::size_t>(rows_.dim()); }

    BSplineBasis basis_;
    Points rows_;
    std::vector<double> work_;
};

/// The function of `basis` whose inner knots are exactly `knots`, if there is one.
std::optional<std::size_t> function_with(const BSplineBasis& basis, std::span<const double> knots) {
    const std::span<const double> all = basis.knots();
    auto first = std::lower_bound(all.begin() + 1, all.end(), knots.front());
    for (; first != all.end() && *first == knots.front(); ++first) {
        if (static_cast<std::size_t>(all.end() - first) <= knots.size()) return std::nullopt;
        if (std::equal(knots.begin(), knots.end(), first)) {
            const std::size_t j = static_cast<std::size_t>(first - all.begin()) - 1;
            return basis.is_periodic() ? j % basis.size() : j;
        }
    }
    return std::nullopt;
}

/// The span of `old` around the widest span of function j.
std::size_t span_around(const BSplineBasis& basis, std::size_t j, const BSplineBasis& old) {
    const std::size_t at = knots::widest_span(basis, j);
    return old.span_of(Interval{basis.knots()[at], basis.knots()[at + 1]}.middle());
}

BSplineCurve elevate_once(const BSplineCurve& curve) {
    const BSplineBasis& old = curve.basis();
    std::vector<double> list;
    for (const double knot : knots::list_of(old)) {
        const bool is_fresh = list.empty() || list.back() != knot;
        list.insert(list.end(), is_fresh ? 2 : 1, knot);
    }
    if (old.is_periodic()) list.pop_back();
    BSplineBasis basis = knots::basis_over(std::move(list), old.degree() + 1, old.is_periodic());
    Blossom blossom(curve);
    Points rows(basis.size(), blossom.rows().dim());
    const std::size_t count = static_cast<std::size_t>(basis.degree());
    std::vector<double> others(count - 1);
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const std::size_t span = span_around(basis, j, old);
        const std::span<const double> arguments = basis.knots().subspan(j + 1, count);
        for (std::size_t i = 0, same = 0; i < count; i += same) {
            same = 1;  // equal arguments are left out one for all
            while (i + same < count && arguments[i + same] == arguments[i]) ++same;
            std::copy(arguments.begin() + i + 1, arguments.end(),
                      std::copy(arguments.begin(), arguments.begin() + i, others.begin()));
            const std::span<const double> value = blossom(span, others);
            const double share = static_cast<double>(same) / static_cast<double>(count);
            for (std::size_t k = 0; k < value.size(); ++k) rows[j][k] += share * value[k];
        }
    }
    return from_homogeneous(std::move(basis), rows, curve);
}

}  // namespace

BSplineCurve insert_knots(const BSplineCurve& curve, std::span<const double> knots) {
    const BSplineBasis& old = curve.basis();
    const Interval domain = old.domain();
    std::vector<double> list = knots::list_of(old);
    for (const double knot : knots) {
        const bool is_end = knot == domain.lo || knot == domain.hi;
        if (!domain.contains(knot) || (is_end && !curve.is_closed())) {
            throw Error("curve.outside", "knot", format_number(knot),
                        "must lie inside the curve's domain [" + format_number(domain.lo) + ", " +
                            format_number(domain.hi) + "]");
        }
        list.push_back(is_end ? domain.lo : knot);
    }
    std::sort(list.begin(), list.end());
    BSplineBasis basis = knots::basis_over(std::move(list), old.degree(), curve.is_closed());
    Blossom blossom(curve);
    Points rows(basis.size(), blossom.rows().dim());
    std::vector<std::optional<std::size_t>> kept(rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const std::span<const double> arguments =
            basis.knots().subspan(j + 1, static_cast<std::size_t>(basis.degree()));
        kept[j] = function_with(old, arguments);
        const std::span<const double> value = blossom(span_around(basis, j, old), arguments);
        std::copy(value.begin(), value.end(), rows[j].begin());
    }
    return with_kept(from_homogeneous(std::move(basis), rows, curve), curve, kept);
}

BSplineCurve elevate_degree(const BSplineCurve& curve, int by) {
    if (by < 1 || curve.basis().degree() + by > BSplineBasis::most_degree) {
        throw Error("bspline.degree", "degree raised by", std::to_string(by),
                    "at least 1, and to at most " + std::to_string(BSplineBasis::most_degree));
    }
    BSplineCurve result = elevate_once(curve);
    for (int i = 1; i < by; ++i) result = elevate_once(result);
    return result;
}

}  // namespace batten
