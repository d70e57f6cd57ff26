#include "batten/shape/piecewise_cubic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <memory>
#include <utility>

#include "base/memory.hpp"
#include "batten/base/error.hpp"
#include "shape/breaks.hpp"
#include "shape/cubic_room.hpp"

namespace batten {
namespace {

/// Without a branch a number: adding one to an exponent of all ones carries into the sign's place.
bool all_finite(std::span<const double> numbers) {
    constexpr std::uint64_t exponent = 0x7ff0000000000000, one = 0x0010000000000000;
    constexpr std::size_t lanes = 8;
    std::uint64_t carried[lanes] = {};
    const auto look_at = [&](std::size_t i, std::size_t lane) {
        std::uint64_t bits;
        std::memcpy(&bits, &numbers[i], sizeof bits);
        carried[lane] |= (bits & exponent) + one;
    };
    std::size_t i = 0;
    for (; i + lanes <= numbers.size(); i += lanes) {
        for (std::size_t lane = 0; lane < lanes; ++lane) look_at(i + lane, lane);
    }
    for (; i < numbers.size(); ++i) look_at(i, 0);
    for (const std::uint64_t lane : carried) carried[0] |= lane;
    return carried[0] >> 63 == 0;
}

struct Numbers {
    std::vector<double> block, breaks;
};

}  // namespace

PiecewiseCubic::PiecewiseCubic(std::vector<double> block, int dim, std::vector<double> breaks,
                               bool closed)
    : dim_(dim), closed_(closed) {
    const auto owned = std::make_shared<const Numbers>(Numbers{std::move(block), std::move(breaks)});
    block_ = owned->block;
    breaks_ = owned->breaks;
    owner_ = owned;
    knots::require_breaks(breaks_);
    if (dim < 1 || block_.size() != 4 * static_cast<std::size_t>(dim) * breaks_.size()) {
        throw Error("curve.coefficients", "coefficients", std::to_string(block_.size()),
                    "4 x dimension x breaks numbers are needed");
    }
    if (all_finite(block_)) return;
    const auto is_not_finite = [](double x) { return !std::isfinite(x); };
    const auto first = std::find_if(block_.begin(), block_.end(), is_not_finite);
    const std::size_t piece = static_cast<std::size_t>(first - block_.begin()) % breaks_.size();
    throw Error("number.overflow", "coefficient of piece " + std::to_string(piece),
                "beyond a double", "scale the points down or spread them out");
}

bool PiecewiseCubic::operator==(const PiecewiseCubic& other) const {
    return dim_ == other.dim_ && closed_ == other.closed_ &&
           std::equal(breaks_.begin(), breaks_.end(), other.breaks_.begin(),
                      other.breaks_.end()) &&
           std::equal(block_.begin(), block_.end(), other.block_.begin(), other.block_.end());
}

PiecewiseCubic PiecewiseCubic::power(std::vector<double> block, int dim,
                                     std::vector<double> breaks, bool closed) {
    return {std::move(block), dim, std::move(breaks), closed};
}

PiecewiseCubic PiecewiseCubic::hermite(PointsView points, PointsView start, PointsView end,
                                       std::vector<double> breaks, bool closed) {
    knots::require_breaks(breaks);
    const std::size_t joints = breaks.size();
    const int dim = points.dim();
    if (points.size() != joints || start.size() + 1 != joints || end.size() + 1 != joints) {
        throw Error("curve.coefficients", "points", std::to_string(points.size()),
                    "as many points as breaks and one derivative pair a piece are needed");
    }
    std::vector<double> block(4 * static_cast<std::size_t>(dim) * joints, 0.0);
    for (int k = 0; k < dim; ++k) {
        const auto column = [&](int power) {
            return block.data() + static_cast<std::size_t>(power * dim + k) * joints;
        };
        for (std::size_t i = 0; i < joints; ++i) column(0)[i] = points(i, k);
        for (std::size_t i = 0; i + 1 < joints; ++i) {
            const double h = breaks[i + 1] - breaks[i];
            const double slope = (points(i + 1, k) - points(i, k)) / h;
            const double d0 = start(i, k), d1 = end(i, k);
            column(1)[i] = d0;
            column(2)[i] = (2 * (slope - d0) + (slope - d1)) / h;
            column(3)[i] = ((d0 - slope) + (d1 - slope)) / (h * h);
        }
    }
    return {std::move(block), dim, std::move(breaks), closed};
}

std::span<const double> PiecewiseCubic::coefficients(int power, int coordinate) const {
    const std::size_t joints = breaks_.size();
    const std::size_t column = static_cast<std::size_t>(power * dim_ + coordinate);
    return {block_.data() + column * joints, power == 0 ? joints : joints - 1};
}

Points PiecewiseCubic::joints() const {
    Points result(breaks_.size(), dim_);
    for (int k = 0; k < dim_; ++k) {
        const std::span<const double> column = coefficients(0, k);
        for (std::size_t i = 0; i < column.size(); ++i) result(i, k) = column[i];
    }
    return result;
}

void PiecewiseCubic::jets_on(std::size_t piece, std::span<const double> t, int order,
                             std::span<double> out) const {
    const std::size_t joints = breaks_.size();
    const std::size_t dim = static_cast<std::size_t>(dim_);
    const std::size_t width = dim * static_cast<std::size_t>(order + 1);
    for (std::size_t i = 0; i < t.size(); ++i) {
        const double u = t[i] - breaks_[piece];
        const bool at_end = t[i] == breaks_[piece + 1];
        double* const row = out.data() + i * width;
        for (std::size_t k = 0; k < dim; ++k) {
            const auto c = [&](std::size_t power) {
                return block_[(power * dim + k) * joints + piece];
            };
            const double c1 = c(1), c2 = c(2), c3 = c(3);
            row[k] = at_end ? block_[k * joints + piece + 1]
                            : c(0) + u * (c1 + u * (c2 + u * c3));
            if (order > 0) row[dim + k] = c1 + u * (2 * c2 + u * 3 * c3);
            if (order > 1) row[2 * dim + k] = 2 * c2 + u * 6 * c3;
            if (order > 2) row[3 * dim + k] = 6 * c3;
            for (std::size_t d = 4; d <= static_cast<std::size_t>(order); ++d) {
                row[d * dim + k] = 0;
            }
        }
    }
}

}  // namespace batten

namespace batten::cubics {

Room::Room(std::size_t joints, int dim)
    : joints_(joints),
      dim_(dim),
      numbers_(memory::unwritten_numbers((4 * static_cast<std::size_t>(dim) + 1) * joints)) {}

}  // namespace batten::cubics
