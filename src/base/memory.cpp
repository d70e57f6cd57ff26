#include "base/memory.hpp"

#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace batten::memory {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;
/// From here on what rounding up wastes is at most a half.
constexpr std::size_t least_large = 2 * large_page;

struct FreeAligned {
    void operator()(double* numbers) const {
        ::operator delete(numbers, std::align_val_t{large_page});
    }
};

}  // namespace

std::shared_ptr<double[]> unwritten_numbers(std::size_t count) {
    const std::size_t bytes = count * sizeof(double);
    if (bytes < least_large) return std::shared_ptr<double[]>(new double[count]);
    const std::size_t rounded = (bytes + large_page - 1) / large_page * large_page;
    void* const memory = ::operator new(rounded, std::align_val_t{large_page});
    std::shared_ptr<double[]> numbers(static_cast<double*>(memory), FreeAligned{});
#ifdef __linux__
    madvise(memory, rounded, MADV_HUGEPAGE);  // advice: it does not matter whether it is taken
#endif
    return numbers;
}

}  // namespace batten::memory
