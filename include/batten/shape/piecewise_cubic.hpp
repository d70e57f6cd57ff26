#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "batten/base/points.hpp"

namespace batten {

namespace cubics {
class Room;
}

/// Cubic pieces in any dimension, coefficients in structure-of-arrays form.
///
/// On piece i, with u = t - breaks()[i], coordinate k is
///     c0 + c1 u + c2 u^2 + c3 u^3,   cj = coefficients(j, k)[i].
/// c0 has one entry more than there are pieces: the last point. At the end of a piece the value is
/// the next piece's c0, so joints meet bit for bit and points given are points met.
///
/// Immutable; an invalid one cannot exist. Copies share the numbers.
class PiecewiseCubic {
public:
    /// From points and the one-sided derivatives at both ends of each piece.
    ///
    /// `points` n + 1 rows; `start`, `end` n rows: dP/dt where piece i starts and ends; `breaks`
    /// n + 1 increasing parameters. Throws `curve.breaks` where they do not increase,
    /// `number.overflow` where a coefficient is beyond a double.
    static PiecewiseCubic hermite(PointsView points, PointsView start, PointsView end,
                                  std::vector<double> breaks, bool closed);

    /// From power coefficients: `block[(j * dim + k) * (n + 1) + i]` is cj of coordinate k on piece
    /// i (entry n used for j = 0 only).
    static PiecewiseCubic power(std::vector<double> block, int dim, std::vector<double> breaks,
                                bool closed);

    int dim() const { return dim_; }
    std::span<const double> breaks() const { return breaks_; }
    std::size_t pieces() const { return breaks_.size() - 1; }
    bool is_closed() const { return closed_; }
    std::optional<int> degree() const { return 3; }
    std::span<const double> coefficients(int power, int coordinate) const;
    /// The n + 1 joints, one row each.
    Points joints() const;

    /// Value and derivatives on one piece; see `CurveShape`. Cost: 3 fused steps a number.
    void jets_on(std::size_t piece, std::span<const double> t, int order,
                 std::span<double> out) const;

    /// The same numbers.
    bool operator==(const PiecewiseCubic& other) const;

private:
    friend class cubics::Room;
    PiecewiseCubic(std::vector<double> block, int dim, std::vector<double> breaks, bool closed);
    PiecewiseCubic(std::shared_ptr<const void> owner, std::span<const double> breaks,
                   std::span<const double> block, int dim, bool closed)
        : owner_(std::move(owner)), breaks_(breaks), block_(block), dim_(dim), closed_(closed) {}

    std::shared_ptr<const void> owner_;
    std::span<const double> breaks_, block_;
    int dim_;
    bool closed_;
};

}  // namespace batten
