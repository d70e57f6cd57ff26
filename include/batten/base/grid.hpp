#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace batten {

/// nu x nv nodes of dim values, contiguous (v fastest, then the values of a node), borrowed.
/// `mask` is empty, or holds one byte a node: 0 where the node is missing.
class GridView {
public:
    GridView() = default;
    GridView(const double* data, std::size_t nu, std::size_t nv, int dim,
             std::span<const std::uint8_t> mask = {})
        : data_(data), nu_(nu), nv_(nv), dim_(dim), mask_(mask) {}

    std::size_t nu() const { return nu_; }
    std::size_t nv() const { return nv_; }
    int dim() const { return dim_; }
    double operator()(std::size_t i, std::size_t j, int k = 0) const {
        return data_[(i * nv_ + j) * static_cast<std::size_t>(dim_) + static_cast<std::size_t>(k)];
    }
    bool has(std::size_t i, std::size_t j) const {
        return mask_.empty() || mask_[i * nv_ + j] != 0;
    }
    /// Whether nodes may be missing.
    bool has_mask() const { return !mask_.empty(); }
    std::span<const double> values() const {
        return {data_, nu_ * nv_ * static_cast<std::size_t>(dim_)};
    }

private:
    const double* data_ = nullptr;
    std::size_t nu_ = 0, nv_ = 0;
    int dim_ = 1;
    std::span<const std::uint8_t> mask_;
};

/// nu x nv nodes of dim values, owned. A missing node is a mask entry, never a NaN.
class Grid {
public:
    Grid(std::size_t nu, std::size_t nv, int dim = 1)
        : values_(nu * nv * static_cast<std::size_t>(dim)), nu_(nu), nv_(nv), dim_(dim) {}

    /// Takes over nu x nv x dim values, the last index fastest.
    Grid(std::vector<double> values, std::size_t nu, std::size_t nv, int dim = 1)
        : values_(std::move(values)), nu_(nu), nv_(nv), dim_(dim) {}

    std::size_t nu() const { return nu_; }
    std::size_t nv() const { return nv_; }
    int dim() const { return dim_; }
    double& operator()(std::size_t i, std::size_t j, int k = 0) {
        return values_[(i * nv_ + j) * static_cast<std::size_t>(dim_) +
                       static_cast<std::size_t>(k)];
    }
    double operator()(std::size_t i, std::size_t j, int k = 0) const { return view()(i, j, k); }
    bool has(std::size_t i, std::size_t j) const { return view().has(i, j); }

    /// Declares node (i, j) missing; its values become 0.
    void drop(std::size_t i, std::size_t j) {
        if (mask_.empty()) mask_.assign(nu_ * nv_, 1);
        mask_[i * nv_ + j] = 0;
        for (int k = 0; k < dim_; ++k) (*this)(i, j, k) = 0;
    }
    std::size_t missing() const {
        std::size_t count = 0;
        for (const std::uint8_t present : mask_) count += present == 0;
        return count;
    }

    GridView view() const { return {values_.data(), nu_, nv_, dim_, mask_}; }
    operator GridView() const { return view(); }

private:
    std::vector<double> values_;
    std::size_t nu_, nv_;
    int dim_;
    std::vector<std::uint8_t> mask_;
};

}  // namespace batten
