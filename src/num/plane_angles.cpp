#include "num/plane_angles.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "num/clones.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#define BATTEN_HAS_X86_LEVELS
#endif

namespace batten::num {
namespace {

using patches::Level;

constexpr double pi = 0x1.921fb54442d18p+1;
constexpr double half_pi = 0x1.921fb54442d18p+0, rest_of_half_pi = 0x1.1a62633145c07p-54;

template <std::size_t N>
BATTEN_INLINE double polynomial(const std::array<double, N>& c, double z) {
    double sum = c[N - 1];
    for (std::size_t k = N - 1; k-- > 0;) sum = sum * z + c[k];
    return sum;
}

// Through Chebyshev's nodes in z = q^2, worked out to 40 digits; largest error of the whole below
// 2e-17.
/// (atan(q) / q - 1) / z for |q| <= tan(pi / 8).
constexpr std::array<double, 11> arc_tangent{
    -0.3333333333333333,   0.19999999999995516, -0.14285714284665682, 0.11111111015187018,
    -0.0909090457530649,   0.07692183125376892, -0.06664510525508936, 0.05858140904866328,
    -0.050854078345894844, 0.03923044778479309, -0.019175404711104935};
/// (sin(q) / q - 1) / z and (cos(q) - 1 + z / 2) / z^2 for |q| <= pi / 4.
constexpr std::array<double, 6> sine_series{
    -0.16666666666666666,  0.008333333333330936,    -0.00019841269836740532,
    2.7557316093198404e-06, -2.5051129896450185e-08, 1.5917988979397435e-10};
constexpr std::array<double, 6> cosine_series{
    0.041666666666666664,   -0.0013888888888887389, 2.48015872987544e-05,
    -2.755731726587808e-07, 2.087614504941318e-09,  -1.138254464534925e-11};

BATTEN_INLINE double angle_inline(double x, double y) {
    constexpr double tangent_of_an_eighth = 0.41421356237309503;  // of pi
    const double ax = std::fabs(x), ay = std::fabs(y);
    const double large = std::max(ax, ay), small = std::min(ax, ay);
    // Factors of 0 and 1 instead of branches: so every compiler makes vectors of this.
    const double is_near_diagonal =
        0.5 - std::copysign(0.5, tangent_of_an_eighth * large - small);
    const double q = (small - is_near_diagonal * large) / (is_near_diagonal * small + large);
    const double z = q * q;
    const double part = q + q * (z * polynomial(arc_tangent, z));
    const double to_axis =
        0.5 * is_near_diagonal * half_pi + (part + 0.5 * is_near_diagonal * rest_of_half_pi);
    const double is_steep = 0.5 - std::copysign(0.5, ax - ay);
    const double to_x = is_steep * half_pi +
                        ((1 - 2 * is_steep) * to_axis + is_steep * rest_of_half_pi);
    const double is_behind = 0.5 - std::copysign(0.5, x + 0.0);
    const double size = is_behind * pi +
                        ((1 - 2 * is_behind) * to_x + 2 * is_behind * rest_of_half_pi);
    return std::copysign(size, y + 0.0);
}

BATTEN_INLINE void fill_angles_any(const double* x, const double* y, std::size_t count,
                                   double* angles) {
    for (std::size_t i = 0; i < count; ++i) angles[i] = angle_inline(x[i], y[i]);
}

BATTEN_INLINE void fill_directions_any(const double* angles, std::size_t count, double* cosines,
                                       double* sines) {
    for (std::size_t i = 0; i < count; ++i) {
        const double size = std::fabs(angles[i]);
        // Quarters away from the nearest multiple of a right angle.
        const double quarters = (size > 0.5 * half_pi ? 1.0 : 0.0) +
                                (size > 1.5 * half_pi ? 1.0 : 0.0) +
                                (size > 2.5 * half_pi ? 1.0 : 0.0);
        const double q = (size - quarters * half_pi) - quarters * rest_of_half_pi;
        const double z = q * q;
        const double s = q + q * (z * polynomial(sine_series, z));
        const double c = 1 - (0.5 * z - z * z * polynomial(cosine_series, z));
        const bool is_turned = quarters == 1 || quarters == 3;
        const double cosine = is_turned ? s : c, sine = is_turned ? c : s;
        cosines[i] = quarters == 1 || quarters == 2 ? -cosine : cosine;
        sines[i] = (quarters >= 2) != (angles[i] < 0) ? -sine : sine;
    }
}

#ifdef BATTEN_HAS_X86_LEVELS
__attribute__((target("avx2"))) void fill_angles_avx2(const double* x, const double* y,
                                                      std::size_t count, double* angles) {
    fill_angles_any(x, y, count, angles);
}
__attribute__((target("avx512f"))) void fill_angles_avx512(const double* x, const double* y,
                                                           std::size_t count, double* angles) {
    fill_angles_any(x, y, count, angles);
}
__attribute__((target("avx2"))) void fill_directions_avx2(const double* angles, std::size_t count,
                                                          double* cosines, double* sines) {
    fill_directions_any(angles, count, cosines, sines);
}
__attribute__((target("avx512f"))) void fill_directions_avx512(const double* angles,
                                                               std::size_t count, double* cosines,
                                                               double* sines) {
    fill_directions_any(angles, count, cosines, sines);
}
#endif

Level best_angle_level() {
    static const Level best = patches::is_offered(Level::avx512) ? Level::avx512
                              : patches::is_offered(Level::avx2) ? Level::avx2
                                                                 : Level::plain;
    return best;
}

}  // namespace

void fill_angles_at(Level level, std::span<const double> x, std::span<const double> y,
                    std::span<double> angles) {
    assert(x.size() == y.size() && x.size() == angles.size());
#ifdef BATTEN_HAS_X86_LEVELS
    if (level == Level::avx512) {
        return fill_angles_avx512(x.data(), y.data(), x.size(), angles.data());
    }
    if (level == Level::avx2) return fill_angles_avx2(x.data(), y.data(), x.size(), angles.data());
#endif
    assert(level == Level::plain);
    fill_angles_any(x.data(), y.data(), x.size(), angles.data());
}

void fill_directions_at(Level level, std::span<const double> angles, std::span<double> cosines,
                        std::span<double> sines) {
    assert(angles.size() == cosines.size() && angles.size() == sines.size());
    const std::size_t count = angles.size();
#ifdef BATTEN_HAS_X86_LEVELS
    if (level == Level::avx512) {
        return fill_directions_avx512(angles.data(), count, cosines.data(), sines.data());
    }
    if (level == Level::avx2) {
        return fill_directions_avx2(angles.data(), count, cosines.data(), sines.data());
    }
#endif
    assert(level == Level::plain);
    fill_directions_any(angles.data(), count, cosines.data(), sines.data());
}

double angle_of(double x, double y) { return angle_inline(x, y); }

Direction direction_of(double angle) {
    Direction d{};
    fill_directions_any(&angle, 1, &d.cosine, &d.sine);
    return d;
}

void fill_angles(std::span<const double> x, std::span<const double> y, std::span<double> angles) {
    fill_angles_at(best_angle_level(), x, y, angles);
}

void fill_directions(std::span<const double> angles, std::span<double> cosines,
                     std::span<double> sines) {
    fill_directions_at(best_angle_level(), angles, cosines, sines);
}

}  // namespace batten::num
