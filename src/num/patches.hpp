#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "batten/base/interval.hpp"

/// Functions of two variables by polynomials on patches, where one of several smooth functions
/// counts: each patch holds the ones that do somewhere in it, and the caller chooses.
namespace batten::patches {

constexpr int most_outputs = 4;
using Outputs = std::array<double, most_outputs>;

/// The rectangle a table covers.
struct Box {
    Interval x, y;
};

/// How a table's patches are made: sum of c[i][j] u^i v^j for i < width, j < height, u and v in
/// [-1, 1], for each of `outputs` functions.
struct Shape {
    int width = 0;
    int height = 0;
    int outputs = 0;

    std::size_t numbers() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(outputs);
    }
};

/// A point in its patch: the functions' coefficients lie one after the other.
struct Place {
    double u = 0, v = 0;
    const double* coefficients = nullptr;
    int functions = 0;  // 0: the table has nothing here
};

/// A table unpacked from text.
///
/// The text is one of whole numbers, six bits a character, the lower five first, the sixth set if
/// more follow: width, height, outputs, the levels of halvings in x and y; then the tree of
/// halvings from its root, 0 a halving in x, 1 in y (the lower half first), 2 + n a patch with n
/// functions. Each of these has, for each output, the exponent of two of its unit, then its
/// coefficients in units, both with the sign in the lowest bit.
///
/// Cost: unpacking 10 ns a number; finding one place 5 ns, whatever the number of patches.
class Table {
public:
    Table(std::span<const char* const> text, Box box);

    const Shape& shape() const { return shape_; }
    /// Requires: x, y in the box.
    Place find(double x, double y) const;
    /// The outputs of function `i` of a place.
    Outputs value(const Place& place, int i) const;

private:
    struct Patch {
        double x, y, x_scale, y_scale;
        std::size_t first;
        int functions;
    };
    class Reader;
    struct Cell;
    void read(Reader& reader, const Cell& cell);
    void read_patch(Reader& reader, const Cell& cell, int functions);

    Box box_;
    Shape shape_;
    int x_levels_ = 0, y_levels_ = 0;
    double x_cells_ = 1, y_cells_ = 1;  // a unit of length
    std::vector<std::uint16_t> patch_of_cell_;
    std::vector<Patch> patches_;
    std::vector<double> coefficients_;
};

/// The digit of the tables' alphabet, 0 to 63.
char digit(unsigned value);

}  // namespace batten::patches
