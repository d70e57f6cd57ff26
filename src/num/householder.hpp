#pragma once

#include <cstddef>

/// Orthogonal reduction of rows into a triangle, for narrow matrices of any height.
namespace batten::num {

/// A block of rows, `stride` numbers from one row to the next.
struct RowBlock {
    double* data;
    int rows;
    std::size_t stride;
};

/// The upper triangle rows are rotated into: `columns` rows of `width` >= columns numbers,
/// `stride` apart; what stands right of the columns (right-hand sides) follows the rotations.
struct Triangle {
    double* data;
    std::size_t stride;
    int columns;
    int width;
};

/// Whether row i of a block starts with i zeros.
enum class BlockShape { full, triangular };

/// Rotates `block` into `into`: afterwards the first `columns` columns of the block are spent
/// (their content is undefined), the others hold what is orthogonal to the triangle.
///
/// Accuracy: backward stable column by column, whatever the columns' scales.
/// Source: Householder reflections [GolubVanLoan2013, 5.1].
void absorb(const Triangle& into, const RowBlock& block, BlockShape shape = BlockShape::full);

}  // namespace batten::num
