#include "batten/api/operation.hpp"
#include "batten/io/grid_file.hpp"
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
    EXPECT_EQ(refused("g.csv", "x,y\n0,1\n1,1\n", scattered), "table.unknown-column");
    EXPECT_EQ(refused("g.csv", "x,y,z\n0,1,2\n1,1,nan\n", scattered), "points.not-finite");
    EXPECT_EQ(refused("g.csv", "x,y,z\n0,1,2\n1,1,3\n", scattered), "fit.x-equal");
}

}  // namespace
}  // namespace batten
