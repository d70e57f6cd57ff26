#include <algorithm>
#include <cmath>
#include <string>

#include "batten/base/error.hpp"
#include "batten/measure/curvature.hpp"
#include "make/sample/walk.hpp"

namespace batten::sampling {
namespace {

std::vector<std::string> axis_names(int dim) {
    if (dim <= 3) {
        const std::vector<std::string> names{"x", "y", "z"};
        return {names.begin(), names.begin() + dim};
    }
    std::vector<std::string> names;
    for (int k = 1; k <= dim; ++k) names.push_back("x" + std::to_string(k));
    return names;
}

std::vector<std::string> column_names(int dim, bool frames) {
    std::vector<std::string> names{"i", "time", "s", "t"};
    const auto add = [&](const char* what) {
        for (const std::string& axis : axis_names(dim)) names.push_back(what + axis);
    };
    add("");
    add("t");
    names.push_back("kappa");
    names.push_back("speed");
    if (frames) {
        add("n");
        add("b");
    }
    return names;
}

/// Where it does not exist, what it is just beside.
double curvature_at(const Curve& curve, double t, bool& exists) {
    const std::size_t piece = curve.piece_of(t);
    if (const std::optional<double> kappa = curvature(curve.jet_on(piece, t, 2))) return *kappa;
    exists = false;
    const double aside = t + 0x1p-20 * (curve.piece(piece).middle() - t);
    return curvature(curve.jet_on(piece, aside, 2)).value_or(0);
}

std::vector<double> cross(std::span<const double> a, std::span<const double> b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void require_finite_cells(const Sampling& made) {
    for (std::size_t i = 0; i < made.rows.size(); ++i) {
        for (std::size_t k = 0; k < made.names.size(); ++k) {
            if (std::isfinite(made.rows[i][k])) continue;
            throw Error("number.overflow", "sample " + std::to_string(i) + ", " + made.names[k],
                        "beyond a double", "scale the curve nearer to 1");
        }
    }
}

}  // namespace

Sampling table_of(const Curve& curve, const Places& places, const SampleOptions& options) {
    if (options.frames && curve.dim() != 3) {
        throw Error("curve.dimension", "frames", std::to_string(curve.dim()) + " coordinates",
                    "frames are for curves in space");
    }
    const int dim = curve.dim();
    Sampling result{column_names(dim, options.frames), Points(0, 1), {}, Points(2)};
    result.rows = Points(places.size(), static_cast<int>(result.names.size()));
    const std::size_t width = static_cast<std::size_t>(dim);
    std::vector<double> points(places.size() * width);
    curve.jets(places.t, 0, points);
    Points normals(3);
    if (options.frames) normals = rotation_minimising_normals(curve, places.t);
    bool exists = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::vector<double> tangent = unit_tangent(curve, places.t[i]);
        auto cell = result.rows[i].begin();
        const auto put = [&](std::span<const double> numbers) {
            cell = std::copy(numbers.begin(), numbers.end(), cell);
        };
        const double head[] = {static_cast<double>(i), places.time[i], places.s[i], places.t[i]};
        put(head);
        put(std::span(points).subspan(i * width, width));
        put(tangent);
        const double tail[] = {curvature_at(curve, places.t[i], exists), places.speed[i]};
        put(tail);
        if (options.frames) {
            put(normals[i]);
            put(cross(tangent, normals[i]));
        }
    }
    require_finite_cells(result);
    if (!exists) {
        result.report.notes.push_back(
            "where the curve stands still, kappa is that just beside the place");
    }
    return result;
}

namespace {

double dot_in_space(std::span<const double> a, std::span<const double> b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// v less its part along a, and of length 1.
std::vector<double> upright(std::vector<double> v, std::span<const double> a) {
    const double along = dot_in_space(v, a);
    for (std::size_t k = 0; k < 3; ++k) v[k] -= along * a[k];
    const double length = std::sqrt(dot_in_space(v, v));
    for (double& x : v) x /= length;
    return v;
}

/// v mirrored at the plane across `axis`.
void reflect(std::vector<double>& v, std::span<const double> axis) {
    const double size = dot_in_space(axis, axis);
    if (size == 0) return;
    const double share = 2 * dot_in_space(v, axis) / size;
    for (std::size_t k = 0; k < 3; ++k) v[k] -= share * axis[k];
}

struct Station {
    std::vector<double> at, tangent;
};

/// The normal carried from one station to the next: two reflections.
std::vector<double> carried(std::vector<double> normal, const Station& from, const Station& to) {
    std::vector<double> chord(3), turn(3), tangent = from.tangent;
    for (std::size_t k = 0; k < 3; ++k) chord[k] = to.at[k] - from.at[k];
    reflect(normal, chord);
    reflect(tangent, chord);
    for (std::size_t k = 0; k < 3; ++k) turn[k] = to.tangent[k] - tangent[k];
    reflect(normal, turn);
    return normal;
}

}  // namespace

Points rotation_minimising_normals(const Curve& curve, std::span<const double> t) {
    constexpr double turn_a_step = 0.02, tall = 0.9;
    constexpr int looks = 16, most_steps = 4096;
    const auto station = [&](double at) { return Station{curve(at), unit_tangent(curve, at)}; };
    Station here = station(t[0]);
    const bool goes_up = std::fabs(here.tangent[2]) > tall;
    const std::vector<double> aside = goes_up ? std::vector<double>{1, 0, 0}
                                              : std::vector<double>{0, 0, 1};
    std::vector<double> normal = upright(aside, here.tangent);
    Points result(t.size(), 3);
    std::copy(normal.begin(), normal.end(), result[0].begin());
    for (std::size_t i = 1; i < t.size(); ++i) {
        double turned = 0;
        std::vector<double> before = here.tangent;
        for (int k = 1; k <= looks; ++k) {
            const std::vector<double> next =
                unit_tangent(curve, t[i - 1] + (t[i] - t[i - 1]) * k / looks);
            turned += std::sqrt(std::fmax(2 - 2 * dot_in_space(before, next), 0));
            before = next;
        }
        const int steps = static_cast<int>(
            std::clamp(std::ceil(turned / turn_a_step), 1.0, static_cast<double>(most_steps)));
        for (int k = 1; k <= steps; ++k) {
            const double at = k == steps ? t[i] : t[i - 1] + (t[i] - t[i - 1]) * k / steps;
            Station next = station(at);
            normal = upright(carried(std::move(normal), here, next), next.tangent);
            here = std::move(next);
        }
        std::copy(normal.begin(), normal.end(), result[i].begin());
    }
    return result;
}

}  // namespace batten::sampling
