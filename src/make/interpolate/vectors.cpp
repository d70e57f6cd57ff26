#include "make/interpolate/vectors.hpp"

#include <algorithm>
#include <cmath>

#include "make/interpolate/chords.hpp"

namespace batten::interpolation {

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

Vector direction(std::span<const double> a, std::span<const double> b) {
    Vector result(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) result[k] = b[k] - a[k];
    const double length = length_of(result);
    if (length == 0) return result;
    for (double& x : result) x /= length;
    return result;
}

Vector mirrored(std::span<const double> vector, std::span<const double> axis) {
    const double along = 2 * dot(vector, axis);
    Vector result(vector.size());
    for (std::size_t k = 0; k < vector.size(); ++k) result[k] = along * axis[k] - vector[k];
    return result;
}

Vector across(std::span<const double> direction) {
    if (direction.size() == 2) return {-direction[1], direction[0]};
    std::size_t least = 0;
    for (std::size_t k = 1; k < direction.size(); ++k) {
        if (std::fabs(direction[k]) < std::fabs(direction[least])) least = k;
    }
    Vector result(direction.size());
    for (std::size_t k = 0; k < direction.size(); ++k) {
        result[k] = (k == least ? 1 : 0) - direction[least] * direction[k];
    }
    const double length = length_of(result);
    for (double& x : result) x /= length;
    return result;
}

bool is_zero(std::span<const double> vector) {
    return std::all_of(vector.begin(), vector.end(), [](double x) { return x == 0; });
}

}  // namespace batten::interpolation
