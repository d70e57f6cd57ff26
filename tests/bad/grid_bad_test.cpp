#include "batten/api/operation.hpp"
#include "batten/io/grid_file.hpp"
#include "batten/io/grid_stream.hpp"
#include "errors.hpp"

/// Grids that are none, through the operation that every face runs.
namespace batten {
namespace {

using namespace testing;

std::string refused(const std::string& name, const std::string& bytes,
                    const std::vector<Setting>& settings = {}) {
    return code_of([&] {
        find_operation("fit-surface")->run(std::vector<Input>{{name, Source{name, bytes}}}, settings, {});
    });
}

const std::string good = ",0,1,2,3\n0,1,2,3,4\n1,2,3,4,5\n2,3,4,5,7\n3,4,5,6,9\n4,4,5,6,9\n";

TEST(BadGrid, ShapesThatAreNoGridAreRefused) {
    EXPECT_EQ(refused("g.csv", good), "none");
    EXPECT_EQ(refused("g.csv", ""), "file.empty");
    EXPECT_EQ(refused("g.csv", ",0,1,2,3\n0,1,2,3\n1,2,3,4,5\n"), "grid.ragged");
    EXPECT_EQ(refused("g.csv", ",0,1,2,3\n0,1,2,3,4\n"), "grid.too-small");
    EXPECT_EQ(refused("g.csv", "x,y,f\n0,0,1\n0,1,1\n1,0,3\n"), "grid.not-a-grid");
    EXPECT_EQ(refused("g.csv", "x,y,f\n0,0,1\n0,1,1\n1,0,3\n1,0,4\n"), "grid.not-a-grid");
}

TEST(BadGrid, AxesThatDoNotRiseOrFallAreRefused) {
    EXPECT_EQ(refused("g.csv", ",0,2,1\n0,1,2,3\n1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",0,1,1\n0,1,2,3\n1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",0,nan,2\n0,1,2,3\n1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused("g.csv", ",0,1,2\n0,1,2,3\ninf,2,3,4\n"), "grid.axis");
}

TEST(BadGrid, HeightsAndErrorsThatAreNoneAreRefused) {
    EXPECT_EQ(refused("g.csv", ",0,1,2\n0,1,word,3\n1,2,3,4\n"), "grid.cell");
    EXPECT_EQ(refused("g.csv", ",0,1,2\n0,1,inf,3\n1,2,3,4\n"), "grid.cell");
    EXPECT_EQ(refused("g.csv", ",0,1,2\n0,,,\n1,,,\n"), "fit.too-few");
    EXPECT_EQ(refused("g.csv", "x,y,f,sigma\n0,0,1,1\n0,1,1,0\n1,0,3,1\n1,1,3,1\n"), "fit.sigma");
    EXPECT_EQ(refused("g.csv", good, {{"sigma", "-1"}}), "option.range");
}

TEST(BadGrid, OptionsBeyondTheDataAreRefused) {
    EXPECT_EQ(refused("g.csv", good, {{"knots", "equal"}, {"intervals", "9,9"}}), "fit.too-few");
    EXPECT_EQ(refused("g.csv", good, {{"x", "0,1"}}), "fit-surface.sizes");
    EXPECT_EQ(refused("g.csv", good, {{"x_knots", "0.5,9"}}), "fit.knots");
    EXPECT_EQ(refused("g.csv", good, {{"lines", Points(std::vector<double>{0, 1}, 2)}}),
              "surface.lines");
}

TEST(BadGrid, PicturesThatAreNoneAreRefused) {
    EXPECT_EQ(refused("g.png", "no picture"), "picture.format");
    EXPECT_EQ(refused("g.png", good), "picture.format");
    EXPECT_EQ(refused("g.pgm", "P5 3 3 255\nab"), "picture.format");
    EXPECT_EQ(refused("g.npy", good), "npy.header");
}

TEST(BadGrid, ScatteredRowsThatAreNoneAreRefused) {
    const std::vector<Setting> scattered{{"scattered", "true"}};
    EXPECT_EQ(refused("g.csv", "x,y\n0,1\n1,1\n", scattered), "table.columns");
    EXPECT_EQ(refused("g.csv", "x,y,z\n0,1,2\n1,1,nan\n", scattered), "points.not-finite");
    EXPECT_EQ(refused("g.csv", "x,y,z\n0,1,2\n1,1,3\n", scattered), "fit.x-equal");
}

/// The code of what is wrong with a grid that is read in blocks of two rows.
std::string refused_stream(const std::string& name, const std::string& bytes) {
    return code_of([&] {
        GridStream stream(StoredBytes(Source{name, bytes}));
        std::vector<double> z(2 * stream.y().size());
        for (std::size_t first = 0; first + 2 <= stream.x().size(); ++first) stream.read(first, z);
    });
}

TEST(BadGridStream, FilesThatAreNoWholeTableAreRefused) {
    EXPECT_EQ(refused_stream("g.csv", good), "none");
    EXPECT_EQ(refused_stream("g.csv", ""), "file.empty");
    EXPECT_EQ(refused_stream("g.csv", "# nothing\n"), "file.empty");
    EXPECT_EQ(refused_stream("g.csv", "x,y,f\n0,0,1\n0,1,1\n1,0,3\n"), "grid.streamed");
    EXPECT_EQ(refused_stream("g.pgm", "P2\n2 2\n9\n1 2 3 4\n"), "grid.streamed");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2,3\n"), "grid.too-small");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2\n1,2,3,4\n"), "grid.ragged");
    EXPECT_EQ(refused_stream("g.csv", ",0,2,1\n0,1,2,3\n1,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2,3\n0,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2,3\nword,2,3,4\n"), "grid.axis");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2,3\n1,2,inf,4\n"), "grid.cell");
    EXPECT_EQ(refused_stream("g.csv", ",0,1,2\n0,1,2,3\n1,2,\"3,4\n"), "table.quote");
}

TEST(BadGridStream, ArraysThatCannotBeReadInRowsAreRefused) {
    Grid z(3, 2);
    for (std::size_t k = 0; k < 6; ++k) z(k / 2, k % 2) = static_cast<double>(k);
    std::string npy = npy_grid(z);
    EXPECT_EQ(refused_stream("g.npy", npy), "none");
    EXPECT_EQ(refused_stream("g.npy", npy.substr(0, npy.size() - 1)), "npy.truncated");
    EXPECT_EQ(refused_stream("g.npy", npy.substr(0, 40)), "npy.header");
    std::string fortran = npy;
    fortran.replace(fortran.find("False"), 5, "True ");
    EXPECT_EQ(refused_stream("g.npy", fortran), "none");
    EXPECT_EQ(refused_stream("g.npy", fortran.substr(0, npy.size() - 1)), "npy.truncated");
    std::string flat = npy;
    flat.replace(flat.find("(3, 2)"), 6, "(6,)  ");
    EXPECT_EQ(refused_stream("g.npy", flat), "npy.shape");
    z(1, 1) = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refused_stream("g.npy", npy_grid(z)), "grid.cell");
    EXPECT_EQ(code_of([] { StoredBytes("no such file"); }), "file.missing");
    EXPECT_EQ(code_of([] { StoredBytes("/"); }), "file.directory");
}

}  // namespace
}  // namespace batten
