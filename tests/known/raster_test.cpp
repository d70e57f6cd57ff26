#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "batten/io/grid_file.hpp"
#include "errors.hpp"
#include "shared.hpp"

#if BATTEN_WITH_GDAL
#include <gdal_frmts.h>
#include <gdal_priv.h>
#endif

/// Grids from rasters, where GDAL is built in; the files are written by GDAL itself.
namespace batten::testing {
namespace raster_test {

TEST(Raster, IsKnownByItsBytesOrItsName) {
    const auto format = [](const char* name, std::string bytes) {
        return grid_format({name, std::move(bytes)});
    };
    EXPECT_EQ(format("a", std::string("II*\0", 4)), GridFormat::raster);
    EXPECT_EQ(format("a", std::string("MM\0+", 4)), GridFormat::raster);
    EXPECT_EQ(format("a.asc", "ncols 3\n"), GridFormat::raster);
    EXPECT_EQ(format("N50E006.hgt", "xx"), GridFormat::raster);
    EXPECT_EQ(format("a.csv", "MM,0,1\n"), GridFormat::text);
}

#if BATTEN_WITH_GDAL

/// 4 columns, 3 rows; row 0 is the northern one. The last value of the first row is missing.
std::string geotiff(const std::vector<double>& transform) {
    GDALRegister_GTiff();
    const std::string path = scratch_file("raster.tif");
    GDALDataset* const set = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.c_str(), 4, 3, 2, GDT_Int16, nullptr);
    std::vector<double> numbers = transform;
    set->SetGeoTransform(numbers.data());
    std::vector<double> heights{10, 11, 12, -999, 20, 21, 22, 23, 30, 31, 32, 33};
    set->GetRasterBand(1)->SetNoDataValue(-999);
    set->GetRasterBand(1)->SetScale(0.5);
    set->GetRasterBand(1)->SetOffset(100);
    EXPECT_EQ(set->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 4, 3, heights.data(), 4, 3,
                                              GDT_Float64, 0, 0, nullptr),
              CE_None);
    GDALClose(set);
    return path;
}

TEST(Raster, OfGeoTiffHasItsPlacesItsUnitsAndItsHoles) {
    const GridFile file = read_grid(geotiff({500, 10, 0, 7000, 0, -20}));
    EXPECT_EQ(file.x, (std::vector<double>{505, 515, 525, 535}));
    EXPECT_EQ(file.y, (std::vector<double>{6950, 6970, 6990}));
    EXPECT_EQ(file.z.missing(), 1u);
    EXPECT_FALSE(file.z.has(3, 2));
    EXPECT_EQ(file.z(0, 2), 105);
    EXPECT_EQ(file.z(0, 0), 115);
    EXPECT_EQ(file.z(3, 0), 116.5);
    ASSERT_EQ(file.notes.size(), 2u);
    EXPECT_EQ(file.notes[0], "band 1 of 2");
}

TEST(Raster, OfEsriTextStandsAtTheMiddlesOfItsCells) {
    const GridFile file = parse_grid(
        {"a.asc", "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 10\ncellsize 2\nNODATA_value -1\n"
                  "1 2 3\n4 -1 6\n"});
    EXPECT_EQ(file.x, (std::vector<double>{1, 3, 5}));
    EXPECT_EQ(file.y, (std::vector<double>{11, 13}));
    EXPECT_EQ(file.z(0, 1), 1);
    EXPECT_EQ(file.z(2, 0), 6);
    EXPECT_FALSE(file.z.has(1, 0));
}

TEST(Raster, ThatIsTurnedOrNoneIsRefused) {
    const auto code = [](const Source& source) { return code_of([&] { parse_grid(source); }); };
    const std::string turned = geotiff({0, 1, 0.5, 0, 0.5, -1});
    EXPECT_EQ(code({turned, read_text(turned)}), "raster.turned");
    EXPECT_EQ(code({"a.tif", "text"}), "raster.format");
    const std::string whole = read_text(geotiff({0, 1, 0, 0, 0, -1}));
    EXPECT_EQ(code({"a.tif", whole.substr(0, 60)}), "raster.format");
    // What opens other files is not let in, whatever its name.
    EXPECT_EQ(code({"a.tif", "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"></VRTDataset>"}),
              "raster.format");
}

#else

TEST(Raster, IsRefusedWhereGdalIsNotBuiltIn) {
    EXPECT_EQ(code_of([] { parse_grid({"a.tif", std::string("II*\0more", 8)}); }),
              "raster.not-built-in");
}

#endif

}  // namespace raster_test
}  // namespace batten::testing
