#pragma once

#include "num/tensor.hpp"

/// The loops of a tensor product over pieces that stay in the first cache.
namespace batten::num {

/// Columns worked on at a time: sums, and the same rows of the next block, stay in the first cache.
constexpr std::size_t tensor_block = 256;

/// Rows of an array and what each is worth to some functions: factors[row * order + function].
struct Rows {
    const double* z;
    std::size_t stride;
    const double* factors;
    std::size_t order;
};

/// sums[i][from + s] += sum over the rows q of factors(q, i) z(q, s) for the functions i and `count`
/// columns s. The same columns of the next block are fetched ahead.
struct RowSums {
    double* const* at;
    std::size_t from, count;
};
void add_rows(Rows rows, std::size_t row_count, const RowSums& sums);

/// One run of y-places with the same functions.
struct Product {
    const double* from;  ///< rows of numbers at these places
    std::size_t stride;
    const double* y;  ///< the functions there, `width` a place
    std::size_t width, order, places;
    double* g;  ///< of the first row and function
    std::size_t reach;
};

/// g(q, j) += sum over s of from(q, s) y(s, j) for `count` rows q.
void add_products(const Product& product, std::size_t count);

/// out[s] = sum over j of h[j] lines[j][s] for the places s, of which `out` holds the first first.
void combine(const double* const* lines, const double* h, std::size_t order, PlaceRange places,
             double* out);

}  // namespace batten::num
