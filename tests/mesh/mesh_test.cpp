#include <gtest/gtest.h>

#include <set>

#include "blocks.hpp"
#include "mesh/disjoint_sets.hpp"

namespace soft::mesh {
namespace {

TEST(Mesh, SharedFacetsAreNotOnTheBoundary) {
    EXPECT_EQ(boundary_facets(sample::row_of(CellType::hex27, 1)).size(), 6u);
    EXPECT_EQ(boundary_facets(sample::row_of(CellType::hex27, 3)).size(), 14u);
    EXPECT_EQ(boundary_facets(sample::row_of(CellType::quad9, 3)).size(), 8u);
}

TEST(Mesh, BoundaryFacetsAreInCellOrder) {
    const auto boundary = boundary_facets(sample::row_of(CellType::hex8, 4));
    EXPECT_TRUE(std::is_sorted(boundary.begin(), boundary.end()));
}

TEST(Mesh, FacetNodesAreGlobalNodeNumbers) {
    const Mesh mesh = sample::row_of(CellType::hex27, 2);
    for (const Facet& facet : boundary_facets(mesh)) {
        EXPECT_EQ(facet_type(mesh, facet), CellType::quad9);
        const auto nodes = facet_nodes(mesh, facet);
        ASSERT_EQ(nodes.size(), 9u);
        // The ninth node is the mean of the four corners.
        for (std::size_t d = 0; d < 3; ++d) {
            double mean = 0;
            for (std::size_t i = 0; i < 4; ++i) mean += 0.25 * mesh.point(nodes[i])[d];
            EXPECT_EQ(mesh.point(nodes[8])[d], mean);
        }
    }
}

TEST(DisjointSets, UniteGroupsUnderTheirSmallestObject) {
    DisjointSets groups(6);
    groups.unite(5, 3);
    groups.unite(1, 5);
    groups.unite(4, 4);
    const std::vector<std::size_t> expected{0, 1, 2, 1, 4, 1};
    for (std::size_t object = 0; object < expected.size(); ++object) EXPECT_EQ(groups.first(object), expected[object]);
}

TEST(Mesh, CellsKeepTheirNodesAndRegions) {
    Mesh mesh;
    mesh.points.resize(7);
    const std::array<Index, 3> triangle{4, 5, 6};
    const std::array<Index, 4> quad{0, 1, 2, 3};
    add_cell(mesh, CellType::triangle3, triangle, 1);
    add_cell(mesh, CellType::quad4, quad, 0);
    ASSERT_EQ(mesh.cell_count(), 2);
    EXPECT_TRUE(std::ranges::equal(mesh.cell_nodes(0), triangle));
    EXPECT_TRUE(std::ranges::equal(mesh.cell_nodes(1), quad));
    EXPECT_EQ(mesh.cell_regions, (std::vector<std::int32_t>{1, 0}));
}

}  // namespace
}  // namespace soft::mesh
