#pragma once

#include <cmath>
#include <random>

namespace batten::testing {

/// The numbers of NumPy's RandomState(seed): the reference data were made with them.
class NumpyRandom {
public:
    explicit NumpyRandom(unsigned seed) : engine_(seed) {}

    double uniform(double lo = 0, double hi = 1) {
        const double a = static_cast<double>(engine_() >> 5);
        const double b = static_cast<double>(engine_() >> 6);
        return lo + (hi - lo) * ((a * 67108864.0 + b) / 9007199254740992.0);
    }
    /// Of variance 1, by Marsaglia's polar method.
    double normal() {
        if (has_saved_) {
            has_saved_ = false;
            return saved_;
        }
        double x = 0, y = 0, r = 0;
        do {
            x = uniform(-1, 1);
            y = uniform(-1, 1);
            r = x * x + y * y;
        } while (r >= 1 || r == 0);
        const double f = std::sqrt(-2 * std::log(r) / r);
        saved_ = f * x;
        has_saved_ = true;
        return f * y;
    }

private:
    std::mt19937 engine_;
    double saved_ = 0;
    bool has_saved_ = false;
};

}  // namespace batten::testing
