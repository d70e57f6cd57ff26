#include <cmath>
#include <cstdint>
#include <cstring>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/measure/graph_bend.hpp"

namespace batten {
namespace {

using Corner = std::array<double, 3>;

/// Bytes of a number, low ones first, on every machine.
template <class Number>
void append_bytes(std::string& to, Number value) {
    static_assert(sizeof(Number) <= 8);
    std::uint64_t bits = 0;
    if constexpr (sizeof(Number) == 8) {
        std::memcpy(&bits, &value, sizeof value);
    } else {
        std::uint32_t half = 0;
        static_assert(sizeof(Number) == 4);
        std::memcpy(&half, &value, sizeof value);
        bits = half;
    }
    for (std::size_t b = 0; b < sizeof(Number); ++b) {
        to += static_cast<char>(bits >> (8 * b) & 255);
    }
}

void append_triangle(std::string& to, const Corner& a, const Corner& b, const Corner& c) {
    const double u[] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double v[] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const double n[] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                        u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    for (const double part : n) append_bytes(to, static_cast<float>(length > 0 ? part / length : 0));
    for (const Corner* corner : {&a, &b, &c}) {
        for (const double x : *corner) {
            const float single = static_cast<float>(x);
            if (!std::isfinite(single)) {
                throw Error("number.overflow", "mesh", format_number(x),
                            "STL holds numbers of single precision");
            }
            append_bytes(to, single);
        }
    }
    to.append(2, '\0');
}

/// The points of the surface over these places.
Grid nodes_of(const SplineSurface& surface, const MeshPlaces& places) {
    const Grid z = surface.evaluate(places.x, places.y);
    Grid nodes(z.nu(), z.nv(), 3);
    for (std::size_t i = 0; i < z.nu(); ++i) {
        for (std::size_t j = 0; j < z.nv(); ++j) {
            nodes(i, j, 0) = places.x[i];
            nodes(i, j, 1) = places.y[j];
            nodes(i, j, 2) = z(i, j);
        }
    }
    return nodes;
}

Corner corner_of(const GridView& nodes, std::size_t i, std::size_t j) {
    return {nodes(i, j, 0), nodes(i, j, 1), nodes(i, j, 2)};
}

void append_vertices(std::string& text, const GridView& nodes) {
    for (std::size_t i = 0; i < nodes.nu(); ++i) {
        for (std::size_t j = 0; j < nodes.nv(); ++j) {
            text += 'v';
            for (const double x : corner_of(nodes, i, j)) text += ' ' + format_number(x);
            text += '\n';
        }
    }
}

/// Quadrilaterals; each corner is named by its number and what `name` makes of it.
template <class Name>
void append_faces(std::string& text, const GridView& nodes, Name name) {
    const std::size_t n = nodes.nv();
    for (std::size_t i = 0; i + 1 < nodes.nu(); ++i) {
        for (std::size_t j = 0; j + 1 < n; ++j) {
            const std::size_t first = i * n + j + 1;
            text += 'f';
            for (const std::size_t corner : {first, first + n, first + n + 1, first + 1}) {
                text += ' ' + name(std::to_string(corner));
            }
            text += '\n';
        }
    }
}

}  // namespace

std::string obj_mesh(const SplineSurface& surface, const MeshPlaces& places) {
    const Grid nodes = nodes_of(surface, places);
    std::string text;
    append_vertices(text, nodes);
    for (const double x : places.x) {
        for (const double y : places.y) {
            text += "vn";
            for (const double part : graph_bend(surface, x, y).normal) {
                text += ' ' + format_number(part);
            }
            text += '\n';
        }
    }
    append_faces(text, nodes, [](const std::string& number) { return number + "//" + number; });
    return text;
}

std::string obj_mesh(const GridView& nodes) {
    std::string text;
    append_vertices(text, nodes);
    append_faces(text, nodes, [](const std::string& number) { return number; });
    return text;
}

std::string stl_mesh(const SplineSurface& surface, const MeshPlaces& places) {
    return stl_mesh(nodes_of(surface, places));
}

std::string stl_mesh(const GridView& nodes) {
    const std::size_t cells = (nodes.nu() - 1) * (nodes.nv() - 1);
    std::string bytes(80, ' ');
    append_bytes(bytes, static_cast<std::uint32_t>(2 * cells));
    for (std::size_t i = 0; i + 1 < nodes.nu(); ++i) {
        for (std::size_t j = 0; j + 1 < nodes.nv(); ++j) {
            const Corner first = corner_of(nodes, i, j), last = corner_of(nodes, i + 1, j + 1);
            append_triangle(bytes, first, corner_of(nodes, i + 1, j), last);
            append_triangle(bytes, first, last, corner_of(nodes, i, j + 1));
        }
    }
    return bytes;
}

std::string ply_mesh(const SplineSurface& surface, const MeshPlaces& places) {
    return ply_mesh(nodes_of(surface, places));
}

std::string ply_mesh(const GridView& nodes) {
    const std::size_t n = nodes.nv(), cells = (nodes.nu() - 1) * (n - 1);
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(nodes.nu() * n) +
                        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                        std::to_string(2 * cells) +
                        "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t i = 0; i < nodes.nu(); ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            for (const double x : corner_of(nodes, i, j)) append_bytes(bytes, x);
        }
    }
    for (std::size_t i = 0; i + 1 < nodes.nu(); ++i) {
        for (std::size_t j = 0; j + 1 < n; ++j) {
            const std::int32_t first = static_cast<std::int32_t>(i * n + j);
            const std::int32_t beside = first + static_cast<std::int32_t>(n);
            for (const auto& [a, b, c] : {std::array{first, beside, beside + 1},
                                          std::array{first, beside + 1, first + 1}}) {
                bytes += '\3';
                for (const std::int32_t corner : {a, b, c}) append_bytes(bytes, corner);
            }
        }
    }
    return bytes;
}

}  // namespace batten
