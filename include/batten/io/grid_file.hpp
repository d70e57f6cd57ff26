#pragma once

#include <string>
#include <vector>

#include "batten/base/grid.hpp"
#include "batten/io/files.hpp"

namespace batten {

/// Heights on a grid, whatever file they came from.
struct GridFile {
    std::string source;          ///< what errors call the file
    std::vector<double> x, y;    ///< rising
    Grid z{0, 0};                ///< x.size() x y.size(); NaN and empty cells are missing
    std::vector<double> sigma;   ///< errors, one a node, or none
    bool x_is_turned = false;    ///< fell in the file, as what is told line by line there does
    bool y_is_turned = false;
    std::vector<std::string> notes;
};

enum class GridFormat {
    text,  ///< a table: first row y, first column x; or rows x, y, f[, sigma]
    npy,   ///< f[x][y], two dimensions; x and y count from 0
    pgm,   ///< grey picture: x to the right, y up, both count pixels from 0
    png,   ///< the same; colours are turned into grey
    raster,  ///< GeoTIFF and other rasters, where GDAL is built in: the first band
};

/// By the first bytes, where they tell nothing `text`.
GridFormat grid_format(const Source& source);

/// The grid in `source`, read as docs/surfaces.md says. Pure.
///
/// Text: the first line tells which of the two forms it is: a header of names or three or four
/// numbers a row start the long form; a first cell that is empty, a word or a number before other
/// numbers the table. Fields x (descending ones are turned round), y, f or z, sigma.
/// Throws `file.empty`, `grid.ragged`, `grid.axis` where axes do not rise or fall, or are not
/// finite; `grid.cell` for a cell that is no number; `grid.not-a-grid` for rows that do not form a
/// grid; `grid.too-small`; `table.quote`; the `npy.` errors; `picture.format`;
/// `raster.not-built-in`, `raster.format`, `raster.turned`.
GridFile parse_grid(const Source& source, GridFormat format);
inline GridFile parse_grid(const Source& source) {
    return parse_grid(source, grid_format(source));
}
GridFile read_grid(const std::string& path);

/// Heights whose lines are counted from 0. Throws `grid.too-small`.
GridFile counted_grid(Grid z, const std::string& name);

/// The table form: first row y, first column x, missing nodes empty.
std::string csv_grid(const std::vector<double>& x, const std::vector<double>& y, GridView z);

/// f[x][y], version 1.0, type <f8; missing nodes are NaN.
std::string npy_grid(GridView z);

}  // namespace batten
