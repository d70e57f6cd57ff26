#include "batten/io/write_points.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"

namespace batten {
namespace {

void require_writable(PointsView points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int k = 0; k < points.dim(); ++k) {
            if (std::isfinite(points(i, k))) continue;
            throw Error("number.overflow",
                        "output row " + std::to_string(i) + ", column " + std::to_string(k),
                        format_number(points(i, k)),
                        "results must lie within the range of a double");
        }
    }
}

/// A name as a cell: in quotes where it would not read back as itself. A blank separates cells
/// where nothing else does: in a single column.
std::string cell(const std::string& name, bool is_alone) {
    const char* const special = is_alone ? ",;\t\"#\r\n " : ",;\t\"#\r\n";
    const bool is_plain = !name.empty() && name.find_first_of(special) == std::string::npos &&
                          trimmed(name).size() == name.size();
    if (is_plain) return name;
    std::string text = "\"";
    for (const char c : name) {
        if (c == '"') text += '"';
        text += c == '\n' || c == '\r' ? ' ' : c;
    }
    return text + '"';
}

void append_row(std::string& text, std::span<const double> row, const char* joint) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (k > 0) text += joint;
        text += format_number(row[k]);
    }
}

}  // namespace

std::vector<std::string> coordinate_names(int dim) {
    std::vector<std::string> names;
    for (int k = 0; k < dim; ++k) {
        names.push_back(dim <= 3 ? std::string(1, "xyz"[k]) : 'x' + std::to_string(k + 1));
    }
    return names;
}

std::string csv_points(PointsView points, const std::vector<std::string>& names) {
    require_writable(points);
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k) {
        text += cell(names[k], names.size() == 1);
        text += k + 1 < names.size() ? ',' : '\n';
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        append_row(text, points[i], ",");
        text += '\n';
    }
    return text;
}

std::string json_points(PointsView points) {
    require_writable(points);
    std::string text = "[";
    for (std::size_t i = 0; i < points.size(); ++i) {
        text += i > 0 ? ",\n  [" : "\n  [";
        append_row(text, points[i], ", ");
        text += ']';
    }
    return text + "\n]\n";
}

std::string npy_points(PointsView points) {
    require_writable(points);
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(points.size()) + ", " + std::to_string(points.dim()) +
                         "), }";
    // Magic, version and length take 10 bytes; the numbers start at a multiple of 64.
    header.resize((header.size() + 1 + 10 + 63) / 64 * 64 - 10, ' ');
    header.back() = '\n';
    std::string bytes("\x93NUMPY\x01\x00", 8);
    bytes += static_cast<char>(header.size() & 0xFF);
    bytes += static_cast<char>(header.size() >> 8);
    bytes += header;
    for (const double x : points.coordinates()) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof x);
        for (int shift = 0; shift < 64; shift += 8) {
            bytes += static_cast<char>(bits >> shift & 0xFF);
        }
    }
    return bytes;
}

std::string csv_samples(const Curve& curve, std::span<const double> parameters) {
    const std::size_t dim = static_cast<std::size_t>(curve.dim());
    std::vector<double> values(parameters.size() * dim);
    curve.jets(parameters, 0, values);
    Points rows(parameters.size(), curve.dim() + 1);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        rows(i, 0) = parameters[i];
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * dim), dim,
                    rows[i].begin() + 1);
    }
    std::vector<std::string> names = coordinate_names(curve.dim());
    names.insert(names.begin(), "t");
    return csv_points(rows, names);
}

}  // namespace batten
