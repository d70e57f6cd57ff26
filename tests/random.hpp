#pragma once

#include <cstdint>
#include <random>

#include "batten/base/points.hpp"

namespace batten::testing {

/// Random numbers that are the same with every standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double within(double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    /// A whole number in lo ... hi.
    int whole(int lo, int hi) {
        return lo + static_cast<int>(engine_() % static_cast<std::uint64_t>(hi - lo + 1));
    }
    /// Points in the cube [-1, 1]^dim.
    Points points(std::size_t rows, int dim) {
        Points result(rows, dim);
        for (double& x : result.coordinates()) x = within(-1, 1);
        return result;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace batten::testing
