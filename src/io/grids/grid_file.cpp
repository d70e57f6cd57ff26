#include "batten/io/grid_file.hpp"

#include <cmath>

#include "io/grids/readers.hpp"
#include "io/tables/npy_grid.hpp"

namespace batten {
namespace {

std::vector<double> counted(std::size_t count) {
    std::vector<double> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = static_cast<double>(i);
    return places;
}

GridFile grid_of_npy(const Source& source) {
    tables::NpyGrid array = tables::read_npy_grid(source.bytes, source.name);
    GridFile file;
    file.z = Grid(std::move(array.values), array.rows, array.columns);
    for (std::size_t i = 0; i < array.rows; ++i) {
        for (std::size_t j = 0; j < array.columns; ++j) {
            const double value = file.z(i, j);
            if (std::isfinite(value)) continue;
            if (std::isinf(value)) {
                throw Error("grid.cell",
                            source.name + " [" + std::to_string(i) + "][" + std::to_string(j) + "]",
                            "inf", "a height must be a finite number or NaN");
            }
            file.z.drop(i, j);
        }
    }
    file.x = counted(array.rows);
    file.y = counted(array.columns);
    return file;
}

GridFile checked(GridFile file, const std::string& name) {
    file.source = name;
    if (file.x.size() < 2 || file.y.size() < 2) {
        throw Error("grid.too-small", name,
                    std::to_string(file.x.size()) + " x " + std::to_string(file.y.size()),
                    "a grid has at least two lines in each direction");
    }
    if (file.z.missing() > 0) {
        file.notes.push_back(std::to_string(file.z.missing()) + " nodes are missing");
    }
    return file;
}

bool starts_with(const Source& source, std::string_view bytes) {
    return std::string_view(source.bytes).substr(0, bytes.size()) == bytes;
}

/// GeoTIFF, Erdas, Surfer, ESRI's text grid and JPEG by their first bytes; terrain models and BMP,
/// whose bytes tell little, by their names.
bool is_raster(const Source& source, std::string_view suffix) {
    using namespace std::string_view_literals;
    for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv,
                                         "EHFA_HEADER_TAG"sv, "DSAA"sv, "DSBB"sv, "ncols"sv,
                                         "NCOLS"sv, "\xff\xd8\xff"sv}) {
        if (starts_with(source, start)) return true;
    }
    for (const std::string_view name : {"tif", "tiff", "hgt", "dem", "bmp"}) {
        if (suffix == name) return true;
    }
    return false;
}

}  // namespace

GridFormat grid_format(const Source& source) {
    if (starts_with(source, "\x93NUMPY") || suffix_of(source.name) == "npy") return GridFormat::npy;
    const std::string suffix = suffix_of(source.name);
    if (suffix == "pgm" || starts_with(source, "P5") || starts_with(source, "P2\n")) {
        return GridFormat::pgm;
    }
    if (suffix == "png" || starts_with(source, "\x89PNG")) return GridFormat::png;
    if (is_raster(source, suffix)) return GridFormat::raster;
    return GridFormat::text;
}

GridFile parse_grid(const Source& source, GridFormat format) {
    if (source.bytes.empty()) {
        throw Error("file.empty", source.name, "no bytes", "the file must hold a grid");
    }
    GridFile file;
    switch (format) {
        case GridFormat::npy: file = grid_of_npy(source); break;
        case GridFormat::pgm: file = grids::read_pgm(source.bytes, source.name); break;
        case GridFormat::png: file = grids::read_png(source.bytes, source.name); break;
        case GridFormat::raster: file = grids::read_raster(source.bytes, source.name); break;
        case GridFormat::text: file = grids::read_text(source.bytes, source.name); break;
    }
    return checked(std::move(file), source.name);
}

GridFile counted_grid(Grid z, const std::string& name) {
    GridFile file;
    file.x = counted(z.nu());
    file.y = counted(z.nv());
    file.z = std::move(z);
    return checked(std::move(file), name);
}

GridFile read_grid(const std::string& path) { return parse_grid(read_source(path)); }

}  // namespace batten
