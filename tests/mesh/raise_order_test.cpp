#include <gtest/gtest.h>

#include "mesh/cell_map.hpp"
#include "mesh/quality.hpp"
#include "mesh/raise_order.hpp"
#include "pieces.hpp"

namespace soft::mesh {
namespace {

TEST(RaiseOrder, AddsOneNodePerEdgeFaceAndCentre) {
    const Mesh plane = raise_order(sample::triangles_and_quadrilaterals());
    EXPECT_EQ(plane.points.size(), 6u + 8u + 1u);  // corners, edges, quadrilaterals
    // Edges: 12 of the cube, 5 more of each wedge beside it, 6 of the one on top; quadrilateral sides: 6, 2, 2 and 3.
    const Mesh first = sample::wedges_and_hexahedra();
    ASSERT_EQ(first.points.size(), 15u);
    EXPECT_EQ(raise_order(first).points.size(), 15u + 28u + 13u + 1u);
}

class Raised : public testing::TestWithParam<const char*> {
protected:
    static Mesh first_order(const std::string& name) {
        if (name == "plane") return sample::triangles_and_quadrilaterals();
        return name == "wedges" ? sample::wedges_and_hexahedra() : sample::tetrahedra();
    }
    const Mesh first = first_order(GetParam());
    const Mesh second = raise_order(first);
};

TEST_P(Raised, IsConformingWithStraightEdgesAndTheSameVolume) {
    sample::expect_conforming(second);
    EXPECT_NEAR(quality(second).min_scaled_jacobian, 1, 1e-12);
    EXPECT_NEAR(measure(second, Measure::plain), measure(first, Measure::plain), 1e-12);
    for (const CellType type : second.cell_types) EXPECT_EQ(topology(type).order, 2);
}

TEST_P(Raised, HasMidNodesAtTheMeanOfTheirCorners) {
    for (Index c = 0; c < second.cell_count(); ++c) {
        const CellTopology& cell = topology(second.cell_type(c));
        for (std::size_t n = 0; n < cell.nodes.size(); ++n) {
            const CellMap map = map_cell(first, c, shape_values(first.cell_type(c), cell.nodes[n]));
            for (std::size_t d = 0; d < 3; ++d)
                EXPECT_NEAR(second.point(second.cell_nodes(c)[n])[d], map.position[d], 1e-15);
        }
    }
}

TEST_P(Raised, KeepsNumbersRegionsAndSets) {
    EXPECT_TRUE(std::equal(first.points.begin(), first.points.end(), second.points.begin()));
    EXPECT_EQ(second.facet_sets, first.facet_sets);
    EXPECT_EQ(second.point_sets, first.point_sets);
    EXPECT_EQ(second.cell_regions, first.cell_regions);
    EXPECT_EQ(second.region_names, first.region_names);
}

TEST_P(Raised, IsTheOriginalMeshWhenLoweredAgain) {
    const Mesh back = lower_order(second);
    EXPECT_EQ(back.points, first.points);
    EXPECT_EQ(back.connectivity, first.connectivity);
    EXPECT_EQ(back.cell_types, first.cell_types);
    EXPECT_EQ(back.facet_sets, first.facet_sets);
}

TEST_P(Raised, DoesNotChangeWhenRaisedAgain) {
    const Mesh again = raise_order(second);
    EXPECT_EQ(again.points, second.points);
    EXPECT_EQ(again.connectivity, second.connectivity);
}

INSTANTIATE_TEST_SUITE_P(Mesh, Raised, testing::Values("plane", "wedges", "tetrahedra"));

TEST(RaiseOrder, ReusesMidNodesOfSecondOrderNeighbours) {
    Mesh mesh = sample::row_of(CellType::quad9, 2);
    mesh.cell_types[1] = CellType::quad4;
    const auto nodes = mesh.cell_nodes(1);
    const std::vector<Index> corners(nodes.begin(), nodes.begin() + 4);
    mesh.connectivity.resize(9);
    mesh.connectivity.insert(mesh.connectivity.end(), corners.begin(), corners.end());
    mesh.offsets = {0, 9, 13};
    const Mesh raised = raise_order(mesh);
    EXPECT_EQ(boundary_facets(raised).size(), 6u);
    EXPECT_EQ(facet_nodes(raised, {0, 1})[2], facet_nodes(raised, {1, 3})[2]);
}

TEST(LowerOrder, DropsMidNodesFromPointSets) {
    Mesh mesh = sample::reference_cell(CellType::triangle6);
    mesh.point_sets["all"] = {0, 1, 2, 3, 4, 5};
    EXPECT_EQ(lower_order(mesh).point_sets.at("all"), (std::vector<Index>{0, 1, 2}));
}

TEST(RaiseOrder, RaisesLines) {
    const Mesh line = raise_order(sample::row_of(CellType::line2, 2));
    EXPECT_EQ(line.points.size(), 5u);
    EXPECT_EQ(line.cell_type(1), CellType::line3);
}

}  // namespace
}  // namespace soft::mesh
