#include "measure/bezier/bend.hpp"

#include <cmath>

namespace batten::bezier {

bool Bend::is_straight() const {
    for (const bernstein::Coefficients& minor : minors) {
        if (bernstein::bound(minor) > noise) return false;
    }
    return true;
}

double Bend::size_sq(double w) const {
    double sum = 0;
    for (const bernstein::Coefficients& minor : minors) {
        const double x = bernstein::value(minor, w);
        sum += x * x;
    }
    return sum;
}

Bend bend_of(const Pieces& pieces, const Stretch& stretch) {
    Bend result;
    double size = 0;
    std::vector<bernstein::Coefficients> slopes;
    for (int k = 0; k < stretch.dim; ++k) {
        size = std::fmax(size, bernstein::bound(stretch.coordinate(k)));
        slopes.push_back(bernstein::derivative(stretch.coordinate(k)));
    }
    for (int i = 0; i < stretch.dim; ++i) {
        for (int j = i + 1; j < stretch.dim; ++j) {
            result.minors.push_back(bernstein::combination(
                bernstein::product(stretch.coordinate(i), slopes[j]), -1,
                bernstein::product(stretch.coordinate(j), slopes[i])));
        }
    }
    // Each end of the hodograph moves with the coordinates; the second derivative of a followed
    // piece is known to about 30 times its distance.
    result.noise = size * (0x1p-48 * size + 4 * pieces.rounding() +
                           64 * pieces.defect(stretch.piece));
    return result;
}

std::optional<Bend> without_zeros(Bend bend, int at_start, int at_end) {
    if (bend.is_straight()) return bend;
    for (bernstein::Coefficients& minor : bend.minors) {
        for (int i = 0; i < at_start; ++i) {
            if (std::fabs(minor[0]) > bend.noise) return std::nullopt;
            if (minor.size() > 1) minor = bernstein::without_zero_at_start(minor);
        }
        for (int i = 0; i < at_end; ++i) {
            if (std::fabs(minor[minor.size() - 1]) > bend.noise) return std::nullopt;
            if (minor.size() > 1) minor = bernstein::without_zero_at_end(minor);
        }
    }
    return bend;
}

}  // namespace batten::bezier
