// What a stranger writes first; built and run from outside by each way to find Batten.
#include <cmath>

#include "batten/base/error.hpp"
#include "batten/shape/curve.hpp"
#include "batten/shape/piecewise_cubic.hpp"

namespace {

bool gives_the_middle_of_a_parabola() {
    const batten::Points points({0, 0, 2, 0}, 2);
    const batten::Points start({2, 4}, 2), end({2, -4}, 2);
    const batten::Curve curve = batten::PiecewiseCubic::hermite(points, start, end, {0, 1}, false);
    return curve(0.5) == std::vector<double>{1, 1} &&
           curve.shape<batten::PiecewiseCubic>() != nullptr;
}

bool catches_an_error() {
    try {
        batten::require_finite(batten::Points({0, NAN}, 2));
        return false;
    } catch (const batten::Error& error) {
        return error.code() == "points.not-finite";
    }
}

}  // namespace

int main() { return gives_the_middle_of_a_parabola() && catches_an_error() ? 0 : 1; }
