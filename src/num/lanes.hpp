#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "num/clones.hpp"

/// Eight numbers at once, in a fixed order: the same bits whatever vectors the processor has.
namespace batten::num {

constexpr std::size_t lanes = 8;
typedef double Lanes __attribute__((vector_size(64)));
typedef long long LaneMask __attribute__((vector_size(64)));

BATTEN_INLINE void load(const double* from, Lanes& to) { std::memcpy(&to, from, sizeof to); }
BATTEN_INLINE void store(const Lanes& from, double* to) { std::memcpy(to, &from, sizeof from); }

/// The sum of the lanes, pair by pair.
BATTEN_INLINE double sum_of(const Lanes& v) {
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

BATTEN_INLINE long long sum_of(const LaneMask& v) {
    long long sum = 0;
    for (std::size_t l = 0; l < lanes; ++l) sum += v[l];
    return sum;
}

template <class V>
BATTEN_INLINE auto largest_of(const V& v) {
    auto largest = v[0];
    for (std::size_t l = 1; l < lanes; ++l) largest = v[l] > largest ? v[l] : largest;
    return largest;
}

/// Zeros that begin where a whole vector does: no load of eight crosses two lines of the cache.
class AlignedNumbers {
public:
    explicit AlignedNumbers(std::size_t count) : storage_(count + lanes) {}
    AlignedNumbers(const AlignedNumbers&) = delete;  // a copy would begin elsewhere
    AlignedNumbers& operator=(const AlignedNumbers&) = delete;

    double* data() {
        const std::size_t past =
            reinterpret_cast<std::uintptr_t>(storage_.data()) / sizeof(double) % lanes;
        return storage_.data() + (lanes - past) % lanes;
    }

private:
    std::vector<double> storage_;
};

/// `count` rounded up to whole vectors.
constexpr std::size_t whole_lanes(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }

}  // namespace batten::num
