// Compares the tables of the pseudo-spline with its minimiser on random pairs of angles, all of
// them and, a tenth as many, small ones around arcs.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>

#include "make/pseudo/segment/minima.hpp"
#include "make/pseudo/tables/ends.hpp"
#include "make/pseudo/tables/segments.hpp"

using namespace batten::pseudo;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// The largest errors of some pairs, and how many of them are above what is promised.
struct Errors {
    long pairs = 0;
    double energy = 0, magnitude = 0, length = 0;
    long above_energy = 0, above_magnitude = 0, above_length = 0;

    void add(const TabulatedSegment& s, const Minimum& m) {
        // Below 1.2 degrees the minimiser may miss the least minimum by 1e-11.
        const double e = std::fabs(s.pseudo_energy / m.pseudo_energy - 1);
        const double r = std::fmax(std::fabs(s.r0 - m.segment.r0), std::fabs(s.r1 - m.segment.r1));
        const double l = std::fabs(s.length - m.length);
        ++pairs;
        energy = std::fmax(energy, e);
        magnitude = std::fmax(magnitude, r);
        length = std::fmax(length, l);
        above_energy += e > 1e-12;
        above_magnitude += r > 1e-8;
        above_length += l > 1e-9;
        if (s.pseudo_energy > (1 + 1e-12) * m.pseudo_energy) {
            std::printf("J %.1e at %.17g %.17g\n", s.pseudo_energy / m.pseudo_energy - 1,
                        m.segment.theta0, m.segment.theta1);
        }
    }
    void print(const char* name) const {
        std::printf("%-16s %8ld pairs: J %.1e, r %.1e, L %.1e; above 1e-12, 1e-8, 1e-9: %ld %ld %ld\n",
                    name, pairs, energy, magnitude, length, above_energy, above_magnitude,
                    above_length);
    }
};

struct Zones {
    Errors general, nodes, short_arcs;

    void add(double theta0, double theta1) {
        const double larger = std::fmax(std::fabs(theta0), std::fabs(theta1));
        const double smaller = std::fmin(std::fabs(theta0), std::fabs(theta1));
        const double to_node = std::fmin(std::hypot(pi - larger, smaller),
                                         std::hypot(pi - larger, pi - smaller));
        const bool is_short = larger < 3 * degree && std::fabs(theta0 + theta1) < 3 * degree;
        Errors& errors = to_node < 2 * degree ? nodes : is_short ? short_arcs : general;
        errors.add(tabulated_segment(theta0, theta1), least_minimum(theta0, theta1));
    }
};

}  // namespace

int main(int count, char** words) {
    const long pairs = count > 1 ? std::atol(words[1]) : 100000;
    std::mt19937_64 random(count > 2 ? static_cast<unsigned>(std::atol(words[2])) : 1);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    Zones all, arcs;
    for (long i = 0; i < pairs; ++i) {
        const double theta0 = pi * anywhere(random);
        all.add(theta0, pi * anywhere(random));
    }
    for (long i = 0; i < pairs / 10; ++i) {
        const double t = std::pow(10.0, 2 * anywhere(random) - 2);
        arcs.add(t, t * (t * (1 + anywhere(random)) - 1));
    }
    all.general.print("random");
    all.nodes.print("  near a node");
    all.short_arcs.print("  short arcs");
    arcs.general.print("around arcs");
    arcs.short_arcs.print("  short arcs");
    return all.general.above_energy + all.general.above_length > 0 ? 1 : 0;
}
