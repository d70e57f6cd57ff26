#include "io/grids/readers.hpp"

#if BATTEN_WITH_GDAL

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace batten::grids {
namespace {

/// Formats whose files stand alone: a driver that opens other files by what is written in one is
/// not let in.
constexpr std::array<const char*, 10> drivers{"GTiff", "AAIGrid", "SRTMHGT", "USGSDEM", "HFA",
                                              "JPEG",  "BMP",     "GSAG",    "GSBG",    nullptr};

/// GDAL keeps its drivers for the whole process; these and no plug-ins.
void register_drivers() {
    static const bool are_there = [] {
        GDALRegister_GTiff();
        GDALRegister_AAIGrid();
        GDALRegister_SRTMHGT();
        GDALRegister_USGSDEM();
        GDALRegister_HFA();
        GDALRegister_JPEG();
        GDALRegister_BMP();
        GDALRegister_GSAG();
        GDALRegister_GSBG();
        return true;
    }();
    static_cast<void>(are_there);
}

/// GDAL is silent while one lives, and looks for no files beside the one it is given.
class Quiet {
public:
    Quiet() {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        CPLErrorReset();
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");
        CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
    }
    ~Quiet() {
        CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
        CPLSetThreadLocalConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", nullptr);
        CPLPopErrorHandler();
    }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

/// Bytes as a file in GDAL's memory, under their own name: some formats tell their place by it.
class MemoryFile {
public:
    MemoryFile(std::string_view bytes, const std::string& source) : bytes_(bytes) {
        const std::string name = source.substr(source.find_last_of("/\\") + 1);
        path_ = "/vsimem/batten-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + "/" +
                name;
        VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), reinterpret_cast<GByte*>(bytes_.data()),
                                        bytes_.size(), FALSE));
    }
    ~MemoryFile() { VSIUnlink(path_.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    const char* path() const { return path_.c_str(); }

private:
    std::string bytes_, path_;
};

struct CloseDataset {
    void operator()(GDALDataset* set) const { GDALClose(set); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

Error not_a_raster(const std::string& source, std::string value) {
    return {"raster.format", source, std::move(value), "GDAL must read it as a raster"};
}

std::string last_words() {
    const std::string text = CPLGetLastErrorMsg();
    return text.empty() ? "no format that is known" : text;
}

/// Middles of the pixels along one axis, in the order of the file.
std::vector<double> middles(std::size_t count, double origin, double step) {
    std::vector<double> places(count);
    for (std::size_t i = 0; i < count; ++i) {
        places[i] = origin + (static_cast<double>(i) + 0.5) * step;
    }
    return places;
}

/// The places of columns and of rows. Without any in the file pixels count from 0, y up.
void place(GridFile& file, GDALDataset& set, const std::string& source) {
    const std::size_t wide = static_cast<std::size_t>(set.GetRasterXSize());
    const std::size_t high = static_cast<std::size_t>(set.GetRasterYSize());
    double t[6];
    if (set.GetGeoTransform(t) != CE_None) {
        file.x = middles(wide, -0.5, 1);
        file.y = middles(high, static_cast<double>(high) - 0.5, -1);
        return;
    }
    if (t[2] != 0 || t[4] != 0) {
        throw Error("raster.turned", source, "rows that do not run along x",
                    "the lines of a grid are parallel to x and y");
    }
    file.x = middles(wide, t[0], t[1]);
    file.y = middles(high, t[3], t[5]);
}

/// Heights row after row, whatever the band's type, in its units.
std::vector<double> heights_of(GDALRasterBand& band, const std::string& source) {
    const int wide = band.GetXSize(), high = band.GetYSize();
    std::vector<double> heights(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
    if (band.RasterIO(GF_Read, 0, 0, wide, high, heights.data(), wide, high, GDT_Float64, 0, 0,
                      nullptr) != CE_None) {
        throw not_a_raster(source, last_words());
    }
    int has_none = 0;
    const double none = band.GetNoDataValue(&has_none);
    const double scale = band.GetScale(), offset = band.GetOffset();
    for (double& z : heights) {
        if (has_none != 0 && z == none) z = std::nan("");
        else z = scale * z + offset;
    }
    return heights;
}

/// The file's rows and columns into a grid whose places rise.
void fill(GridFile& file, const std::vector<double>& heights, const std::string& source) {
    const std::size_t wide = file.x.size(), high = file.y.size();
    const bool x_falls = wide > 1 && file.x[1] < file.x[0];
    const bool y_falls = high > 1 && file.y[1] < file.y[0];
    file.z = Grid(wide, high);
    for (std::size_t row = 0; row < high; ++row) {
        for (std::size_t column = 0; column < wide; ++column) {
            const double z = heights[row * wide + column];
            const std::size_t i = x_falls ? wide - 1 - column : column;
            const std::size_t j = y_falls ? high - 1 - row : row;
            if (std::isinf(z)) {
                throw Error("grid.cell", source + " row " + std::to_string(row) + ", column " +
                                             std::to_string(column),
                            "inf", "a height must be a finite number or NaN");
            }
            if (std::isnan(z)) file.z.drop(i, j);
            else file.z(i, j) = z;
        }
    }
    if (x_falls) std::reverse(file.x.begin(), file.x.end());
    if (y_falls) std::reverse(file.y.begin(), file.y.end());
}

}  // namespace

GridFile read_raster(std::string_view bytes, const std::string& source) {
    register_drivers();
    const Quiet quiet;
    const MemoryFile memory(bytes, source);
    const Dataset set(static_cast<GDALDataset*>(GDALOpenEx(
        memory.path(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data(), nullptr, nullptr)));
    if (!set || set->GetRasterCount() < 1) throw not_a_raster(source, last_words());
    const std::size_t wide = static_cast<std::size_t>(set->GetRasterXSize());
    const std::size_t high = static_cast<std::size_t>(set->GetRasterYSize());
    if (wide > most_pixels / high) {
        throw not_a_raster(source, std::to_string(wide) + " x " + std::to_string(high) + " pixels");
    }
    GridFile file;
    place(file, *set, source);
    fill(file, heights_of(*set->GetRasterBand(1), source), source);
    if (set->GetRasterCount() > 1) {
        file.notes.push_back("band 1 of " + std::to_string(set->GetRasterCount()));
    }
    return file;
}

}  // namespace batten::grids

#else

namespace batten::grids {

GridFile read_raster(std::string_view, const std::string& source) {
    throw Error("raster.not-built-in", source, "a raster",
                "this build of Batten reads none: build it with -DBATTEN_WITH_GDAL=ON, or convert "
                "the file to a table, .npy, PGM or PNG");
}

}  // namespace batten::grids

#endif
