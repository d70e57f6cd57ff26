#include "batten/base/error.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/surface_file.hpp"
#include "batten/io/json.hpp"
#include "surface_samples.hpp"

namespace batten {
namespace grid_io_test {

using namespace testing;

GridFile parsed(std::string name, std::string bytes) { return parse_grid({std::move(name), std::move(bytes)}); }

std::string refused(std::string name, std::string bytes) {
    try {
        parsed(std::move(name), std::move(bytes));
    } catch (const Error& error) {
        return error.code();
    }
    return "";
}

TEST(GridFile, IsATableWithYAboveAndXOnTheLeft) {
    for (const char* const corner : {"", "x\\y", "0"}) {
        const GridFile g = parsed("g.csv", std::string(corner) + ",10,20,30,40\n1,1,2,3,4\n2,5,,nan,8\n");
        EXPECT_EQ(g.x, (std::vector<double>{1, 2}));
        EXPECT_EQ(g.y, (std::vector<double>{10, 20, 30, 40}));
        EXPECT_EQ(g.z(0, 2), 3);
        EXPECT_EQ(g.z(1, 3), 8);
        EXPECT_EQ(g.z.missing(), 2u);
        EXPECT_FALSE(g.z.has(1, 1));
        EXPECT_FALSE(g.z.has(1, 2));
    }
}

TEST(GridFile, IsRowsInAnyOrderWithOrWithoutNames) {
    const GridFile named = parsed("g.csv", "f,y,x,sigma\n1,0,0,.1\n4,1,1,.4\n2,1,0,.2\n3,0,1,.3\n");
    EXPECT_EQ(named.z(0, 1), 2);
    EXPECT_EQ(named.z(1, 0), 3);
    EXPECT_EQ(named.sigma, (std::vector<double>{.1, .2, .3, .4}));
    const GridFile bare = parsed("g.txt", "0 0 1\n0 1 2\n1 0 3\n1 1 NaN\n");
    EXPECT_EQ(bare.z(1, 0), 3);
    EXPECT_EQ(bare.z.missing(), 1u);
    EXPECT_TRUE(bare.sigma.empty());
}

TEST(GridFile, TurnsFallingAxesRound) {
    const GridFile g = parsed("g.csv", ",3,2,1,0\n1,1,2,3,4\n0,5,6,7,8\n");
    EXPECT_EQ(g.x, (std::vector<double>{0, 1}));
    EXPECT_EQ(g.y, (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(g.z(0, 0), 8);
    EXPECT_EQ(g.z(1, 3), 1);
}

TEST(GridFile, IsAPictureWithYUp) {
    const std::string plain = "P2 # remark\n3 2\n255\n1 2 3\n4 5 6\n";
    const std::string raw = std::string("P5\n3 2\n255\n") + "\1\2\3\4\5\6";
    for (const GridFile& g : {parsed("a.pgm", plain), parsed("b.pgm", raw)}) {
        EXPECT_EQ(g.x.size(), 3u);
        EXPECT_EQ(g.y.size(), 2u);
        EXPECT_EQ(g.z(0, 0), 4);
        EXPECT_EQ(g.z(2, 1), 3);
    }
    const std::string deep = std::string("P5 2 2 65535\n") + std::string("\1\0\0\2\0\3\0\4", 8);
    EXPECT_EQ(parsed("c.pgm", deep).z(0, 1), 256);
}

/// 3 x 2 greys 1 2 3 / 250 5 6, written by an independent program (zlib's fixed codes, filter
/// `sub` in the first row and `up` in the second).
TEST(GridFile, ReadsAPngWithFilters) {
    const unsigned char png[] = {
        137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0,
        0, 3, 0, 0, 0, 2, 8, 0, 0, 0, 0, 184, 31, 57, 198, 0, 0, 0,
        16, 73, 68, 65, 84, 120, 1, 99, 100, 100, 100, 100, 250, 201, 204, 12, 0, 3,
        30, 1, 6, 220, 39, 68, 93, 0, 0, 0, 0, 73, 69, 78, 68, 174, 66, 96,
        130};
    const GridFile g = parsed("a.png", std::string(std::begin(png), std::end(png)));
    EXPECT_EQ(g.z(0, 1), 1);
    EXPECT_EQ(g.z(1, 1), 2);
    EXPECT_EQ(g.z(2, 1), 3);
    EXPECT_EQ(g.z(0, 0), 250);
    EXPECT_EQ(g.z(1, 0), 5);
    EXPECT_EQ(g.z(2, 0), 6);
}

/// Pictures written by an independent program: 16 bits deep; interlaced; 2-bit colours of a palette.
TEST(GridFile, ReadsPngsOfEveryKind) {
    const unsigned char deep[] = {
        137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0,
        0, 2, 0, 0, 0, 2, 16, 0, 0, 0, 0, 7, 77, 142, 187, 0, 0, 0,
        18, 73, 68, 65, 84, 120, 218, 99, 96, 96, 100, 252, 194, 240, 255, 63, 35, 3,
        0, 12, 204, 2, 246, 176, 225, 10, 137, 0, 0, 0, 0, 73, 69, 78, 68, 174,
        66, 96, 130};
    const GridFile wide = parsed("a.png", std::string(std::begin(deep), std::end(deep)));
    EXPECT_EQ(wide.z(0, 1), 1);
    EXPECT_EQ(wide.z(1, 1), 500);
    EXPECT_EQ(wide.z(0, 0), 65535);
    EXPECT_EQ(wide.z(1, 0), 256);
    const unsigned char interlaced[] = {
        137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0,
        0, 3, 0, 0, 0, 2, 8, 0, 0, 0, 1, 207, 24, 9, 80, 0, 0, 0,
        18, 73, 68, 65, 84, 120, 218, 99, 224, 98, 224, 97, 224, 102, 224, 229, 227, 7,
        0, 1, 65, 0, 76, 46, 195, 110, 163, 0, 0, 0, 0, 73, 69, 78, 68, 174,
        66, 96, 130};
    const GridFile woven = parsed("b.png", std::string(std::begin(interlaced), std::end(interlaced)));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(woven.z(i, 1), 10 + static_cast<double>(i));
        EXPECT_EQ(woven.z(i, 0), 13 + static_cast<double>(i));
    }
    const unsigned char palette[] = {
        137, 80, 78, 71, 13, 10, 26, 10, 0, 0, 0, 13, 73, 72, 68, 82, 0, 0,
        0, 3, 0, 0, 0, 2, 2, 3, 0, 0, 0, 224, 26, 142, 137, 0, 0, 0,
        9, 80, 76, 84, 69, 7, 7, 7, 255, 0, 0, 100, 100, 100, 200, 52, 112, 76,
        0, 0, 0, 12, 73, 68, 65, 84, 120, 218, 99, 144, 96, 104, 1, 0, 0, 208,
        0, 157, 213, 150, 247, 34, 0, 0, 0, 0, 73, 69, 78, 68, 174, 66, 96, 130};
    const GridFile red = parsed("c.png", std::string(std::begin(palette), std::end(palette)));
    EXPECT_EQ(red.z(0, 1), 7);
    EXPECT_NEAR(red.z(1, 1), 0.2126 * 255, 1e-12);
    EXPECT_EQ(red.z(2, 1), 100);
    EXPECT_EQ(red.z(0, 0), 100);
}

TEST(GridFile, ComesBackFromItsOwnFormats) {
    SurfaceTable table = surface_of([](double x, double y) { return std::sin(9 * x + y) / 3; }, 5, 7);
    table.z.drop(2, 3);
    for (const bool is_text : {true, false}) {
        const GridFile g = is_text ? parsed("g.csv", csv_grid(table.x, table.y, table.z))
                                   : parsed("g.npy", npy_grid(table.z));
        ASSERT_EQ(g.z.nu(), 5u);
        ASSERT_EQ(g.z.nv(), 7u);
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t j = 0; j < 7; ++j) {
                EXPECT_EQ(g.z.has(i, j), table.z.has(i, j));
                EXPECT_EQ(g.z(i, j), table.z(i, j));
            }
        }
        if (is_text) {
            EXPECT_EQ(g.x, table.x);
        }
    }
}

TEST(GridFile, RefusesWhatIsNoGrid) {
    EXPECT_EQ(refused("g.csv", ""), "file.empty");
    EXPECT_EQ(refused("g.csv", "# nothing\n"), "file.empty");
    EXPECT_EQ(refused("g.csv", ",1,2,3,4\n0,1,2,3,4\n1,1,2,3\n"), "grid.ragged");
    EXPECT_EQ(refused("g.csv", ",1,2,2,4\n0,1,2,3,4\n1,1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",1,nan,2,4\n0,1,2,3,4\n1,1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",1,2,3,4\n0,1,2,3,4\n,1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",1,2,3,4\n0,1,2,oops,4\n1,1,2,3,4\n"), "grid.cell");
    EXPECT_EQ(refused("g.csv", ",1,2,3,4\n0,1,2,3,4\n"), "grid.too-small");
    EXPECT_EQ(refused("g.csv", "x,y,f\n0,0,1\n0,1,1\n1,0,1\n"), "grid.not-a-grid");
    EXPECT_EQ(refused("g.csv", "x,y,f\n0,0,1\n0,0,1\n1,0,1\n1,1,1\n"), "grid.not-a-grid");
    EXPECT_EQ(refused("g.csv", "x,y,f,sigma\n0,0,1,1\n0,1,1,0\n1,0,1,1\n1,1,1,1\n"), "fit.sigma");
    EXPECT_EQ(refused("g.png", "no picture at all"), "picture.format");
    EXPECT_EQ(refused("g.png", "\x89PNG\r\n\x1a\n"), "picture.format");
    EXPECT_EQ(refused("g.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x03", 20)),
              "picture.format");
    EXPECT_EQ(refused("g.pgm", "P5\n3 2\n255\n123"), "picture.format");
    EXPECT_EQ(refused("g.pgm", "P5\n3\n"), "picture.format");
    EXPECT_EQ(refused("g.npy", "\x93NUMPY"), "npy.header");
}

TEST(SurfaceFile, HoldsEveryNumber) {
    const SurfaceTable table = surface_of([](double x, double y) { return std::cos(5 * x) * y; }, 20, 15, 0.1);
    const SplineSurface s = fit_surface(table.view(), {}).surface;
    const std::string text = dump_json(surface_value(s, "hill"));
    EXPECT_EQ(std::get<SplineSurface>(parse_surface({"s.json", text})), s);
    const auto code = [](const std::string& bytes) -> std::string {
        try {
            parse_surface({"s.json", bytes});
        } catch (const Error& error) {
            return error.code();
        }
        return "";
    };
    EXPECT_EQ(code(""), "surface.format");
    EXPECT_EQ(code("{}"), "surface.format");
    EXPECT_EQ(code(R"({"format": "batten.surface/1", "kind": "b-spline-graph"})"), "surface.entry");
}

TEST(Mesh, HasTheCountsItDeclares) {
    const SurfaceTable table = surface_of([](double x, double y) { return x + y; }, 10, 10);
    FitSurfaceOptions options;
    options.sigma = 1;
    const SplineSurface s = fit_surface(table.view(), options).surface;
    const MeshPlaces places{even_places({0, 1}, 4), even_places({0, 1}, 3)};
    const std::string stl = stl_mesh(s, places), ply = ply_mesh(s, places), obj = obj_mesh(s, places);
    EXPECT_EQ(stl.size(), 84u + 12 * 50);
    EXPECT_EQ(static_cast<int>(stl[80]), 12);
    EXPECT_EQ(ply.size() - ply.find("end_header\n") - 11, 12u * 24 + 12 * 13);
    EXPECT_EQ(std::count(obj.begin(), obj.end(), '\n'), 12 + 12 + 6);
    EXPECT_NE(obj.find("\nf 1//1 4//4 5//5 2//2\n"), std::string::npos);
}

}  // namespace grid_io_test
}  // namespace batten
