#include <gtest/gtest.h>

#include <string>

#include "batten/io/point_grid.hpp"
#include "batten/io/surface_file.hpp"
#include "errors.hpp"

namespace batten {
namespace point_grid_test {

PointGrid parsed(const std::string& text) { return parse_point_grid({"nodes.csv", text}); }

TEST(PointGridFile, TakesNodesByNameInAnyOrder) {
    const PointGrid grid = parsed("z,u,x,v,y\n9,1,4,5,6\n3,0,1,5,2\n30,0,10,2,20\n90,1,40,2,60\n");
    EXPECT_EQ(grid.u, (std::vector<double>{0, 1}));
    EXPECT_EQ(grid.v, (std::vector<double>{2, 5}));
    EXPECT_EQ(grid.nodes(0, 0, 0), 10);
    EXPECT_EQ(grid.nodes(0, 1, 2), 3);
    EXPECT_EQ(grid.nodes(1, 1, 1), 6);
    EXPECT_EQ(grid.nodes.missing(), 0u);
}

TEST(PointGridFile, LeavesNodesWithoutARowMissing) {
    const PointGrid grid = parsed("u,v,x,y,z\n0,0,1,2,3\n0,1,1,2,3\n1,0,1,2,3\n");
    EXPECT_EQ(grid.nodes.missing(), 1u);
    EXPECT_FALSE(grid.nodes.has(1, 1));
}

TEST(PointGridFile, TakesHeightsAsPoints) {
    const PointGrid grid = parsed(",0,1,3\n5,1,2,3\n6,4,,6\n");
    EXPECT_EQ(grid.nodes.nu(), 2u);
    EXPECT_EQ(grid.nodes.nv(), 3u);
    EXPECT_EQ(grid.nodes(1, 2, 0), 6);
    EXPECT_EQ(grid.nodes(1, 2, 1), 3);
    EXPECT_EQ(grid.nodes(1, 2, 2), 6);
    EXPECT_FALSE(grid.nodes.has(1, 1));
}

TEST(PointGridFile, RefusesTwoNodesInOnePlaceAndWhatIsNoNumber) {
    EXPECT_EQ(testing::code_of([] { parsed("u,v,x,y,z\n0,0,1,2,3\n0,0,1,2,3\n"); }),
              "grid.not-a-grid");
    EXPECT_EQ(testing::code_of([] { parsed("u,v,x,y,z\n0,0,1,two,3\n"); }), "table.not-a-number");
    EXPECT_EQ(testing::code_of([] { parsed("u,v,x,y,z\n0,0,1,nan,3\n"); }), "points.not-finite");
}

TEST(PointMesh, HasAVertexANodeAndAFaceACell) {
    Grid nodes(3, 2, 3);
    for (std::size_t i = 0; i < 3; ++i) nodes(i, 1, 1) = 1, nodes(i, 0, 0) = nodes(i, 1, 0) = double(i);
    const std::string obj = obj_mesh(nodes);
    EXPECT_EQ(obj, "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nf 1 3 4 2\nf 3 5 6 4\n");
    EXPECT_EQ(stl_mesh(nodes).size(), 84u + 4 * 50);
    EXPECT_NE(ply_mesh(nodes).find("element vertex 6\n"), std::string::npos);
}

}  // namespace point_grid_test
}  // namespace batten
