#include "mesh/single_layer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "mesh/split.hpp"

namespace soft::mesh {
namespace {

/// A strip of `along` x `through` unit cells. Its ends are in the sets "left" and "right", its lower side in "bottom".
Mesh strip(int along, int through) {
    Mesh mesh;
    mesh.dimension = 2;
    mesh.region_names = {"rubber"};
    const auto number = [&](int i, int j) { return static_cast<Index>(j * (along + 1) + i); };
    for (int j = 0; j <= through; ++j)
        for (int i = 0; i <= along; ++i) mesh.points.push_back({1.0 * i, 1.0 * j, 0});
    for (int j = 0; j < through; ++j)
        for (int i = 0; i < along; ++i) {
            const std::vector<Index> nodes{number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)};
            add_cell(mesh, CellType::quad4, nodes, 0);
        }
    for (const Facet& facet : boundary_facets(mesh)) {
        const auto nodes = facet_nodes(mesh, facet);
        const auto all_at = [&](std::size_t axis, double value) {
            return mesh.point(nodes[0])[axis] == value && mesh.point(nodes[1])[axis] == value;
        };
        if (all_at(0, 0)) mesh.facet_sets["left"].push_back(facet);
        if (all_at(0, along)) mesh.facet_sets["right"].push_back(facet);
        if (all_at(1, 0)) mesh.facet_sets["bottom"].push_back(facet);
    }
    return mesh;
}

const std::vector<std::string> nothing;

TEST(SingleLayer, FractionIsOneForOneCellThroughTheWallAndZeroForTwo) {
    EXPECT_EQ(single_layer_fraction(strip(8, 1), nothing), 1);
    EXPECT_EQ(single_layer_fraction(strip(8, 2), nothing), 0);
    EXPECT_EQ(single_layer_fraction(split_into_simplices(strip(8, 1)), nothing), 1);
}

TEST(SingleLayer, FractionIgnoresFacetsOnASymmetryPlane) {
    const std::vector<std::string> bottom{"bottom", "no such set"};
    EXPECT_EQ(single_layer_fraction(strip(8, 1), bottom), 0);  // the wall continues behind the plane: two cells
}

TEST(SingleLayer, FractionIsSmallForTwoLayersOfSimplices) {
    EXPECT_LT(single_layer_fraction(split_into_simplices(strip(20, 2)), nothing), 0.05);
}

}  // namespace
}  // namespace soft::mesh
