#include "num/patch_kernel.hpp"

#include <cassert>

namespace batten::patches {
namespace {

template <int Width, int Height, int Count>
Outputs horner(const double* c, double u, double v) {
    double rows[Width][Count];
    for (int i = 0; i < Width; ++i) {
        const double* const row = c + i * Height * Count;
        for (int k = 0; k < Count; ++k) rows[i][k] = row[(Height - 1) * Count + k];
        for (int j = Height - 1; j-- > 0;) {
            for (int k = 0; k < Count; ++k) rows[i][k] = rows[i][k] * v + row[j * Count + k];
        }
    }
    Outputs out{};
    for (int k = 0; k < Count; ++k) out[static_cast<std::size_t>(k)] = rows[Width - 1][k];
    for (int i = Width - 1; i-- > 0;) {
        for (int k = 0; k < Count; ++k) {
            double& o = out[static_cast<std::size_t>(k)];
            o = o * u + rows[i][k];
        }
    }
    return out;
}

}  // namespace

Outputs polynomial(const Shape& shape, const double* c, double u, double v) {
    if (shape.outputs == 4) {
        if (shape.width == 12) return horner<12, 12, 4>(c, u, v);
        if (shape.width == 10) return horner<10, 10, 4>(c, u, v);
    }
    if (shape.height == 1) return horner<12, 1, 2>(c, u, v);
    assert(shape.width == 10 && shape.height == 10 && shape.outputs == 2);
    return horner<10, 10, 2>(c, u, v);
}

}  // namespace batten::patches
