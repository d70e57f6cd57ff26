#pragma once

#include <cstddef>
#include <memory>

namespace batten::memory {

/// Memory for many numbers, not written yet.
///
/// Large blocks begin and end at multiples of 2 MB and are offered to the system for large pages,
/// where it knows such: the first touch of a page can cost more than what is computed into it.
std::shared_ptr<double[]> unwritten_numbers(std::size_t count);

}  // namespace batten::memory
