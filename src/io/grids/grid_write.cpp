#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/grid_file.hpp"

namespace batten {

std::string csv_grid(const std::vector<double>& x, const std::vector<double>& y, GridView z) {
    std::string text = "x\\y";
    for (const double place : y) text += ',' + format_number(place);
    text += '\n';
    for (std::size_t i = 0; i < x.size(); ++i) {
        text += format_number(x[i]);
        for (std::size_t j = 0; j < y.size(); ++j) {
            text += ',';
            if (!z.has(i, j)) continue;
            if (!std::isfinite(z(i, j))) {
                throw Error("number.overflow",
                            "node " + std::to_string(i) + ',' + std::to_string(j),
                            format_number(z(i, j)), "is beyond the range of a double");
            }
            text += format_number(z(i, j));
        }
        text += '\n';
    }
    return text;
}

std::string npy_grid(GridView z) {
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(z.nu()) + ", " + std::to_string(z.nv()) + "), }";
    header.append(63 - (10 + header.size()) % 64, ' ');
    header += '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() & 255);
    bytes += static_cast<char>(header.size() >> 8);
    bytes += header;
    for (std::size_t i = 0; i < z.nu(); ++i) {
        for (std::size_t j = 0; j < z.nv(); ++j) {
            const double value =
                z.has(i, j) ? z(i, j) : std::numeric_limits<double>::quiet_NaN();
            std::uint64_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            for (int b = 0; b < 8; ++b) bytes += static_cast<char>(bits >> (8 * b) & 255);
        }
    }
    return bytes;
}

}  // namespace batten
