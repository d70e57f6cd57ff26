#pragma once

#include <cmath>

namespace batten::num {

/// A running sum whose rounding error does not grow with the number of terms.
///
/// Accuracy: |error| <= ulp(sum) + n^2 ulp^2 (sum of the terms' magnitudes).
/// Source: [Neumaier1974].
class Sum {
public:
    void add(double term) {
        const double next = sum_ + term;
        lost_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - next) + term : (term - next) + sum_;
        sum_ = next;
    }
    double value() const { return sum_ + lost_; }

private:
    double sum_ = 0, lost_ = 0;
};

}  // namespace batten::num
