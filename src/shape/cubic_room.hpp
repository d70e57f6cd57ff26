#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "batten/shape/piecewise_cubic.hpp"

namespace batten::cubics {

/// Memory for a large piecewise cubic, not written yet: breaks and coefficients in one block, which
/// becomes the curve without being copied or looked at again.
class Room {
public:
    Room(std::size_t joints, int dim);

    std::span<double> breaks() const { return {numbers_.get(), joints_}; }
    /// As PiecewiseCubic::power takes them; all of it is to be written, entries n of powers 1 to 3
    /// with zeros.
    std::span<double> block() const {
        return {numbers_.get() + joints_, 4 * static_cast<std::size_t>(dim_) * joints_};
    }
    /// Requires: at least two breaks, strictly increasing; no number beyond a double.
    PiecewiseCubic curve(bool closed) const {
        return PiecewiseCubic(numbers_, breaks(), block(), dim_, closed);
    }

private:
    std::size_t joints_;
    int dim_;
    std::shared_ptr<double[]> numbers_;
};

}  // namespace batten::cubics
