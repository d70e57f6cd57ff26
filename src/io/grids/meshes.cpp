#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/measure/graph_bend.hpp"
#include "shape/surface/sheet.hpp"

namespace batten {
namespace {

using surfaces::Sheet;
using surfaces::SheetLine;
using Corner = std::array<double, 3>;

constexpr std::size_t least_columns = 3;  // between two knot lines, where there are enough

/// A place, and the surface there.
struct SurfacePoint {
    double x = 0, y = 0;
    HeightJet jet;
};

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

/// Columns of each interval: about `lines` lines in all, closer where knot lines are.
std::vector<std::size_t> columns_of(const Sheet& sheet, std::span<const double> rows,
                                    std::size_t lines) {
    const std::vector<std::size_t>& intervals = sheet.intervals();
    std::vector<double> widths(intervals.size(), 0.0);
    for (const double y : rows) {
        const std::vector<double> knots = sheet.knots(y);
        for (std::size_t k = 0; k < intervals.size(); ++k) {
            widths[k] += knots[intervals[k] + 1] - knots[intervals[k]];
        }
    }
    const double whole = sheet.domain().x.length() * static_cast<double>(rows.size());
    const std::size_t least =
        std::clamp<std::size_t>((lines - 1) / intervals.size(), 1, least_columns);
    std::vector<std::size_t> each;
    for (const double width : widths) {
        const double share = std::round(width / whole * static_cast<double>(lines - 1));
        each.push_back(std::max(least, static_cast<std::size_t>(share)));
    }
    return each;
}

/// The nodes of a mesh and the unit normals there.
struct MeshNodes {
    Grid nodes, normals;
};

MeshNodes no_nodes(std::size_t nu, std::size_t nv) { return {Grid(nu, nv, 3), Grid(nu, nv, 3)}; }

/// What node (i, j) is; `jet` has derivatives by x and y.
void put(MeshNodes& mesh, std::size_t i, std::size_t j, const SurfacePoint& at) {
    const std::array<double, 3> normal = graph_bend(at.jet).normal;
    const double point[] = {at.x, at.y, at.jet.value};
    for (int k = 0; k < 3; ++k) {
        mesh.nodes(i, j, k) = point[k];
        mesh.normals(i, j, k) = normal[static_cast<std::size_t>(k)];
    }
}

/// Nodes on lines that follow the knot lines, both sides of walls among them.
MeshNodes nodes_along_lines(const Sheet& sheet, const MeshPlaces& places) {
    const bool turned = sheet.is_transposed();
    const std::vector<double>& rows = turned ? places.x : places.y;
    const std::size_t across = turned ? places.y.size() : places.x.size();
    const std::vector<SheetLine> lines = sheet.lines(columns_of(sheet, rows, across));
    MeshNodes mesh = turned ? no_nodes(rows.size(), lines.size())
                            : no_nodes(lines.size(), rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::vector<double> knots = sheet.knots(rows[r]);
        for (std::size_t c = 0; c < lines.size(); ++c) {
            const double x = Sheet::place(lines[c], knots);
            HeightJet jet = sheet.jet_in(Sheet::home_of(lines, c, knots), x, rows[r]);
            if (turned) {
                jet = {jet.value, jet.y, jet.x, jet.yy, jet.xy, jet.xx};
                put(mesh, r, c, {rows[r], x, jet});
            } else {
                put(mesh, c, r, {x, rows[r], jet});
            }
        }
    }
    return mesh;
}

MeshNodes nodes_of(const Surface& surface, const MeshPlaces& places) {
    const auto* product = std::get_if<SplineSurface>(&surface);
    if (!product) return nodes_along_lines(Sheet(surface), places);
    MeshNodes mesh = no_nodes(places.x.size(), places.y.size());
    for (std::size_t i = 0; i < places.x.size(); ++i) {
        for (std::size_t j = 0; j < places.y.size(); ++j) {
            put(mesh, i, j, {places.x[i], places.y[j], product->jet(places.x[i], places.y[j])});
        }
    }
    return mesh;
}

Corner corner_of(const GridView& nodes, std::size_t i, std::size_t j) {
    return {nodes(i, j, 0), nodes(i, j, 1), nodes(i, j, 2)};
}

void append_vectors(std::string& text, const char* name, const GridView& nodes) {
    for (std::size_t i = 0; i < nodes.nu(); ++i) {
        for (std::size_t j = 0; j < nodes.nv(); ++j) {
            text += name;
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

std::string obj_mesh(const Surface& surface, const MeshPlaces& places) {
    const MeshNodes mesh = nodes_of(surface, places);
    std::string text;
    append_vectors(text, "v", mesh.nodes);
    append_vectors(text, "vn", mesh.normals);
    append_faces(text, mesh.nodes,
                 [](const std::string& number) { return number + "//" + number; });
    return text;
}

std::string obj_mesh(const GridView& nodes) {
    std::string text;
    append_vectors(text, "v", nodes);
    append_faces(text, nodes, [](const std::string& number) { return number; });
    return text;
}

std::string stl_mesh(const Surface& surface, const MeshPlaces& places) {
    return stl_mesh(nodes_of(surface, places).nodes);
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

std::string ply_mesh(const Surface& surface, const MeshPlaces& places) {
    return ply_mesh(nodes_of(surface, places).nodes);
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
