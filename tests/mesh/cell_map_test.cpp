#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "blocks.hpp"
#include "mesh/cell_map.hpp"

namespace soft::mesh {
namespace {

/// A point inside every reference cell that is on no symmetry plane.
constexpr std::array<double, 3> somewhere{0.21, 0.33, 0.17};

class EveryMap : public testing::TestWithParam<CellType> {};

TEST_P(EveryMap, ShapeFunctionsAreOneAtTheirNodeAndZeroAtTheOthers) {
    const CellTopology& cell = topology(GetParam());
    for (int n = 0; n < cell.node_count; ++n) {
        const auto shapes = shape_values(cell.type, cell.nodes[n]);
        for (int a = 0; a < cell.node_count; ++a) EXPECT_NEAR(shapes[a].value, a == n ? 1 : 0, 1e-15);
    }
}

TEST_P(EveryMap, ShapeFunctionsReproducePolynomialsOfTheirOrder) {
    const CellTopology& cell = topology(GetParam());
    const auto field = [&](const std::array<double, 3>& x) {
        double f = 1, linear = 0;
        for (int d = 0; d < cell.dimension; ++d) linear += (0.7 + d) * x[d];
        f += linear;
        return cell.order == 2 ? f + linear * linear : f;
    };
    double value = 0;
    std::array<double, 3> gradient{};
    const auto shapes = shape_values(cell.type, somewhere);
    for (int a = 0; a < cell.node_count; ++a) {
        value += shapes[a].value * field(cell.nodes[a]);
        for (std::size_t d = 0; d < 3; ++d) gradient[d] += shapes[a].gradient[d] * field(cell.nodes[a]);
    }
    EXPECT_NEAR(value, field(somewhere), 1e-14);
    double linear = 0;
    for (int d = 0; d < cell.dimension; ++d) linear += (0.7 + d) * somewhere[d];
    for (int d = 0; d < cell.dimension; ++d)
        EXPECT_NEAR(gradient[d], (0.7 + d) * (cell.order == 2 ? 1 + 2 * linear : 1), 1e-13);
}

TEST_P(EveryMap, QuadratureIntegratesPolynomialsOfDegreeFive) {
    // x^5 over the reference cell, in closed form.
    double sum = 0, weights = 0;
    for (const QuadraturePoint& p : volume_rule(GetParam())) {
        sum += p.weight * std::pow(p.xi[0], 5);
        weights += p.weight;
    }
    switch (topology(GetParam()).shape) {
        case Shape::line:
            EXPECT_NEAR(weights, 2, 1e-14);
            EXPECT_NEAR(sum, 0, 1e-14);
            break;
        case Shape::quadrilateral:
            EXPECT_NEAR(weights, 4, 1e-14);
            EXPECT_NEAR(sum, 0, 1e-14);
            break;
        case Shape::hexahedron:
            EXPECT_NEAR(weights, 8, 1e-14);
            EXPECT_NEAR(sum, 0, 1e-14);
            break;
        case Shape::triangle:
            EXPECT_NEAR(weights, 0.5, 1e-14);
            EXPECT_NEAR(sum, 1.0 / 42, 1e-14);
            break;
        case Shape::wedge:
            EXPECT_NEAR(weights, 1, 1e-14);
            EXPECT_NEAR(sum, 1.0 / 21, 1e-14);
            break;
        case Shape::tetrahedron:
            EXPECT_NEAR(weights, 1.0 / 6, 1e-14);
            EXPECT_NEAR(sum, 1.0 / 336, 1e-14);
            break;
    }
}

TEST_P(EveryMap, MapsTheReferenceCellToItself) {
    const Mesh mesh = sample::reference_cell(GetParam());
    const CellMap map = map_cell(mesh, 0, shape_values(GetParam(), somewhere));
    EXPECT_NEAR(map.determinant, 1, 1e-14);
    for (int d = 0; d < topology(GetParam()).dimension; ++d) EXPECT_NEAR(map.position[d], somewhere[d], 1e-15);
}

INSTANTIATE_TEST_SUITE_P(CellMap, EveryMap, testing::ValuesIn(sample::all_types),
                         [](const auto& test) { return std::string{topology(test.param).name}; });

TEST(CellMap, RevolvedMeasureFollowsPappus) {
    Mesh mesh = sample::reference_cell(CellType::quad9);  // 2 x 2, moved to mean radius 5
    for (Point& p : mesh.points) p[1] += 5;
    EXPECT_NEAR(measure(mesh, Measure::plain), 4, 1e-13);
    EXPECT_NEAR(measure(mesh, Measure::revolved), 4 * 2 * std::numbers::pi * 5, 1e-12);
}

TEST(CellMap, FacetNormalsOfAShearedCellEncloseItsVolume) {
    for (const CellType type :
         {CellType::hex27, CellType::wedge18, CellType::tet10, CellType::quad9, CellType::triangle6}) {
        Mesh mesh = sample::reference_cell(type);
        for (Point& p : mesh.points) p = {2 * p[0] + 0.3 * p[1], 0.5 * p[1] + 0.1 * p[0] * p[0], p[2] + 0.2 * p[0]};
        double flux = 0;
        for (const Facet& facet : boundary_facets(mesh)) {
            const auto nodes = facet_nodes(mesh, facet);
            for (const QuadraturePoint& point : volume_rule(facet_type(mesh, facet))) {
                const auto shapes = shape_values(facet_type(mesh, facet), point.xi);
                const auto n = facet_normal(mesh, facet, shapes);
                for (std::size_t a = 0; a < nodes.size(); ++a)
                    for (std::size_t d = 0; d < 3; ++d)
                        flux += point.weight * shapes[a].value * mesh.point(nodes[a])[d] * n[d] / mesh.dimension;
            }
        }
        EXPECT_NEAR(flux, measure(mesh, Measure::plain), 1e-12) << topology(type).name;
    }
}

}  // namespace
}  // namespace soft::mesh
