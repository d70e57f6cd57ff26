#include "num/rows.hpp"

#include "num/lanes.hpp"

namespace batten::num {
namespace {

BATTEN_INLINE double dot_of(const double* a, const double* b, std::size_t count) {
    Lanes sums = {};
    std::size_t s = 0;
    for (; s + lanes <= count; s += lanes) {
        Lanes x, y;
        load(a + s, x);
        load(b + s, y);
        sums += x * y;
    }
    double sum = sum_of(sums);
    for (; s < count; ++s) sum += a[s] * b[s];
    return sum;
}

BATTEN_INLINE void add_times_row(double factor, const double* row, std::size_t count,
                                 double* __restrict to) {
    for (std::size_t s = 0; s < count; ++s) to[s] += factor * row[s];
}

}  // namespace

BATTEN_CLONES double dot(std::span<const double> a, std::span<const double> b) {
    return dot_of(a.data(), b.data(), b.size());
}

BATTEN_CLONES double sum_of_squares(std::span<const double> a) {
    return dot_of(a.data(), a.data(), a.size());
}

BATTEN_CLONES void add_times(double factor, std::span<const double> row, std::span<double> to) {
    add_times_row(factor, row.data(), to.size(), to.data());
}

BATTEN_CLONES void add_combination(std::span<const double> factors, std::span<const double> rows,
                                   std::span<double> to) {
    const std::size_t count = to.size();
    double* __restrict const out = to.data();
    std::size_t i = 0;
    for (; i + 4 <= factors.size(); i += 4) {
        const double a = factors[i], b = factors[i + 1], c = factors[i + 2], d = factors[i + 3];
        const double* const first = rows.data() + i * count;
        const double* const second = first + count;
        const double* const third = second + count;
        const double* const fourth = third + count;
        for (std::size_t s = 0; s < count; ++s) {
            out[s] += (a * first[s] + b * second[s]) + (c * third[s] + d * fourth[s]);
        }
    }
    for (; i < factors.size(); ++i) add_times_row(factors[i], rows.data() + i * count, count, out);
}

BATTEN_CLONES void add_dots(std::span<const double> rows, std::span<const double> with,
                            std::span<double> to) {
    const std::size_t count = with.size();
    for (std::size_t i = 0; i < to.size(); ++i) {
        to[i] += dot_of(rows.data() + i * count, with.data(), count);
    }
}

std::vector<double> transposed(std::span<const double> matrix, std::size_t rows) {
    const std::size_t columns = matrix.size() / rows;
    std::vector<double> result(matrix.size());
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) result[j * rows + i] = matrix[i * columns + j];
    }
    return result;
}

}  // namespace batten::num
