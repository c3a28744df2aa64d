#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "blocks.hpp"
#include "math/vector.hpp"

namespace soft::mesh {
namespace {

Vector3 operator-(const Vector3& a, const Vector3& b) { return difference(a, b); }

Vector3 mean(const CellTopology& cell, const std::vector<int>& nodes) {
    Vector3 sum{};
    for (const int n : nodes)
        for (std::size_t d = 0; d < 3; ++d) sum[d] += cell.nodes[n][d] / static_cast<double>(nodes.size());
    return sum;
}

std::vector<int> corners(const FacetTopology& facet) {
    return {facet.nodes.begin(), facet.nodes.begin() + topology(facet.type).vertex_count};
}

/// Vector area of a flat facet by its corners.
Vector3 area(const CellTopology& cell, const FacetTopology& facet) {
    const auto c = corners(facet);
    const auto p = [&](std::size_t i) { return cell.nodes[c[i]]; };
    if (c.size() == 2) {
        const Vector3 t = p(1) - p(0);
        return {t[1], -t[0], 0};
    }
    const Vector3 n = c.size() == 3 ? cross(p(1) - p(0), p(2) - p(0)) : cross(p(2) - p(0), p(3) - p(1));
    return {n[0] / 2, n[1] / 2, n[2] / 2};
}

class EveryCell : public testing::TestWithParam<CellType> {
protected:
    const CellTopology& cell = topology(GetParam());
};

TEST_P(EveryCell, IsFoundByItsVtkType) {
    EXPECT_EQ(cell.type, GetParam());
    EXPECT_EQ(cell_type_from_vtk(static_cast<int>(GetParam())), GetParam());
    EXPECT_EQ(static_cast<int>(cell.nodes.size()), cell.node_count);
    EXPECT_EQ(with_order(cell.type, cell.order), cell.type);
    const CellTopology& other = topology(with_order(cell.type, 3 - cell.order));
    EXPECT_EQ(other.shape, cell.shape);
    EXPECT_NE(other.order, cell.order);
}

TEST_P(EveryCell, FacetsPointOutOfTheCell) {
    std::vector<int> all(static_cast<std::size_t>(cell.vertex_count));
    for (int i = 0; i < cell.vertex_count; ++i) all[i] = i;
    for (const FacetTopology& facet : cell.facets)
        EXPECT_GT(dot(area(cell, facet), mean(cell, corners(facet)) - mean(cell, all)), 0);
}

TEST_P(EveryCell, FacetsCloseTheCell) {
    Vector3 sum{};
    double flux = 0;  // flux of x / dimension, which is the cell's volume
    for (const FacetTopology& facet : cell.facets) {
        const Vector3 a = area(cell, facet);
        for (std::size_t d = 0; d < 3; ++d) sum[d] += a[d];
        flux += dot(a, mean(cell, corners(facet))) / cell.dimension;
    }
    for (const double component : sum) EXPECT_NEAR(component, 0, 1e-14);
    switch (cell.shape) {
        case Shape::line: break;
        case Shape::triangle: EXPECT_NEAR(flux, 0.5, 1e-14); break;
        case Shape::quadrilateral: EXPECT_NEAR(flux, 4, 1e-14); break;
        case Shape::tetrahedron: EXPECT_NEAR(flux, 1.0 / 6, 1e-14); break;
        case Shape::hexahedron: EXPECT_NEAR(flux, 8, 1e-14); break;
        case Shape::wedge: EXPECT_NEAR(flux, 1, 1e-14); break;
    }
}

/// Interpolating the facet's corners to the reference nodes of the facet's type gives the facet's nodes.
TEST_P(EveryCell, FacetNodesFollowTheOrderOfTheFacetType) {
    for (const FacetTopology& facet : cell.facets) {
        const CellTopology& own = topology(facet.type);
        EXPECT_EQ(own.order, cell.order);
        const auto c = corners(facet);
        for (int n = 0; n < own.node_count; ++n) {
            const double u = own.nodes[n][0], v = own.nodes[n][1];
            std::vector<double> weight;
            if (c.size() == 2) weight = {(1 - u) / 2, (1 + u) / 2};
            if (c.size() == 3) weight = {1 - u - v, u, v};
            if (c.size() == 4)
                weight = {(1 - u) * (1 - v) / 4, (1 + u) * (1 - v) / 4, (1 + u) * (1 + v) / 4, (1 - u) * (1 + v) / 4};
            for (std::size_t d = 0; d < 3; ++d) {
                double position = 0;
                for (std::size_t i = 0; i < c.size(); ++i) position += weight[i] * cell.nodes[c[i]][d];
                EXPECT_EQ(cell.nodes[facet.nodes[n]][d], position) << cell.name << " node " << n;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(CellType, EveryCell, testing::ValuesIn(sample::all_types),
                         [](const auto& test) { return std::string{topology(test.param).name}; });

TEST(CellType, RejectsUnknownVtkTypes) {
    for (const int number : {0, 1, 14, 25, 33, 72, -1}) EXPECT_FALSE(cell_type_from_vtk(number)) << number;
}

/// Expected values from the class documentation of vtkTriQuadraticHexahedron, vtkBiQuadraticQuadraticWedge and vtkQuadraticTetra.
TEST(CellType, MidNodesFollowTheVtkOrder) {
    using Group = std::vector<int>;
    const auto expect = [](CellType type, int first, const std::vector<Group>& groups) {
        const CellTopology& cell = topology(type);
        for (std::size_t g = 0; g < groups.size(); ++g)
            EXPECT_EQ(cell.nodes[first + static_cast<int>(g)], mean(cell, groups[g])) << cell.name << " group " << g;
    };
    expect(CellType::triangle6, 3, {{0, 1}, {1, 2}, {2, 0}});
    expect(CellType::quad9, 4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}});
    expect(CellType::tet10, 4, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}});
    expect(CellType::hex27, 8,
           {{0, 1},
            {1, 2},
            {2, 3},
            {3, 0},
            {4, 5},
            {5, 6},
            {6, 7},
            {7, 4},
            {0, 4},
            {1, 5},
            {2, 6},
            {3, 7},
            {0, 3, 4, 7},
            {1, 2, 5, 6},
            {0, 1, 4, 5},
            {2, 3, 6, 7},
            {0, 1, 2, 3},
            {4, 5, 6, 7},
            {0, 1, 2, 3, 4, 5, 6, 7}});
    expect(CellType::wedge18, 6,
           {{0, 1},
            {1, 2},
            {2, 0},
            {3, 4},
            {4, 5},
            {5, 3},
            {0, 3},
            {1, 4},
            {2, 5},
            {0, 1, 3, 4},
            {1, 2, 4, 5},
            {2, 0, 5, 3}});
}

TEST(CellType, CornersRunCounterClockwiseSeenFromInside) {
    EXPECT_EQ(topology(CellType::hex27).nodes[0], (Vector3{-1, -1, -1}));
    EXPECT_EQ(topology(CellType::hex27).nodes[6], (Vector3{1, 1, 1}));
    EXPECT_EQ(topology(CellType::wedge18).nodes[2], (Vector3{0, 1, -1}));
    EXPECT_EQ(topology(CellType::wedge18).nodes[4], (Vector3{1, 0, 1}));
}

}  // namespace
}  // namespace soft::mesh
