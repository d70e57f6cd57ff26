#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace batten {

/// The value and the first `order()` derivatives of a curve at one parameter.
///
/// Up to 16 numbers (order 3 in space of 4 dimensions) are held without allocation.
class Jet {
public:
    Jet(int dim, int order);

    int dim() const { return dim_; }
    int order() const { return order_; }
    /// Derivative number `k`, 0 being the value itself: dim numbers.
    std::span<const double> operator[](int k) const { return values().subspan(offset(k), width()); }
    std::span<double> operator[](int k) { return values().subspan(offset(k), width()); }
    /// All (order + 1) x dim numbers, derivative after derivative.
    std::span<double> values();
    std::span<const double> values() const;

private:
    std::size_t width() const { return static_cast<std::size_t>(dim_); }
    std::size_t offset(int k) const { return static_cast<std::size_t>(k * dim_); }

    int dim_, order_;
    std::array<double, 16> few_{};
    std::vector<double> many_;
};

}  // namespace batten
