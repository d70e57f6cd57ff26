#include "make/fit/normals.hpp"

#include <cmath>
#include <cstddef>

namespace batten::fitting {
namespace {

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector unit(Vector v) {
    const double size = std::sqrt(inner(v, v));
    for (double& x : v) x = size > 0 ? x / size : 0;
    return v;
}

}  // namespace

double inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

std::array<Vector, 2> normals_of(const Vector& tangent, int dim) {
    std::size_t smallest = 2;
    for (std::size_t i = 0; i < 2 && dim == 3; ++i) {
        if (std::fabs(tangent[i]) < std::fabs(tangent[smallest])) smallest = i;
    }
    Vector axis{};
    axis[smallest] = 1;
    const Vector first = unit(cross(axis, tangent));
    return {first, dim == 3 ? unit(cross(tangent, first)) : Vector{}};
}

}  // namespace batten::fitting
