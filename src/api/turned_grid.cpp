#include "api/turned_grid.hpp"

#include <algorithm>
#include <functional>

namespace batten::api {
namespace {

/// The grid whose node (i, j) is that at place(i, j) of `from`.
template <class Place>
Grid rearranged(const Grid& from, Place place) {
    Grid to(from.nu(), from.nv());
    for (std::size_t i = 0; i < from.nu(); ++i) {
        for (std::size_t j = 0; j < from.nv(); ++j) {
            const auto [r, s] = place(i, j);
            if (from.has(r, s)) to(i, j) = from(r, s);
            else to.drop(i, j);
        }
    }
    return to;
}

}  // namespace

bool falls(const std::vector<double>& lines) {
    return lines.size() > 1 &&
           std::adjacent_find(lines.begin(), lines.end(), std::less_equal<>()) == lines.end();
}

void reverse_rows(std::vector<double>& numbers, std::size_t width) {
    std::reverse(numbers.begin(), numbers.end());
    reverse_in_rows(numbers, width);
}

void reverse_in_rows(std::vector<double>& numbers, std::size_t width) {
    for (std::size_t first = 0; first + width <= numbers.size(); first += width) {
        const auto row = numbers.begin() + static_cast<std::ptrdiff_t>(first);
        std::reverse(row, row + static_cast<std::ptrdiff_t>(width));
    }
}

void turn_x(GridFile& grid) {
    const std::size_t last = grid.z.nu() - 1;
    grid.z = rearranged(grid.z, [&](std::size_t i, std::size_t j) {
        return std::pair{last - i, j};
    });
    std::reverse(grid.x.begin(), grid.x.end());
    reverse_rows(grid.sigma, grid.y.size());
}

void turn_y(GridFile& grid) {
    const std::size_t last = grid.z.nv() - 1;
    grid.z = rearranged(grid.z, [&](std::size_t i, std::size_t j) {
        return std::pair{i, last - j};
    });
    std::reverse(grid.y.begin(), grid.y.end());
    reverse_in_rows(grid.sigma, grid.y.size());
}

}  // namespace batten::api
