#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace batten {

/// n rows of dim coordinates, contiguous, borrowed: valid while the owner lives.
class PointsView {
public:
    PointsView() = default;
    PointsView(const double* data, std::size_t rows, int dim)
        : data_(data), rows_(rows), dim_(dim) {}

    std::size_t size() const { return rows_; }
    bool empty() const { return rows_ == 0; }
    int dim() const { return dim_; }
    std::span<const double> operator[](std::size_t row) const {
        return {data_ + row * static_cast<std::size_t>(dim_), static_cast<std::size_t>(dim_)};
    }
    double operator()(std::size_t row, int column) const {
        return data_[row * static_cast<std::size_t>(dim_) + static_cast<std::size_t>(column)];
    }
    std::span<const double> coordinates() const {
        return {data_, rows_ * static_cast<std::size_t>(dim_)};
    }
    PointsView part(std::size_t first, std::size_t count) const {
        return {data_ + first * static_cast<std::size_t>(dim_), count, dim_};
    }

private:
    const double* data_ = nullptr;
    std::size_t rows_ = 0;
    int dim_ = 2;
};

/// n rows of dim coordinates, contiguous, owned.
class Points {
public:
    explicit Points(int dim = 2) : dim_(dim) {}
    Points(std::size_t rows, int dim)
        : values_(rows * static_cast<std::size_t>(dim)), dim_(dim) {}
    /// `coordinates` row after row; its size must be a multiple of `dim`.
    Points(std::vector<double> coordinates, int dim);
    explicit Points(PointsView view);

    std::size_t size() const { return values_.size() / static_cast<std::size_t>(dim_); }
    bool empty() const { return values_.empty(); }
    int dim() const { return dim_; }
    void reserve(std::size_t rows) { values_.reserve(rows * static_cast<std::size_t>(dim_)); }
    void push_back(std::span<const double> row);

    std::span<double> operator[](std::size_t row) {
        return {values_.data() + row * static_cast<std::size_t>(dim_),
                static_cast<std::size_t>(dim_)};
    }
    std::span<const double> operator[](std::size_t row) const { return view()[row]; }
    double& operator()(std::size_t row, int column) {
        return values_[row * static_cast<std::size_t>(dim_) + static_cast<std::size_t>(column)];
    }
    double operator()(std::size_t row, int column) const { return view()(row, column); }
    std::span<double> coordinates() { return values_; }
    std::span<const double> coordinates() const { return values_; }

    PointsView view() const { return {values_.data(), size(), dim_}; }
    operator PointsView() const { return view(); }
    bool operator==(const Points&) const = default;

private:
    std::vector<double> values_;
    int dim_ = 2;
};

/// The longest side of the points' bounding box; 0 for one point or none.
double extent(PointsView points);

/// Throws `points.not-finite` with the row (from 0) and column of the first offender.
void require_finite(PointsView points);

/// Throws `points.too-few` unless there are at least `count` rows.
void require_count(PointsView points, std::size_t count);

/// Throws `points.repeated` where two consecutive rows are equal (with `closed`, also last and
/// first), or `points.all-equal` where all of them are.
void require_distinct(PointsView points, bool closed);

/// Throws `points.dimension` unless the points have between `lowest` and `highest` coordinates.
void require_dimension(PointsView points, int lowest, int highest);

}  // namespace batten
