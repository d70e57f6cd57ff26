#include "paper_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr double step = std::numbers::pi / 18;
constexpr int first = -17;

int wrapped(int i) { return ((i % 36) + 36) % 36; }

}  // namespace

PaperTable::PaperTable() {
    for (int i = 0; i < nodes; ++i) {
        for (int j = 0; j < nodes; ++j) {
            const bool is_end0 = (i + first) % 18 == 0, is_end1 = (j + first) % 18 == 0;
            if (is_end0 && is_end1) continue;  // x: 0 and 180 degrees
            const batten::PseudoSegment s =
                batten::least_pseudo_segment((i + first) * step, (j + first) * step);
            const batten::PseudoMeasures m = batten::measure(s);
            grid_[i][j] = {{s.r0, s.r1, m.length, m.area, m.pseudo_energy},
                           m.type == batten::PseudoType::c ? Type::c : Type::s};
        }
    }
    for (int i = 0; i < nodes; ++i) {
        End& end = ends_[i];
        for (int j = 0; j < nodes; ++j) {
            const Node& n = grid_[i][j];
            const double theta1 = (j + first) * step;
            const bool is_lower = n.segment.pseudo_energy < end.pseudo_energy;
            if (n.type != Type::x && (end.pseudo_energy == 0 || is_lower)) {
                end = {theta1, n.segment.pseudo_energy};
            }
        }
        if (i + first == 0) end = {};
    }
}

const PaperTable::Node& PaperTable::node(int i, int j) const {
    return grid_[wrapped(i)][wrapped(j)];
}

PaperTable::Segment PaperTable::segment(double theta0, double theta1) const {
    const double x = theta0 / step - first, y = theta1 / step - first;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const Type type =
        node(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))).type;
    Segment sum{0, 0, 0, 0, 0};
    double weights = 0;
    for (const int di : {0, 1}) {
        for (const int dj : {0, 1}) {
            const Node& n = node(i + di, j + dj);
            if (n.type != type) continue;
            const double weight = (di ? x - i : i + 1 - x) * (dj ? y - j : j + 1 - y);
            weights += weight;
            sum.r0 += weight * n.segment.r0;
            sum.r1 += weight * n.segment.r1;
            sum.length += weight * n.segment.length;
            sum.area += weight * n.segment.area;
            sum.pseudo_energy += weight * n.segment.pseudo_energy;
        }
    }
    for (double* value : {&sum.r0, &sum.r1, &sum.length, &sum.area, &sum.pseudo_energy}) {
        *value /= weights;
    }
    return sum;
}

PaperTable::End PaperTable::end(double theta) const {
    const double x = theta / step - first;
    const int i = static_cast<int>(std::floor(x));
    const End& low = ends_[wrapped(i)];
    const End& high = ends_[wrapped(i + 1)];
    const double part = x - i;
    return {low.theta1 + part * (high.theta1 - low.theta1),
            low.pseudo_energy + part * (high.pseudo_energy - low.pseudo_energy)};
}

double PaperTable::tangent(double turn, double length0, double length1) const {
    const auto energy = [&](double angle) {
        return length0 * end(angle).pseudo_energy + length1 * end(angle - turn).pseudo_energy;
    };
    const double a = energy(turn / 4), b = energy(turn / 2), c = energy(3 * turn / 4);
    const double bend = a - 2 * b + c;
    const double shift = bend > 0 ? 0.5 * (a - c) / bend : a < c ? -1 : 1;
    return turn / 2 + std::clamp(shift, -2.0, 2.0) * turn / 4;
}
