#include "make/pseudo/tables/ends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "make/pseudo/tables/end_slopes.hpp"

namespace batten::pseudo {
namespace {

using std::numbers::pi;

/// The piece an angle lies in, by equal cells.
class EndIndex {
public:
    EndIndex() {
        const auto pieces = end_pieces();
        std::size_t piece = 0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double angle = pi * static_cast<double>(cell) / cells;
            while (pieces[piece].hi <= angle) ++piece;
            first_[cell] = static_cast<std::uint16_t>(piece);
        }
    }
    const EndPiece& find(double theta) const {
        const auto pieces = end_pieces();
        const std::size_t cell = static_cast<std::size_t>(theta * (cells / pi));
        std::size_t piece = first_[std::min(cell, cells - 1)];
        while (piece > 0 && theta < pieces[piece].lo) --piece;
        while (piece + 1 < pieces.size() && theta >= pieces[piece].hi) ++piece;
        return pieces[piece];
    }

private:
    static constexpr std::size_t cells = 512;
    std::array<std::uint16_t, cells> first_{};
};

}  // namespace

const EndPiece& piece_at(double theta) {
    static const EndIndex index;
    return index.find(theta);
}

TabulatedEnd tabulated_end(double theta) {
    const double size = std::fabs(theta);
    const EndPiece& piece = piece_at(size);
    const double x = (size - 0.5 * (piece.lo + piece.hi)) * (2 / (piece.hi - piece.lo));
    double ratio = piece.ratio[end_size - 1];
    for (std::size_t k = end_size - 1; k-- > 0;) ratio = ratio * x + piece.ratio[k];
    const Slopes j = slopes_on(piece, size);
    return {ratio * theta, j.value, std::copysign(j.first, theta), j.second};
}

}  // namespace batten::pseudo
