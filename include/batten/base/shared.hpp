#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "batten/base/points.hpp"

namespace batten {

/// Numbers in memory that somebody keeps: copies share it. They should not change meanwhile: what is
/// worked out later sees what is there then.
class SharedNumbers {
public:
    SharedNumbers() = default;
    explicit SharedNumbers(std::vector<double> numbers) {
        const auto owned = std::make_shared<const std::vector<double>>(std::move(numbers));
        numbers_ = *owned;
        owner_ = owned;
    }
    /// `owner` keeps the memory of `numbers`.
    SharedNumbers(std::span<const double> numbers, std::shared_ptr<const void> owner)
        : numbers_(numbers), owner_(std::move(owner)) {}

    std::size_t size() const { return numbers_.size(); }
    bool empty() const { return numbers_.empty(); }
    double operator[](std::size_t i) const { return numbers_[i]; }
    std::span<const double> view() const { return numbers_; }
    operator std::span<const double>() const { return numbers_; }
    const std::shared_ptr<const void>& owner() const { return owner_; }

private:
    std::span<const double> numbers_;
    std::shared_ptr<const void> owner_;
};

/// n rows of dim coordinates, kept in the same way.
class SharedPoints {
public:
    explicit SharedPoints(Points points) {
        const auto owned = std::make_shared<const Points>(std::move(points));
        points_ = *owned;
        owner_ = owned;
    }
    /// `owner` keeps the memory of `points`.
    SharedPoints(PointsView points, std::shared_ptr<const void> owner)
        : points_(points), owner_(std::move(owner)) {}

    PointsView view() const { return points_; }
    operator PointsView() const { return points_; }
    std::size_t size() const { return points_.size(); }
    int dim() const { return points_.dim(); }
    const std::shared_ptr<const void>& owner() const { return owner_; }

private:
    PointsView points_;
    std::shared_ptr<const void> owner_;
};

}  // namespace batten
