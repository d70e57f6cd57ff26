#include "make/fit/span_triangles.hpp"

#include <cstdint>
#include <cstring>

#include "make/fit/growth.hpp"
#include "make/fit/interval_rows.hpp"

namespace batten::fitting {
namespace {

constexpr std::size_t cache_size = 512;  // a power of two; direct mapped

std::size_t cache_place(Interval span) {
    std::uint64_t a = 0, b = 0;
    std::memcpy(&a, &span.lo, sizeof a);
    std::memcpy(&b, &span.hi, sizeof b);
    // Fibonacci hashing [Knuth1998, 6.4].
    const std::uint64_t mixed = (a * 0x9E3779B97F4A7C15u) ^ (b * 0xC2B2AE3D27D4EB4Fu);
    return static_cast<std::size_t>((mixed >> 40) % cache_size);
}

}  // namespace

SpanTriangles::SpanTriangles(const Samples& samples, const LocalBasis& basis)
    : reducer_(samples, basis), cache_(cache_size) {
    if (samples.size() > Growth::tree_from) {
        tree_ = std::make_unique<ReductionTree>(reducer_, samples.range);
    }
}

const double* SpanTriangles::triangle(Interval span, Rows rows, RightEnd end) {
    Cached& slot = cache_[cache_place(span)];
    if (slot.lo == span.lo && slot.hi == span.hi) return slot.triangle.data();
    slot.lo = span.lo;
    slot.hi = span.hi;
    slot.triangle.resize(reducer_.shape().size());
    if (tree_ && rows.count() > 2 * ReductionTree::leaf_rows) {
        tree_->over(span, end, slot.triangle.data());
    } else {
        reducer_.reduce(rows, span, Rest::wanted, slot.triangle.data());
    }
    return slot.triangle.data();
}

}  // namespace batten::fitting
